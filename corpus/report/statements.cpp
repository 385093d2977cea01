// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "corpus/exact/exact_pairs.hpp"
#include "corpus/report/boundary_faces.hpp"
#include "corpus/report/exact_measures.hpp"
#include "corpus/truth.hpp"
#include "io/bytes/words.hpp"
#include "verify/findings_text.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

using nlohmann::json;
using verify::Check;
using verify::Finding;
using Face = std::array<Index, 3>;

// Makes the statements of one finding. A member function for each kind of finding; the table below says
// which.
class Maker {
 public:
  Maker(const StatedMesh& judged, const Finding& finding)
      : judged_(judged), mesh_(judged.mesh), finding_(finding), faces_(judged.mesh) {}

  void tet_volume() {
    const Index t = finding_.tets.front();
    if (!usable(t)) return no_such_point();
    const auto [a, b, c, d] = tet(t);
    const Rational volume = exact_volume(point(a), point(b), point(c), point(d));
    mark_tet(t);
    add("tet_volume", fmt::format("{} has volume {}", name(t), value_text(volume)),
        {{"tet", number(t)}, {"vertices", vertices_of(t)}, {"volume", text_of(volume)}});
    signs();
  }

  void duplicates() {
    const auto& tets = finding_.tets;
    const auto same = [&](auto key) {
      std::map<decltype(key(Index{})), Index> first;
      for (const Index t : tets)
        if (const auto [found, fresh] = first.emplace(key(t), t); !fresh)
          return std::optional(std::array{found->second, t});
      return std::optional<std::array<Index, 2>>();
    };
    const auto by_vertices = [&](Index t) {
      auto v = tet(t);
      std::sort(v.begin(), v.end());
      return v;
    };
    const auto by_places = [&](Index t) {
      std::array<std::array<double, 3>, 4> places;
      for (std::size_t k = 0; k < 4; ++k)
        places[k] = {point(tet(t)[k])[0], point(tet(t)[k])[1], point(tet(t)[k])[2]};
      std::sort(places.begin(), places.end());
      return places;
    };
    if (const auto pair = same(by_vertices)) {
      mark_tet((*pair)[0]);
      add("same_vertices",
          fmt::format("{} have the same four vertices ({})", names(*pair), list(vertices_of((*pair)[0]))),
          {{"tets", numbers(*pair)}, {"vertices", vertices_of((*pair)[0])}});
    } else if (const auto place = same(by_places)) {
      mark_tet((*place)[0]);
      add("same_places", fmt::format("the corners of {} have the same coordinates", names(*place)),
          {{"tets", numbers(*place)}});
    }
  }

  void face_shared() {
    const Face face = finding_.faces.front();
    const std::vector<Index>& tets = faces_.tets(face);
    for (const Index t : tets) mark_tet(t);
    marks.faces.push_back(face);
    add("face_tets",
        fmt::format("{} belongs to {} tetrahedra: {}", name(face), tets.size(), list(numbers(tets))),
        {{"face", vertex_numbers(face)}, {"tets", numbers(tets)}});
  }

  void face_orientation() {
    const Face face = finding_.faces.front();
    if (finding_.tets.size() != 2) return;
    std::vector<Index> apexes;
    int product = 1;
    for (const Index t : finding_.tets) {
      mark_tet(t);
      for (const Index v : tet(t))
        if (std::find(face.begin(), face.end(), v) == face.end()) {
          apexes.push_back(v);
          product *= orientation(point(face[0]), point(face[1]), point(face[2]), point(v));
        }
    }
    marks.faces.push_back(face);
    const json values{{"face", vertex_numbers(face)}, {"tets", numbers(finding_.tets)}};
    if (product > 0 && apexes.size() == 2) {
      json with_apexes = values;
      with_apexes["apexes"] = vertex_numbers(apexes);
      add("same_side",
          fmt::format("{} share {} and lie on the same side of it (their fourth vertices {} and {} do)",
                      names(finding_.tets), name(face), vertex(apexes[0]), vertex(apexes[1])),
          with_apexes);
    }
    add("same_order",
        fmt::format("{} name {} in the same direction: the orders of their vertices contradict each other",
                    names(finding_.tets), name(face)),
        values);
    signs();
  }

