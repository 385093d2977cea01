// SPDX-License-Identifier: GPL-3.0-or-later
// The maker of the statements of one finding. Internal.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "corpus/report/boundary_faces.hpp"
#include "corpus/report/exact_measures.hpp"
#include "corpus/report/statements.hpp"

namespace tetproof::corpus {

/// Makes the statements of one finding. It has a member function for each kind of finding; the table in
/// statements.cpp says which.
class StatementMaker {
 public:
  using Face = std::array<Index, 3>;
  StatementMaker(const StatedMesh& judged, const verify::Finding& finding)
      : judged_(judged), mesh_(judged.mesh), finding_(finding), faces_(judged.mesh) {}

  void tet_volume();
  void duplicates();
  void face_shared();
  void face_orientation();
  void hanging_node();
  void crossed_diagonals();
  void crack();
  void near_contact();
  void self_intersection();
  void overlap();
  void interface();
  void missing_region() { region(true); }
  void excess_region() { region(false); }

  void off_surface_vertex();
  void mesh_to_surface();
  void surface_to_mesh();
  void volumes();
  void topology();
  void nonmanifold_edge();
  void nonmanifold_vertex();
  void no_such_point();
  void not_finite();
  void repeated_vertex();
  void same_place();
  void unused_point();
  void quote();

  std::vector<nlohmann::json> list_of_statements;
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
  nlohmann::json face_numbers() const {
    nlohmann::json result = nlohmann::json::array();
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
  static nlohmann::json texts(const std::array<Rational, 3>& weights) {
    return {text_of(weights[0]), text_of(weights[1]), text_of(weights[2])};
  }

  void add(const char* kind, std::string text, nlohmann::json values) {
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
  void mark_foreign_faces();
  void signs();
  void region(bool missing);
  void off_surface(const Face& face, const std::array<Rational, 3>& weights, const std::string& what);

  // Of a triangle's corners, its centroid and the point that the finding names, the one that is farthest from
  // the other triangles: a few simple weights.
  std::array<Rational, 3> farthest(const RationalTriangle& exact,
                                   const std::array<Eigen::Vector3d, 3>& corners,
                                   const std::vector<Eigen::Vector3d>& points,
                                   std::span<const Face> triangles) const;

  const StatedMesh& judged_;
  const TetMesh& mesh_;
  const verify::Finding& finding_;
  const BoundaryFaces faces_;
};

}  // namespace tetproof::corpus
