// SPDX-License-Identifier: GPL-3.0-or-later
// Statements that compare the mesh with the surface: regions, distances, volumes, topology.
#include <set>

#include "corpus/report/statement_maker.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {

using nlohmann::json;

void StatementMaker::off_surface_vertex() {
  const Index v = finding_.vertices.front();
  for (const Face& face : faces_.boundary())
    if (const auto at = std::find(face.begin(), face.end(), v); at != face.end()) {
      std::array<Rational, 3> weights{0, 0, 0};
      weights[static_cast<std::size_t>(at - face.begin())] = 1;
      marks.vertices.push_back(v);
      return off_surface(face, weights, fmt::format("vertex {}", vertex(v)));
    }
}

void StatementMaker::mesh_to_surface() {
  if (finding_.faces.empty()) return volumes();
  const Face& face = finding_.faces.front();
  if (faces_.tets(face).empty()) return volumes();
  const RationalTriangle corners = exact_triangle(mesh_.points, face);
  off_surface(face, farthest(corners, places(face), judged_.surface.vertices, judged_.surface.triangles),
              "a point");
  volumes();
}

void StatementMaker::surface_to_mesh() {
  if (!finding_.point || faces_.boundary().empty()) return volumes();
  Index nearest = 0;
  double least = HUGE_VAL;
  const auto& surface = judged_.surface;
  const auto corners_of = [&](Index i) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] =
          surface.vertices[static_cast<std::size_t>(surface.triangles[static_cast<std::size_t>(i)][k])];
    return corners;
  };
  for (Index i = 0; i < static_cast<Index>(surface.triangles.size()); ++i) {
    const auto t = corners_of(i);
    const Eigen::Vector3d w = nearest_weights(*finding_.point, t);
    const double distance = (w[0] * t[0] + w[1] * t[1] + w[2] * t[2] - *finding_.point).stableNorm();
    if (distance < least) least = distance, nearest = i;
  }
  const Face& triangle = surface.triangles[static_cast<std::size_t>(nearest)];
  const RationalTriangle corners = exact_triangle(surface.vertices, triangle);
  const auto weights = farthest(corners, corners_of(nearest), mesh_.points, faces_.boundary());
  const Rational distance = squared_distance(weighted(corners, weights), mesh_.points, faces_.boundary());
  marks.triangles.push_back(nearest);
  marks.points.push_back(*finding_.point);
  add("off_mesh",
      fmt::format("a point of triangle {} ({}) of surface.off is {} from the boundary of the mesh", nearest,
                  list(triangle), distance_text(distance)),
      {{"triangle", nearest}, {"weights", texts(weights)}, {"squared_distance", text_of(distance)}});
  volumes();
}

void StatementMaker::volumes() {
  if (!all_usable()) return;
  const Rational mesh = exact_volume(mesh_), surface = exact_volume(judged_.surface);
  add("volumes",
      fmt::format("the mesh's volume is {}; the surface's volume is {}; the difference is {:.3g}",
                  value_text(mesh), value_text(surface), rounded(mesh - surface)),
      {{"mesh", text_of(mesh)}, {"surface", text_of(surface)}});
}

void StatementMaker::topology() {
  if (finding_.point) marks.points.push_back(*finding_.point);
  mark_faces();
  if (marks.faces.empty()) mark_foreign_faces();
  const FaceCounts mesh = face_counts(faces_.boundary()), surface = face_counts(judged_.surface.triangles);
  const auto values = [](const FaceCounts& c) {
    return json{{"components", c.components}, {"euler", c.euler}};
  };
  add("boundary_counts",
      fmt::format("the boundary of the mesh (faces of one tetrahedron) has {} and Euler characteristic {}; "
                  "the surface has {} and {}",
                  io::counted(mesh.components, "components"), mesh.euler,
                  io::counted(surface.components, "components"), surface.euler),
      {{"mesh", values(mesh)}, {"surface", values(surface)}});
  volumes();
}