  void hanging_node() {
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

  void crossed_diagonals() {
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

  void crack() {
    if (finding_.faces.size() != 2) return;
    mark_faces();
    for (const Index v : finding_.vertices) marks.vertices.push_back(v);
    add("coinciding_faces",
        fmt::format(
            "{} of tetrahedra {} lie in the same place with different vertex numbers, so that neither "
            "is shared",
            face_list(), list(numbers(finding_.tets))),
        {{"faces", face_numbers()}, {"tets", numbers(finding_.tets)}});
  }

  void near_contact() {
    if (finding_.faces.size() != 2) return;
    const Rational distance = squared_distance(exact_triangle(mesh_.points, finding_.faces[0]),
                                               exact_triangle(mesh_.points, finding_.faces[1]));
    mark_faces();
    add("near_faces",
        fmt::format("{} of tetrahedra {} do not touch and are {} apart", face_list(),
                    list(numbers(finding_.tets)), distance_text(distance)),
        {{"faces", face_numbers()},
         {"tets", numbers(finding_.tets)},
         {"squared_distance", text_of(distance)}});
  }

  void self_intersection() {
    overlap();
    if (finding_.faces.size() != 2) return;
    mark_faces();
    add("faces_meet",
        fmt::format("{} of tetrahedra {}, none of which belongs to two tetrahedra, intersect", face_list(),
                    list(numbers(finding_.tets))),
        {{"faces", face_numbers()}, {"tets", numbers(finding_.tets)}});
  }

  void overlap() {
    if (finding_.tets.size() != 2 || !finding_.point) return;
    for (const Index t : finding_.tets) mark_tet(t);
    marks.points.push_back(*finding_.point);
    json values{{"tets", numbers(finding_.tets)}, {"point", json::array()}};
    const bool exact = !finding_.point_exact[0].empty();
    for (std::size_t k = 0; k < 3; ++k)
      values["point"].push_back(exact ? finding_.point_exact[k]
                                      : text_of(Rational((*finding_.point)[static_cast<int>(k)])));
    add("tets_overlap",
        fmt::format("{} overlap: a point near ({:.6g}, {:.6g}, {:.6g}) is strictly inside both",
                    names(finding_.tets), finding_.point->x(), finding_.point->y(), finding_.point->z()),
        values);
  }

  void interface() {
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

  void missing_region() { region(true); }
  void excess_region() { region(false); }

  void off_surface_vertex() {
    const Index v = finding_.vertices.front();
    for (const Face& face : faces_.boundary())
      if (const auto at = std::find(face.begin(), face.end(), v); at != face.end()) {
        std::array<Rational, 3> weights{0, 0, 0};
        weights[static_cast<std::size_t>(at - face.begin())] = 1;
        marks.vertices.push_back(v);
        return off_surface(face, weights, fmt::format("vertex {}", vertex(v)));
      }
  }

  void mesh_to_surface() {
    if (finding_.faces.empty()) return volumes();
    const Face& face = finding_.faces.front();
    if (faces_.tets(face).empty()) return volumes();
    const RationalTriangle corners = exact_triangle(mesh_.points, face);
    off_surface(face, farthest(corners, places(face), judged_.surface.vertices, judged_.surface.triangles),
                "a point");
    volumes();
  }

  void surface_to_mesh() {
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

  void volumes() {
    if (!all_usable()) return;
    const Rational mesh = exact_volume(mesh_), surface = exact_volume(judged_.surface);
    add("volumes",
        fmt::format("the mesh's volume is {}; the surface's volume is {}; the difference is {:.3g}",
                    value_text(mesh), value_text(surface), rounded(mesh - surface)),
        {{"mesh", text_of(mesh)}, {"surface", text_of(surface)}});
  }

  void topology() {
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

  void nonmanifold_edge() {
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

  void nonmanifold_vertex() {
    const Index v = finding_.vertices.front();
    const std::int64_t fans = fans_at(faces_.boundary(), v);
    marks.vertices.push_back(v);
    for (const Index t : finding_.tets) mark_tet(t);
    add("vertex_fans",
        fmt::format("the faces of the boundary at vertex {} form {} separate fans", vertex(v), fans),
        {{"vertex", vertex(v)}, {"count", fans}});
    topology();
  }

  void no_such_point() {
    for (const Index t : finding_.tets) {
      std::set<std::int64_t> missing;
      for (const Index v : tet(t))
        if (v < 0 || v >= static_cast<Index>(mesh_.points.size())) missing.insert(judged_.numbering.point(v));
      if (missing.empty()) continue;
      return add("no_such_point",
                 fmt::format("{} names {}, which the file does not have", name(t),
                             missing.size() == 1 ? fmt::format("vertex {}", *missing.begin())
                                                 : fmt::format("vertices {}", fmt::join(missing, " "))),
                 {{"tet", number(t)}, {"vertices", missing}});
    }
    if (usable(finding_.tets.front())) tet_volume();  // all numbers are shifted: some tetrahedra are negative
  }

  void not_finite() {
    const Index v = finding_.vertices.front();
    const Eigen::Vector3d& p = point(v);
    for (const Index t : finding_.tets) mark_tet(t);
    add("not_finite",
        fmt::format("vertex {}, which tetrahedra use, has the coordinates ({}, {}, {})", vertex(v), p.x(),
                    p.y(), p.z()),
        {{"vertex", vertex(v)}});
  }

  void repeated_vertex() {
    const Index t = finding_.tets.front();
    mark_tet(t);
    add("repeated_vertex", fmt::format("{} names a vertex twice", name(t)), {{"tet", number(t)}});
  }

  void same_place() {
    marks.vertices = finding_.vertices;
    add("same_place",
        fmt::format("vertices {} have the same coordinates", list(vertex_numbers(finding_.vertices))),
        {{"vertices", vertex_numbers(finding_.vertices)}});
  }

  void unused_point() {
    marks.vertices = finding_.vertices;
    add("unused_point", fmt::format("vertex {} belongs to no tetrahedron", vertex(finding_.vertices.front())),
        {{"vertex", vertex(finding_.vertices.front())}});
  }

  void quote() {
    for (const Index t : finding_.tets) mark_tet(t);
    mark_faces();
    const std::string said = verify::finding_text(finding_, judged_.numbering);
    add("report", fmt::format("the judge says: {}", said.substr(0, said.find('\n'))),
        {{"why", "these are the judge's words"}});
  }

  std::vector<json> list_of_statements;
  Marks marks;

 private:
  static constexpr std::size_t most_marked = 6;  // more would hide each other

  const std::array<Index, 4>& tet(Index t) const { return mesh_.tets[static_cast<std::size_t>(t)]; }
  const Eigen::Vector3d& point(Index v) const { return mesh_.points[static_cast<std::size_t>(v)]; }
  std::array<Eigen::Vector3d, 3> places(const Face& f) const {
    return {point(f[0]), point(f[1]), point(f[2])};
  }
  bool usable(Index t) const {
    return std::all_of(tet(t).begin(), tet(t).end(), [&](Index v) {
      return v >= 0 && v < static_cast<Index>(mesh_.points.size()) && point(v).allFinite();
    });
  }
  bool all_usable() const {
    for (Index t = 0; t < static_cast<Index>(mesh_.tets.size()); ++t)
      if (!usable(t)) return false;
    return true;
  }

  std::int64_t number(Index t) const { return judged_.numbering.tet(t); }
  std::int64_t vertex(Index v) const { return judged_.numbering.point(v); }
  std::vector<std::int64_t> numbers(const auto& tets) const {
    std::vector<std::int64_t> result;
    for (const Index t : tets) result.push_back(number(t));
    return result;
  }
  std::vector<std::int64_t> vertex_numbers(const auto& vertices) const {
    std::vector<std::int64_t> result;
    for (const Index v : vertices) result.push_back(vertex(v));
    return result;
  }
  std::vector<std::int64_t> vertices_of(Index t) const { return vertex_numbers(tet(t)); }
  json face_numbers() const {
    json result = json::array();
    for (const Face& face : finding_.faces) result.push_back(vertex_numbers(face));
    return result;
  }
  static std::string list(const auto& numbers) { return fmt::format("{}", fmt::join(numbers, " ")); }
  std::string name(Index t) const {
    return fmt::format("tetrahedron {} (vertices {})", number(t), list(vertices_of(t)));
  }
  std::string names(const auto& tets) const {
    return fmt::format("tetrahedra {} and {}", number(tets[0]), number(tets[1]));
  }
  std::string name(const Face& face) const {
    return fmt::format("the face ({})", list(vertex_numbers(face)));
  }
  std::string face_list() const {
    std::string text = "the faces ";
    for (std::size_t i = 0; i < finding_.faces.size(); ++i)
      text += fmt::format("{}({})",
                          i == 0                           ? ""
                          : i + 1 == finding_.faces.size() ? " and "
                                                           : ", ",
                          list(vertex_numbers(finding_.faces[i])));
    return text;
  }
  static std::string distance_text(const Rational& squared) {
    return squared == 0 ? "0"
                        : fmt::format("{:.6g} (squared, exactly {})", std::sqrt(rounded(squared)),
                                      short_text(squared));
  }
  static json texts(const std::array<Rational, 3>& weights) {
    return {text_of(weights[0]), text_of(weights[1]), text_of(weights[2])};
  }

  void add(const char* kind, std::string text, json values) {
    values["kind"] = kind;
    values["text"] = std::move(text);
    list_of_statements.push_back(std::move(values));
  }
  void mark_tet(Index t) {
    if (usable(t) && marks.tets.size() < most_marked &&
        std::find(marks.tets.begin(), marks.tets.end(), t) == marks.tets.end())
      marks.tets.push_back(t);
  }
  void mark_faces() {
    for (const Face& face : finding_.faces)
      if (marks.faces.size() < most_marked &&
          std::find(marks.faces.begin(), marks.faces.end(), face) == marks.faces.end())
        marks.faces.push_back(face);
  }

  // Faces of the boundary that are no triangles of the surface, the nearest to the finding's point.
  void mark_foreign_faces() {
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

  void signs() {
    if (!all_usable()) return;
    std::array<std::int64_t, 3> count{};  // negative, flat, positive
    for (const auto& [a, b, c, d] : mesh_.tets)
      ++count[static_cast<std::size_t>(1 + orientation(point(a), point(b), point(c), point(d)))];
    add("signs",
        fmt::format("of the {}, {} have positive, {} negative and {} zero volume",
                    io::counted(mesh_.tets.size(), "tetrahedra"), count[2], count[0], count[1]),
        {{"positive", count[2]}, {"negative", count[0]}, {"flat", count[1]}});
  }

  void region(bool missing) {
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

  void off_surface(const Face& face, const std::array<Rational, 3>& weights, const std::string& what) {
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

  // Of a triangle's corners, its centroid and the point that the finding names, the one that is farthest from
  // the other triangles: a few simple weights.
  std::array<Rational, 3> farthest(const RationalTriangle& exact,
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

  const StatedMesh& judged_;
  const TetMesh& mesh_;
  const Finding& finding_;
  const BoundaryFaces faces_;
};

struct Row {
  Check check;
  const char* headline;
  void (Maker::*make)();
};

constexpr Row rows[] = {
    {Check::index_range, "a tetrahedron names a vertex that does not exist", &Maker::no_such_point},
    {Check::finite_coordinates, "a vertex with coordinates that are not finite", &Maker::not_finite},
    {Check::repeated_vertex, "a tetrahedron names a vertex twice", &Maker::repeated_vertex},
    {Check::duplicate_point, "two vertices in one place", &Maker::same_place},
    {Check::unused_point, "a vertex of no tetrahedron", &Maker::unused_point},
    {Check::duplicate_tet, "the same tetrahedron twice", &Maker::duplicates},
    {Check::inverted, "a tetrahedron of negative volume", &Maker::tet_volume},
    {Check::flat, "a tetrahedron of volume zero", &Maker::tet_volume},
    {Check::face_shared_thrice, "a face of more than two tetrahedra", &Maker::face_shared},
    {Check::face_orientation, "two tetrahedra on the same side of their face", &Maker::face_orientation},
    {Check::hanging_node, "a vertex on a face that does not have it as a corner", &Maker::hanging_node},
    {Check::crossed_diagonal, "faces that do not match: crossed diagonals", &Maker::crossed_diagonals},
    {Check::crack, "a crack: two faces in one place with different vertices", &Maker::crack},
    {Check::non_conforming_interface, "parts that touch along faces that do not match", &Maker::interface},
    {Check::near_contact, "faces a hair apart", &Maker::near_contact},
    {Check::cavity, "a hole inside the mesh", &Maker::topology},
    {Check::boundary_nonmanifold_edge, "an edge with more than two boundary faces", &Maker::nonmanifold_edge},
    {Check::boundary_nonmanifold_vertex, "a vertex at which the boundary touches itself",
     &Maker::nonmanifold_vertex},
    {Check::boundary_self_intersection, "tetrahedra that overlap: the boundary intersects itself",
     &Maker::self_intersection},
    {Check::overlap, "tetrahedra that overlap", &Maker::overlap},
    {Check::bounding_box, "a mesh of another size or place than the surface", &Maker::volumes},
    {Check::missing_region, "a part of the solid without tetrahedra", &Maker::missing_region},
    {Check::excess_region, "tetrahedra outside of the solid", &Maker::excess_region},
    {Check::off_surface_vertex, "a boundary vertex off the surface", &Maker::off_surface_vertex},
    {Check::topology, "a boundary of another topology than the surface's", &Maker::topology},
    {Check::volume_surface, "a volume that is not the surface's", &Maker::volumes},
    {Check::volume_voxel, "a volume that is not the surface's", &Maker::volumes},
    {Check::mesh_to_surface, "a boundary that leaves the surface", &Maker::mesh_to_surface},
    {Check::surface_to_mesh, "a part of the surface that the mesh does not reach", &Maker::surface_to_mesh},
    {Check::normals, "a boundary face that looks away from the surface", &Maker::quote},
};
static_assert(std::size(rows) == verify::check_count);

}  // namespace

Statements statements_of(const StatedMesh& judged, Check root) {
  const Row& row =
      *std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return r.check == root; });
  Statements result{.headline = row.headline};
  const auto& findings = judged.report[root].findings;
  if (findings.empty()) return result;
  Maker maker(judged, findings.front());
  (maker.*row.make)();
  if (maker.list_of_statements.empty()) maker.quote();
  result.list = std::move(maker.list_of_statements);
  result.marks = std::move(maker.marks);
  return result;
}

json surface_statement(const TriangleSurface& surface) {
  const verify::SurfaceReport report = verify::judge_surface(surface);
  if (!report.fault.empty())
    return {{"kind", "report"},
            {"text", "surface.off, the surface as the mesher got it, is not valid: " + report.fault},
            {"why", "only valid surfaces are confirmed"}};
  const FaceCounts found = face_counts(surface.triangles);
  const Rational volume = exact_volume(surface);
  return {{"kind", "valid_surface"},
          {"text",
           fmt::format("surface.off is closed, manifold, oriented and free of self-intersections: {}, {}, "
                       "Euler characteristic {}, volume {}",
                       io::counted(surface.triangles.size(), "triangles"),
                       io::counted(found.components, "components"), found.euler, value_text(volume))},
          {"triangles", surface.triangles.size()},
          {"components", found.components},
          {"euler", found.euler},
          {"volume", text_of(volume)}};
}

}  // namespace tetproof::corpus
