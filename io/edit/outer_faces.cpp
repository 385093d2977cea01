// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/outer_faces.hpp"

#include <tbb/parallel_sort.h>

#include <set>

namespace tetproof::io {
namespace {

Face triangle(Index a, Index b, Index c) {
  return Face(std::array{a, b, c}, 0);
}

// A quadrangle of one solid may be covered by two triangles of others: none of the three is outside.
void leave_out_halved(std::vector<Face>& faces, OuterCounts& counts) {
  std::set<std::size_t> inner;
  for (const Face& face : faces) {
    if (face.corners[3] == no_corner) continue;
    const Index a = face.corners[0], c = face.corners[face.opposite];
    const Index b = face.corners[face.opposite == 1 ? 2 : 1], d = face.corners[face.opposite == 3 ? 2 : 3];
    const std::array<std::array<Face, 2>, 2> halves{
        {{triangle(a, b, c), triangle(a, c, d)}, {triangle(a, b, d), triangle(b, c, d)}}};
    for (const auto& [first, second] : halves) {
      const auto one = find_face(faces, first), other = find_face(faces, second);
      if (one == faces.end() || other == faces.end() || inner.contains(one->id) || inner.contains(other->id))
        continue;
      inner.insert({face.id, one->id, other->id});
      ++counts.halved;
      break;
    }
  }
  if (!inner.empty()) std::erase_if(faces, [&](const Face& face) { return inner.contains(face.id); });
}

}  // namespace

void keep_outer_faces(std::vector<Face>& faces, OuterCounts& counts) {
  tbb::parallel_sort(faces.begin(), faces.end());
  std::vector<Face> outer;
  for (std::size_t i = 0, end; i < faces.size(); i = end) {
    for (end = i + 1; end < faces.size() && faces[end].corners == faces[i].corners;) ++end;
    if (end - i == 1) outer.push_back(faces[i]);
    counts.of_many += end - i > 2;
  }
  faces = std::move(outer);
  leave_out_halved(faces, counts);
}

}  // namespace tetproof::io