void StatementMaker::mark_foreign_faces() {
  using Place = std::array<double, 3>;
  const auto key = [](std::array<Eigen::Vector3d, 3> corners) {
    std::array<Place, 3> result;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t x = 0; x < 3; ++x) result[k][x] = corners[k][static_cast<int>(x)];
    std::sort(result.begin(), result.end());
    return result;
  };
  std::set<std::array<Place, 3>> own;
  for (const Face& t : judged_.surface.triangles) {
    const auto at = [&](std::size_t k) { return judged_.surface.vertices[static_cast<std::size_t>(t[k])]; };
    own.insert(key({at(0), at(1), at(2)}));
  }
  std::vector<std::pair<double, Face>> found;
  for (const Face& face : faces_.boundary()) {
    const auto corners = places(face);
    if (own.contains(key(corners))) continue;
    const Eigen::Vector3d middle = corners[0] / 3 + corners[1] / 3 + corners[2] / 3;
    found.emplace_back(finding_.point ? (middle - *finding_.point).stableNorm() : 0, face);
  }
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < std::min(found.size(), 2 * most_marked); ++i)
    marks.faces.push_back(found[i].second);
}

void StatementMaker::region(bool missing) {
  if (!finding_.point || faces_.boundary().empty()) return volumes();
  const RationalPoint p = exact_point(*finding_.point);
  const Rational distance = missing
                                ? squared_distance(p, mesh_.points, faces_.boundary())
                                : squared_distance(p, judged_.surface.vertices, judged_.surface.triangles);
  marks.points.push_back(*finding_.point);
  for (const Index t : finding_.tets) mark_tet(t);
  mark_foreign_faces();
  const std::string place =
      fmt::format("the point ({}, {}, {})", finding_.point->x(), finding_.point->y(), finding_.point->z());
  add("region_point",
      missing ? fmt::format("{} is inside the surface and in no tetrahedron, {} from the nearest", place,
                            distance_text(distance))
              : fmt::format("{} is outside of the surface, {} from it, and inside of tetrahedron {}", place,
                            distance_text(distance), list(numbers(finding_.tets))),
      {{"point", {text_of(p[0]), text_of(p[1]), text_of(p[2])}},
       {"inside_surface", missing},
       {"tets", numbers(finding_.tets)},
       {"squared_distance", text_of(distance)}});
  volumes();
}

void StatementMaker::off_surface(const Face& face, const std::array<Rational, 3>& weights,
                                 const std::string& what) {
  const RationalPoint p = weighted(exact_triangle(mesh_.points, face), weights);
  const Rational distance = squared_distance(p, judged_.surface.vertices, judged_.surface.triangles);
  const Index t = faces_.tets(face).front();
  mark_tet(t);
  marks.faces.push_back(face);
  marks.points.push_back({rounded(p[0]), rounded(p[1]), rounded(p[2])});
  add("off_surface",
      fmt::format("{} of {}, a face of the boundary of tetrahedron {}, is {} from the surface", what,
                  name(face), number(t), distance_text(distance)),
      {{"face", vertex_numbers(face)},
       {"tets", {number(t)}},
       {"weights", texts(weights)},
       {"squared_distance", text_of(distance)}});
}

std::array<Rational, 3> StatementMaker::farthest(const RationalTriangle& exact,
                                                 const std::array<Eigen::Vector3d, 3>& corners,
                                                 const std::vector<Eigen::Vector3d>& points,
                                                 std::span<const Face> triangles) const {
  std::vector<std::array<Rational, 3>> proposals{
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {Rational(1, 3), Rational(1, 3), Rational(1, 3)}};
  if (finding_.point) {
    constexpr int parts = 1024;
    const Eigen::Vector3d w = nearest_weights(*finding_.point, corners);
    const auto a = static_cast<int>(std::lround(w[0] * parts)),
               b = std::min(static_cast<int>(std::lround(w[1] * parts)), parts - a);
    proposals.push_back({Rational(a, parts), Rational(b, parts), Rational(parts - a - b, parts)});
  }
  const auto distance = [&](const auto& weights) {
    return squared_distance(weighted(exact, weights), points, triangles);
  };
  std::array<Rational, 3> best = proposals[0];
  Rational most = distance(best);
  for (const auto& weights : proposals)
    if (const Rational d = distance(weights); d > most) most = d, best = weights;
  return best;
}

}  // namespace tetproof::corpus
