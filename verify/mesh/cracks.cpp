// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/cracks.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <utility>

#include "verify/mesh/same_places.hpp"

namespace tetproof::verify {
namespace {

struct Record {
  std::array<Index, 3> places;  // ascending
  bool odd;                     // whether an odd permutation sorted them
  FaceId face;
};

bool differ(const std::array<Index, 4>& tet) {
  const auto [a, b, c, d] = tet;
  return a != b && a != c && a != d && b != c && b != d && c != d;
}

}  // namespace

Cracks find_cracks(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                   std::span<const FaceId> boundary, const std::vector<std::vector<Index>>& same_place) {
  Cracks result;
  if (same_place.empty()) return result;
  const SamePlaces places(mesh.points.size(), same_place);

  std::vector<Record> records;
  for (const FaceId face : boundary) {
    const auto vertices = vertices_of(mesh, face);
    if (std::none_of(vertices.begin(), vertices.end(), [&](Index v) { return places.shared[v]; })) continue;
    auto [a, b, c] =
        std::array{places.first[vertices[0]], places.first[vertices[1]], places.first[vertices[2]]};
    if (a == b || b == c || c == a) continue;  // a face without area is no crack
    bool odd = false;
    if (a > b) std::swap(a, b), odd = !odd;
    if (b > c) std::swap(b, c), odd = !odd;
    if (a > b) std::swap(a, b), odd = !odd;
    records.push_back({{a, b, c}, odd, face});
  }
  tbb::parallel_sort(records.begin(), records.end(), [](const Record& x, const Record& y) {
    return x.places != y.places ? x.places < y.places : x.face < y.face;
  });
  for (std::size_t i = 0, k; i < records.size(); i = k) {
    for (k = i; k < records.size() && records[k].places == records[i].places;) ++k;
    if (k - i == 2 && records[i].odd != records[i + 1].odd)
      result.pairs.push_back({records[i].face, records[i + 1].face});
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  if (result.pairs.empty()) return result;

  std::vector<std::uint8_t> cracked(mesh.points.size(), 0);  // points of cracked faces
  for (const auto& pair : result.pairs)
    for (const FaceId face : pair)
      for (const Index v : vertices_of(mesh, face)) cracked[v] = 1;
  TetMesh& closed = result.closed.emplace(mesh);
  for (std::size_t t = 0; t < closed.tets.size(); ++t) {
    if (!excluded.empty() && excluded[t]) continue;
    std::array<Index, 4> tet = closed.tets[t];
    for (Index& v : tet)
      if (cracked[v]) v = places.first[v];
    if (differ(tet)) closed.tets[t] = tet;  // otherwise it is flat and stays as it is
  }
  return result;
}

}  // namespace tetproof::verify
