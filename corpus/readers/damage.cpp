// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/damage.hpp"

#include <fmt/core.h>

namespace tetproof::corpus {

const std::vector<DamageKind>& damage_kinds() {
  static const std::vector<DamageKind> all = [] {
    std::vector<DamageKind> kinds;
    for (const auto& theme : {damage_to_bytes(), damage_to_numbers(), damage_to_structure()})
      kinds.insert(kinds.end(), theme.begin(), theme.end());
    return kinds;
  }();
  return all;
}

std::string list_damage_kinds() {
  std::string text;
  for (const DamageKind& kind : damage_kinds()) text += fmt::format("{:<18} {}\n", kind.id, kind.what);
  return text;
}

}  // namespace tetproof::corpus
