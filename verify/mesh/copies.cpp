// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/copies.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "verify/mesh/same_places.hpp"

namespace tetproof::verify {
namespace {

struct Record {
  std::array<Index, 4> places, numbers;  // ascending
  Index tet;
};

}  // namespace

std::vector<std::vector<Index>> find_copies(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                                            const std::vector<std::vector<Index>>& same_place) {
  std::vector<std::vector<Index>> copies;
  if (same_place.empty()) return copies;
  const SamePlaces places(mesh.points.size(), same_place);

  std::vector<Record> records;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    Record record{mesh.tets[t], mesh.tets[t], static_cast<Index>(t)};
    // Two copies differ in a number, and both numbers are of points in one place.
    if (std::none_of(record.numbers.begin(), record.numbers.end(), [&](Index v) { return places.shared[v]; }))
      continue;
    for (Index& v : record.places) v = places.first[v];
    std::sort(record.places.begin(), record.places.end());
    std::sort(record.numbers.begin(), record.numbers.end());
    if (std::adjacent_find(record.places.begin(), record.places.end()) != record.places.end())
      continue;  // it is flat, whatever else it is
    records.push_back(record);
  }
  tbb::parallel_sort(records.begin(), records.end(), [](const Record& a, const Record& b) {
    return std::tie(a.places, a.numbers, a.tet) < std::tie(b.places, b.numbers, b.tet);
  });
  for (std::size_t i = 0, k; i < records.size(); i = k) {
    std::vector<Index> same;
    for (k = i; k < records.size() && records[k].places == records[i].places; ++k)
      if (k == i || records[k].numbers != records[k - 1].numbers) same.push_back(records[k].tet);
    if (same.size() < 2) continue;
    std::sort(same.begin(), same.end());
    copies.push_back(std::move(same));
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}

}  // namespace tetproof::verify
