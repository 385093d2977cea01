// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and names in STL files that the reader and the writer share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetproof::io {

inline constexpr std::size_t stl_header_bytes = 84, stl_facet_bytes = 50;

/// A binary header, or the words behind `solid`, without the blanks and zeros around them.
std::string stl_title(std::string_view text);

/// The physical group of a solid; number 0: none.
struct StlGroup {
  std::string name;
  std::int64_t number = 0;
};

/// The groups of solids with these words behind `solid`. `wing #5` is group 5, called wing; `5` is group 5
/// without a name; `#0` is no group; `wing` is a group with the next free number from 1 on. If one solid only
/// has no words, it is no group; if several have none, each is a group.
std::vector<StlGroup> groups_of_solids(const std::vector<std::string>& lines);

/// The words behind `solid` from which `groups_of_solids` makes these groups again.
std::vector<std::string> lines_of_groups(const std::vector<StlGroup>& groups);

}  // namespace tetproof::io
