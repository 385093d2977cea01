// SPDX-License-Identifier: GPL-3.0-or-later
// What a strict conversion does not permit. Not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::program {

/// How much of a document a conversion may lose.
enum class Strictness {
  lax,     ///< anything, as long as it is said
  strict,  ///< nothing, in reading and in writing; elements that only our reader takes back count as lost
  native   ///< likewise, and all that is written must mean the same to other programs
};

/// What `strictness` does not permit: what is not read or lost; elements that only our reader takes back; and
/// under `native` everything else that only our reader takes back, be it kept aside or elements that name
/// nodes which do not exist.
struct Refusal {
  std::vector<Loss> not_read, lost, kept, dangling;

  Refusal(Strictness strictness, const std::vector<Loss>& dropped, const std::vector<Loss>& losses,
          const std::vector<Loss>& aside, const std::vector<Loss>& without_nodes);
  std::size_t items() const { return not_read.size() + lost.size() + kept.size() + dangling.size(); }

  /// "would be lost", "are not read or would stand in comments only, ...", ...
  std::string why(const std::string& kept_in) const;
};

}  // namespace tetproof::program
