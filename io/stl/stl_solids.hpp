// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and texts of STL that its reader and its writer agree on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetproof::io {

inline constexpr std::size_t stl_header_bytes = 84, stl_facet_bytes = 50;

/// What is left of a binary header or a solid's line without the blanks and zeros around it.
std::string stl_title(std::string_view text);

/// The physical group of a solid; number 0: none.
struct StlGroup {
  std::string name;
  std::int64_t number = 0;
};

/// The groups of solids with these words behind `solid`: `wing #5` is the group 5 called wing, `5` the group
/// 5 without a name, `#0` no group, `wing` a group with the next number, from 1 past those that are said. A
/// single solid without words is no group, several are one each.
std::vector<StlGroup> groups_of_solids(const std::vector<std::string>& lines);

/// The words for solids of these groups.
std::vector<std::string> lines_of_groups(const std::vector<StlGroup>& groups);

}  // namespace tetproof::io
