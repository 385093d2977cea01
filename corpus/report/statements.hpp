// SPDX-License-Identifier: GPL-3.0-or-later
// Exact statements about a mesh and a surface, which can be checked without this project. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "verify/report.hpp"

namespace tetproof::corpus {

/// What a statement is about, for the picture. Positions in the arrays of the mesh and the surface.
struct Marks {
  std::vector<Index> tets{}, vertices{};
  std::vector<std::array<Index, 3>> faces{};
  std::vector<Index> triangles{};  ///< of the surface
  std::vector<Eigen::Vector3d> points{};
  bool empty() const {
    return tets.empty() && vertices.empty() && faces.empty() && triangles.empty() && points.empty();
  }
};

/// Statements as corpus/findings/check.py reads them. Each has "kind", "text" (a sentence without its end)
/// and the values of its kind.
struct Statements {
  std::string headline{};  ///< what is wrong, without numbers: "a tetrahedron of negative volume"
  std::vector<nlohmann::json> list{};
  Marks marks{};
};

/// What the statements are made from. `numbering`: of the file that the statements are about.
struct StatedMesh {
  const TetMesh& mesh;
  const Numbering& numbering;
  const TriangleSurface& surface;
  const verify::Report& report;
};

/// What is wrong by the first finding of this check, the most telling statement first. A check of which
/// nothing can be said that is simple and exact gives a statement of the kind "report" with the judge's own
/// words, which check.py does not check.
Statements statements_of(const StatedMesh& judged, verify::Check root);

/// That the surface is closed, manifold, oriented and free of self-intersections, with its counts and volume;
/// or, if it is not, a statement of the kind "report" that says so.
nlohmann::json surface_statement(const TriangleSurface& surface);

}  // namespace tetproof::corpus
