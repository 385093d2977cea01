// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stl/stl_solids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "io/bytes/input_file.hpp"
#include "io/bytes/tokens.hpp"
#include "io/surface/group_names.hpp"

namespace tetproof::io {
namespace {

struct Said {
  std::string name;
  std::optional<std::int64_t> number;
};

Said said(const std::string& line) {
  if (const auto number = group_number(line)) return {"", number};
  if (line == "#0") return {"", 0};
  const std::size_t mark = line.rfind(" #");
  if (mark != line.npos && mark > 0)
    if (const auto number = group_number(line.substr(mark + 2)))
      return {decode_name(line.substr(0, mark)), number};
  return {decode_name(line), {}};
}

}  // namespace

std::string stl_title(std::string_view text) {
  constexpr std::string_view blank("\0 \t\r\n\v\f", 7);
  const std::size_t first = text.find_first_not_of(blank);
  return first == text.npos ? "" : std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

std::vector<StlGroup> groups_of_solids(const std::vector<std::string>& lines) {
  const bool alone = std::count(lines.begin(), lines.end(), "") == 1;
  std::vector<Said> all;
  std::set<std::int64_t> taken;
  for (const std::string& line : lines) {
    all.push_back(said(line));
    if (all.back().number) taken.insert(*all.back().number);
  }
  std::vector<StlGroup> groups;
  std::int64_t next = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty() && alone) all[i].number = 0;
    if (!all[i].number) {
      do ++next;
      while (taken.count(next));
      all[i].number = next;
    }
    groups.push_back({all[i].name, *all[i].number});
  }
  return groups;
}

std::vector<std::string> lines_of_groups(const std::vector<StlGroup>& groups) {
  std::vector<std::string> lines;
  for (const StlGroup& group : groups)
    lines.push_back(group.number == 0    ? ""
                    : group.name.empty() ? fmt::format("{}", group.number)
                                         : encode_name(group.name, true));
  const std::vector<StlGroup> read = groups_of_solids(lines);
  const bool same = std::equal(
      read.begin(), read.end(), groups.begin(),
      [](const StlGroup& a, const StlGroup& b) { return a.number == b.number && a.name == b.name; });
  if (same) return lines;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (groups[i].number == 0)
      lines[i] = "#0";
    else if (!groups[i].name.empty())
      lines[i] += fmt::format(" #{}", groups[i].number);
  return lines;
}

}  // namespace tetproof::io
