// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/edges.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "verify/triangles/disjoint_sets.hpp"

namespace tetproof::verify {
namespace {

template <class T>
void append(std::vector<T>& list, std::vector<T>& more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

Side next(Side s) {
  return s % 3 == 2 ? s - 2 : s + 1;
}

}  // namespace

EdgeMatching match_edges(std::span<const Triangle> triangles, std::size_t vertices,
                         const std::vector<std::uint8_t>& excluded) {
  const auto sides = static_cast<Side>(3 * triangles.size());
  const auto skipped = [&](Side s) { return !excluded.empty() && excluded[static_cast<std::size_t>(s / 3)]; };
  struct Record {
    Index high;
    Side side;
  };
  std::vector<Side> start(vertices + 1, 0);
  for (Side s = 0; s < sides; ++s)
    if (!skipped(s)) ++start[std::min(from(triangles, s), to(triangles, s)) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Record> records(static_cast<std::size_t>(start.back()));
  {
    std::vector<Side> place(start.begin(), start.end() - 1);
    for (Side s = 0; s < sides; ++s) {
      if (skipped(s)) continue;
      const auto [low, high] = std::minmax({from(triangles, s), to(triangles, s)});
      records[place[low]++] = {high, s};
    }
  }
  EdgeMatching result;
  result.mate.assign(static_cast<std::size_t>(sides), no_side);
  // Matches the sides whose lower vertex is `low`.
  const auto match = [&](std::size_t low, EdgeMatching& found) {
    const auto first = records.begin() + start[low], last = records.begin() + start[low + 1];
    std::sort(first, last, [](const Record& a, const Record& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    for (auto i = first; i < last;) {
      auto j = i + 1;
      while (j < last && j->high == i->high) ++j;
      if (j - i == 1) {
        found.open.push_back(i->side);
      } else if (j - i == 2) {
        result.mate[i[0].side] = i[1].side;
        result.mate[i[1].side] = i[0].side;
        if (from(triangles, i[0].side) == from(triangles, i[1].side))
          found.same_direction.push_back({i[0].side, i[1].side});
      } else {
        std::vector<Side>& edge = found.nonmanifold.emplace_back();
        for (auto k = i; k < j; ++k) edge.push_back(k->side);
      }
      i = j;
    }
  };
  constexpr std::size_t piece = 4096;  // vertices
  std::vector<EdgeMatching> parts((vertices + piece - 1) / piece);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    for (std::size_t low = p * piece; low < std::min(vertices, (p + 1) * piece); ++low) match(low, parts[p]);
  });
  for (EdgeMatching& part : parts) {
    append(result.open, part.open);
    append(result.same_direction, part.same_direction);
    append(result.nonmanifold, part.nonmanifold);
  }
  return result;
}

Sheets find_sheets(std::span<const Triangle> triangles, const std::vector<Side>& mate,
                   const std::vector<std::uint8_t>& excluded) {
  DisjointSets sheet_of(triangles.size()), fan_of(3 * triangles.size());
  for (Side s = 0; s < static_cast<Side>(mate.size()); ++s) {
    const Side other = mate[s];
    if (other < s) continue;  // it has no mate, or the mate has been here already
    sheet_of.unite(s / 3, other / 3);
    const bool opposite = from(triangles, s) == to(triangles, other);
    fan_of.unite(s, opposite ? next(other) : other);
    fan_of.unite(next(s), opposite ? other : next(other));
  }
  Sheets result;
  result.of_triangle.assign(triangles.size(), -1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    const auto root = static_cast<std::size_t>(sheet_of.find(static_cast<Index>(t)));
    if (root == t) {
      result.of_triangle[t] = static_cast<Index>(result.sheets.size());
      result.sheets.push_back({.first_triangle = static_cast<Index>(t)});
    }
    // The representative is the lowest member, so it already has its sheet.
    result.of_triangle[t] = result.of_triangle[root];
    Sheet& sheet = result.sheets[result.of_triangle[t]];
    ++sheet.triangles;
    for (Side s = static_cast<Side>(3 * t); s < static_cast<Side>(3 * t + 3); ++s) {
      sheet.open_sides += mate[s] == no_side;
      if (fan_of.find(s) != s) continue;
      ++sheet.vertices;
      result.vertices_of_fans.push_back(from(triangles, s));
    }
  }
  std::sort(result.vertices_of_fans.begin(), result.vertices_of_fans.end());
  return result;
}

std::vector<Index> repeated(const std::vector<Index>& ascending) {
  std::vector<Index> several;
  for (std::size_t i = 1; i < ascending.size(); ++i)
    if (ascending[i] == ascending[i - 1] && (several.empty() || several.back() != ascending[i]))
      several.push_back(ascending[i]);
  return several;
}

}  // namespace tetproof::verify
