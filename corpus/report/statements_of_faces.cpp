// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about faces that do not match, touch or intersect, and about edges and vertices of the boundary.
#include <optional>

#include "corpus/exact/exact_pairs.hpp"
#include "corpus/report/statement_maker.hpp"

namespace tetproof::corpus {

using nlohmann::json;

void StatementMaker::face_shared() {
  const Face face = finding_.faces.front();
  const std::vector<Index>& tets = faces_.tets(face);
  for (const Index t : tets) mark_tet(t);
  marks.faces.push_back(face);
  add("face_tets",
      fmt::format("{} belongs to {} tetrahedra: {}", name(face), tets.size(), list(numbers(tets))),
      {{"face", vertex_numbers(face)}, {"tets", numbers(tets)}});
}

void StatementMaker::hanging_node() {
  const Index v = finding_.vertices.front();
  std::optional<Rational> least;
  Face nearest{};
  for (const Face& face : finding_.faces) {
    if (std::find(face.begin(), face.end(), v) != face.end() || faces_.tets(face).size() != 1) continue;
    const Rational distance = squared_distance(exact_point(point(v)), exact_triangle(mesh_.points, face));
    if (least && *least <= distance) continue;
    least = distance;
    nearest = face;
  }
  if (!least) return;
  const Index t = faces_.tets(nearest).front();
  mark_tet(t);
  marks.faces.push_back(nearest);
  marks.vertices.push_back(v);
  add("vertex_on_face",
      *least == 0
          ? fmt::format("vertex {} lies exactly on {}, is no corner of it, and {} alone has this face",
                        vertex(v), name(nearest), name(t))
          : fmt::format(
                "vertex {} lies on {} but for rounding ({} off), is no corner of it, and {} alone has "
                "this face",
                vertex(v), name(nearest), distance_text(*least), name(t)),
      {{"vertex", vertex(v)},
       {"face", vertex_numbers(nearest)},
       {"tets", {number(t)}},
       {"squared_distance", text_of(*least)}});
}

void StatementMaker::crossed_diagonals() {
  const auto& v = finding_.vertices;
  if (v.size() != 4 || finding_.faces.size() != 4) return;
  Rational volume = exact_volume(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
  if (volume < 0) volume = -volume;
  mark_faces();
  add("crossed_diagonals",
      fmt::format("the four vertices {} have two pairs of faces, along one diagonal and along the other: "
                  "{}, none of which belongs to two tetrahedra; the volume between them is {}",
                  list(vertex_numbers(v)), face_list(), value_text(volume)),
      {{"vertices", vertex_numbers(v)},
       {"faces", face_numbers()},
       {"tets", numbers(finding_.tets)},
       {"volume", text_of(volume)}});
}

void StatementMaker::crack() {
  if (finding_.faces.size() != 2) return;
  mark_faces();
  for (const Index v : finding_.vertices) marks.vertices.push_back(v);
  add("coinciding_faces",
      fmt::format("{} of tetrahedra {} lie in the same place with different vertex numbers, so that neither "
                  "is shared",
                  face_list(), list(numbers(finding_.tets))),
      {{"faces", face_numbers()}, {"tets", numbers(finding_.tets)}});
}

void StatementMaker::near_contact() {
  if (finding_.faces.size() != 2) return;
  const Rational distance = squared_distance(exact_triangle(mesh_.points, finding_.faces[0]),
                                             exact_triangle(mesh_.points, finding_.faces[1]));
  mark_faces();
  add("near_faces",
      fmt::format("{} of tetrahedra {} do not touch and are {} apart", face_list(),
                  list(numbers(finding_.tets)), distance_text(distance)),
      {{"faces", face_numbers()}, {"tets", numbers(finding_.tets)}, {"squared_distance", text_of(distance)}});
}

void StatementMaker::self_intersection() {
  overlap();
  if (finding_.faces.size() != 2) return;
  mark_faces();
  add("faces_meet",
      fmt::format("{} of tetrahedra {}, none of which belongs to two tetrahedra, intersect", face_list(),
                  list(numbers(finding_.tets))),
      {{"faces", face_numbers()}, {"tets", numbers(finding_.tets)}});
}

void StatementMaker::interface() {
  for (std::size_t i = 0; i < finding_.faces.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Face &one = finding_.faces[k], &other = finding_.faces[i];
      if (!partly_on_each_other(places(one), places(other))) continue;
      const std::array tets{faces_.tets(one).front(), faces_.tets(other).front()};
      marks.faces = {one, other};
      for (const Index t : tets) mark_tet(t);
      add("faces_meet",
          fmt::format("{} and {} of tetrahedra {} lie partly on each other and do not match", name(one),
                      name(other), list(numbers(tets))),
          {{"faces", {vertex_numbers(one), vertex_numbers(other)}}, {"tets", numbers(tets)}});
      return;
    }
}

void StatementMaker::nonmanifold_edge() {
  if (finding_.vertices.size() != 2) return;
  mark_faces();
  const auto& edge = finding_.vertices;
  std::int64_t found = 0;
  for (const Face& face : faces_.boundary())
    found += std::count(face.begin(), face.end(), edge[0]) * std::count(face.begin(), face.end(), edge[1]);
  add("edge_faces",
      fmt::format("the edge {} {} has {} faces of the boundary (faces of one tetrahedron)", vertex(edge[0]),
                  vertex(edge[1]), found),
      {{"edge", vertex_numbers(edge)}, {"count", found}});
  topology();
}

void StatementMaker::nonmanifold_vertex() {
  const Index v = finding_.vertices.front();
  const std::int64_t fans = fans_at(faces_.boundary(), v);
  marks.vertices.push_back(v);
  for (const Index t : finding_.tets) mark_tet(t);
  add("vertex_fans",
      fmt::format("the faces of the boundary at vertex {} form {} separate fans", vertex(v), fans),
      {{"vertex", vertex(v)}, {"count", fans}});
  topology();
}

}  // namespace tetproof::corpus
