// SPDX-License-Identifier: GPL-3.0-or-later
// The ways in which a file is damaged, or made odd.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/generators/random.hpp"

namespace tetproof::corpus {

struct DamageKind {
  const char* id;
  const char* what;  ///< for users
  /// Changes the bytes and says what was done: "cut off at byte 17 of 300". Absent: this kind does not apply
  /// to them, for example no XML is there to nest.
  std::optional<std::string> (*apply)(std::string& bytes, Random& random);
};

/// All kinds.
const std::vector<DamageKind>& damage_kinds();
/// A text for users.
std::string list_damage_kinds();

// The themes; `damage_kinds` joins them.
std::vector<DamageKind> damage_to_bytes();
std::vector<DamageKind> damage_to_numbers();
std::vector<DamageKind> damage_to_structure();

}  // namespace tetproof::corpus
