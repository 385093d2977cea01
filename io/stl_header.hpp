// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and texts of STL that its reader and its writer agree on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/obj_names.hpp"

namespace tetproof::io {

inline constexpr std::size_t stl_header_bytes = 84, stl_facet_bytes = 50;

/// What is left of a binary header or a solid's name without the blanks and zeros around it.
inline std::string stl_title(std::string_view text) {
  constexpr std::string_view blank("\0 \t\r\n\v\f", 7);
  const std::size_t first = text.find_first_not_of(blank);
  return first == text.npos ? "" : std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

/// The physical groups of solids with these names, 0 for none. A whole number is the group with this number;
/// the others are numbered from 1 past those. A single one without a name is no group.
inline std::vector<std::int64_t> groups_of_solids(const std::vector<std::string>& names) {
  const bool nameless = std::count(names.begin(), names.end(), "") > 1;
  std::set<std::int64_t> taken;
  for (const std::string& name : names)
    if (const auto number = group_number(name)) taken.insert(*number);
  std::vector<std::int64_t> groups;
  std::int64_t next = 0;
  for (const std::string& name : names)
    if (const auto number = group_number(name)) {
      groups.push_back(*number);
    } else if (name.empty() && !nameless) {
      groups.push_back(0);
    } else {
      do ++next;
      while (taken.count(next));
      groups.push_back(next);
    }
  return groups;
}

}  // namespace tetproof::io
