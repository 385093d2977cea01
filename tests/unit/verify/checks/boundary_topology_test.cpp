// SPDX-License-Identifier: GPL-3.0-or-later
// The topology of the boundary: edges and vertices in which it touches itself, components, cavities, genus.
#include <gmock/gmock.h>

#include <functional>
#include <string>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;

TEST(PlantedDefects, NonManifoldEdgeAndVertex) {
  // Two cells that share only an edge, or only a vertex.
  const auto edge = lattice_mesh({2, 2, 1}, [](Cell c) { return c[0] == c[1]; });
  const Report at_edge = verify::verify(edge);
  EXPECT_EQ(roots(at_edge), Ids{"boundary-nonmanifold-edge"});
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].verdict, Verdict::warning);
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].count, 1);
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].findings[0].faces.size(), 4u);
  EXPECT_EQ(at_edge.certificate, true);
  EXPECT_EQ(at_edge.mesh.components, 2);
  EXPECT_EQ(at_edge.mesh.genus, 0);

  const auto vertex = lattice_mesh({2, 2, 2}, [](Cell c) { return c[0] == c[1] && c[1] == c[2]; });
  const Report at_vertex = verify::verify(vertex);
  EXPECT_EQ(roots(at_vertex), Ids{"boundary-nonmanifold-vertex"});
  EXPECT_EQ(at_vertex[Check::boundary_nonmanifold_vertex].findings[0].vertices,
            (std::vector<Index>{point_at(vertex, {1, 1, 1})}));
  EXPECT_EQ(at_vertex.certificate, true);
  EXPECT_EQ(at_vertex.mesh.components, 2);

  for (const TetMesh& mesh : {edge, vertex}) {
    const Report strict = verify::verify(mesh, {.strict_topology = true});
    EXPECT_FALSE(sound(strict));
    EXPECT_EQ(strict.certificate, true) << "a warning about topology says nothing against the triangulation";
  }
}

TEST(PlantedDefects, OneMaterialAroundANonManifoldEdge) {
  // Two opposite cells of the four around an edge, and a bridge above them: one component that touches itself
  // in an edge.
  const auto mesh = lattice_mesh({2, 2, 2}, [](Cell c) { return c[2] == 1 || c[0] == c[1]; });
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"boundary-nonmanifold-edge"});
  EXPECT_EQ(report.mesh.components, 1);
  EXPECT_EQ(report.mesh.genus, 0) << "cut apart at the edge it is a ball";
  EXPECT_EQ(report.certificate, true);
}

TEST(PlantedDefects, GenusAndCavities) {
  struct Shape {
    std::string name;
    std::function<bool(Cell)> keep;
    std::int64_t components, cavities, genus;
  };
  const std::vector<Shape> shapes{
      {"block", {}, 1, 0, 0},
      {"ring", [](Cell c) { return !(c[0] == 1 && c[1] == 1); }, 1, 0, 1},
      {"two holes crossing", [](Cell c) { return !((c[0] == 1 && c[1] == 1) || (c[1] == 1 && c[2] == 1)); },
       1, 0, 3},
      {"all three holes", [](Cell c) { return (c[0] == 1) + (c[1] == 1) + (c[2] == 1) < 2; }, 1, 0, 5},
      {"cavity", [](Cell c) { return !(c[0] == 1 && c[1] == 1 && c[2] == 1); }, 2, 1, 0},
      {"two blocks", [](Cell c) { return c[0] != 1; }, 2, 0, 0},
  };
  for (const Shape& s : shapes) {
    SCOPED_TRACE(s.name);
    const Report report = verify::verify(lattice_mesh({3, 3, 3}, s.keep));
    EXPECT_EQ(report.mesh.components, s.components);
    EXPECT_EQ(report.mesh.cavities, s.cavities);
    EXPECT_EQ(report.mesh.genus, s.genus);
    EXPECT_EQ(report.certificate, true);
  }
}

}  // namespace
}  // namespace tetproof::test
