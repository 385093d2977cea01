// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/second/table2.hpp"

#include <sstream>

namespace tetproof::second {
namespace {

// "2 14 c": v2, p14, the centroid.
Name name(const std::string& text) {
  Name result;
  for (const char c : text)
    if (c != 'c') result.push_back(c - '0');
  return result;
}

std::vector<NamedTet> row(const std::string& text) {
  std::vector<NamedTet> tets;
  std::istringstream words(text);
  std::array<std::string, 4> w;
  while (words >> w[0] >> w[1] >> w[2] >> w[3]) {
    tets.push_back({name(w[0]), name(w[1]), name(w[2]), name(w[3])});
    words >> w[0];  // the bar between two tetrahedra
  }
  return tets;
}

}  // namespace

std::string table1(const std::string& indicators) {
  static const std::map<std::string, std::string> cases{
      {"----", "1"},  {"0---", "2"},  {"00--", "3"},  {"000-", "4"},  {"0000", "5"},
      {"+---", "6"},  {"+0--", "7"},  {"+00-", "8"},  {"+000", "9"},  {"++--", "10"},
      {"++0-", "11"}, {"+++-", "12"}, {"+++0", "13"}, {"++++", "14"}, {"++00", "E8"}};
  return cases.at(indicators);
}

const std::map<std::string, std::vector<NamedTet>>& table2() {
  static const std::map<std::string, std::vector<NamedTet>> rows{
      {"1", {}},
      {"2", {}},
      {"3", {}},
      {"4", {}},
      {"5", row("1 2 3 4")},
      {"6", row("1 12 13 14")},
      {"7", row("1 2 13 14")},
      {"8", row("1 2 3 14")},
      {"9", row("1 2 3 4")},
      {"10a", row("1 2 13 14 | 2 13 14 24 | 2 13 23 24")},
      {"10b", row("1 2 13 24 | 1 13 14 24 | 2 13 23 24")},
      {"10c", row("1 2 14 23 | 1 13 14 23 | 2 14 23 24")},
      {"10d", row("1 2 23 24 | 1 13 14 24 | 1 13 23 24")},
      {"11a", row("1 2 3 14 | 2 3 14 24")},
      {"11b", row("1 2 3 24 | 1 3 14 24")},
      {"12a", row("1 2 3 34 | 1 2 14 34 | 2 14 24 34")},  // E1: the page has (1,2,3,14), (1,2,"p3",34)
      {"12b", row("1 2 3 14 | 2 3 14 24 | 3 14 24 34")},
      {"12c", row("1 2 3 14 | 2 3 14 34 | 2 14 24 34")},
      {"12d", row("1 2 3 24 | 1 3 14 24 | 3 14 24 34")},
      {"12e", row("1 2 3 24 | 1 3 24 34 | 1 14 24 34")},
      {"12f", row("1 2 3 34 | 1 2 24 34 | 1 14 24 34")},
      // E2: the two that the page tries to spell out below the table, each as the two triangles, then the
      // halves of the quadrilaterals between v1 v2, v2 v3 and v1 v3.
      {"12g",
       row("1 2 3 c | 14 24 34 c | 1 2 24 c | 1 14 24 c | 2 3 34 c | 2 24 34 c | 1 3 14 c | 3 14 34 c")},
      {"12h",
       row("1 2 3 c | 14 24 34 c | 1 2 14 c | 2 14 24 c | 2 3 24 c | 3 24 34 c | 1 3 34 c | 1 14 34 c")},
      {"13", row("1 2 3 4")},
      {"14", row("1 2 3 4")},
      {"E8", row("1 2 3 4")}};
  return rows;
}

}  // namespace tetproof::second
