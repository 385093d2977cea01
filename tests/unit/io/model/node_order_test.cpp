// SPDX-License-Identifier: GPL-3.0-or-later
// Node orders, compared with the edges that the formats' manuals list. tests/programs/vtk_files.py tests how
// other programs see them.
#include "io/model/node_order.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

using Edge = std::array<int, 2>;
using Edges = std::vector<Edge>;

// Gmsh's reference manual, "Node ordering": the edges of the reference elements in order.
const Edges gmsh_tetrahedron{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}};
const Edges gmsh_hexahedron{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                            {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
const Edges gmsh_prism{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
const Edges gmsh_pyramid{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
// VTK's class documentation: vtkQuadraticTetra, vtkQuadraticHexahedron, vtkQuadraticWedge,
// vtkQuadraticPyramid.
const Edges vtk_tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
const Edges vtk_hexahedron{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                           {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
const Edges vtk_wedge{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
const Edges vtk_pyramid{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
// TetGen's manual, figure of the second-order tetrahedron. Numbers here start from 0.
const Edges tetgen_tetrahedron{{2, 3}, {0, 3}, {0, 1}, {1, 2}, {1, 3}, {0, 2}};

struct Case {
  const char* name;
  int type, corners;
  NodeOrder format;
  const Edges &gmsh, &other;
  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

class Order : public testing::TestWithParam<Case> {};

TEST_P(Order, PutsEachNodeOnItsEdge) {
  const Case& test = GetParam();
  const std::span<const int> order = node_order(test.type, test.format);
  const auto same = [](Edge a, Edge b) { return std::minmax(a[0], a[1]) == std::minmax(b[0], b[1]); };
  ASSERT_GE(order.size(), test.corners + test.gmsh.size());
  for (int k = 0; k < test.corners; ++k) EXPECT_EQ(order[static_cast<std::size_t>(k)], k);
  for (std::size_t e = 0; e < test.other.size(); ++e) {
    const auto at =
        static_cast<std::size_t>(order[static_cast<std::size_t>(test.corners) + e] - test.corners);
    ASSERT_LT(at, test.gmsh.size());
    EXPECT_TRUE(same(test.gmsh[at], test.other[e])) << "edge " << e;
  }
  std::vector<int> all(order.begin(), order.end());
  std::sort(all.begin(), all.end());
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k], static_cast<int>(k));
}

INSTANTIATE_TEST_SUITE_P(
    ByEdges, Order,
    testing::Values(Case{"VtkTetrahedron", 11, 4, NodeOrder::vtk, gmsh_tetrahedron, vtk_tetrahedron},
                    Case{"VtkHexahedron20", 17, 8, NodeOrder::vtk, gmsh_hexahedron, vtk_hexahedron},
                    Case{"VtkHexahedron27", 12, 8, NodeOrder::vtk, gmsh_hexahedron, vtk_hexahedron},
                    Case{"VtkWedge15", 18, 6, NodeOrder::vtk, gmsh_prism, vtk_wedge},
                    Case{"VtkWedge18", 13, 6, NodeOrder::vtk, gmsh_prism, vtk_wedge},
                    Case{"VtkPyramid13", 19, 5, NodeOrder::vtk, gmsh_pyramid, vtk_pyramid},
                    Case{"MeditTetrahedron", 11, 4, NodeOrder::medit, gmsh_tetrahedron, vtk_tetrahedron},
                    Case{"TetgenTetrahedron", 11, 4, NodeOrder::tetgen, gmsh_tetrahedron,
                         tetgen_tetrahedron}),
    [](const auto& test) { return std::string(test.param.name); });

// The face nodes of VTK's hexahedron of 27 nodes are on x-, x+, y-, y+, z-, z+, Gmsh's on z-, y-, x-, x+, y+,
// z+. The face nodes of VTK's wedge are on 0143, 1254, 2035, Gmsh's on 0143, 0352, 1254.
TEST(Order, PutsNodesOnTheirFaces) {
  const auto hexahedron = node_order(12, NodeOrder::vtk), wedge = node_order(13, NodeOrder::vtk);
  EXPECT_EQ(std::vector<int>(hexahedron.begin() + 20, hexahedron.end()),
            (std::vector<int>{22, 23, 21, 24, 20, 25, 26}));
  EXPECT_EQ(std::vector<int>(wedge.begin() + 15, wedge.end()), (std::vector<int>{15, 17, 16}));
}

TEST(Order, TurnsTheTrianglesOfVtksLinearWedge) {
  const auto order = node_order(6, NodeOrder::vtk);
  EXPECT_EQ(std::vector<int>(order.begin(), order.end()), (std::vector<int>{0, 2, 1, 3, 5, 4}));
}

TEST(Order, IsThatOfGmshForTheRest) {
  for (const int type : {1, 2, 3, 4, 5, 7, 8, 9, 10, 15, 16})
    EXPECT_TRUE(node_order(type, NodeOrder::vtk).empty()) << type;
}

TEST(OrderOfLattice, IsByThePlacesOfNodes) {
  // TetGen's order: node 4 is between 2 and 3, the next ones between 0 3, 0 1, 1 2, 1 3 and 0 2.
  const std::vector<std::int64_t> places{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 1, 1,
                                         1, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0};
  const auto tetgen = node_order(11, NodeOrder::tetgen);
  EXPECT_EQ(order_of_lattice(11, places), std::vector<int>(tetgen.begin(), tetgen.end()));
  EXPECT_EQ(order_of_lattice(8, {0, 2, 1}), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(order_of_lattice(8, {0, 1, 2}), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(order_of_lattice(10, {0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 0, 2, 1, 1, 2, 0, 1}),
            (std::vector<int>{0, 1, 2, 3, 8, 4, 5, 6, 7}));
  EXPECT_TRUE(order_of_lattice(8, {0, 2, 2}).empty());
  EXPECT_TRUE(order_of_lattice(8, {0, 2}).empty());
  EXPECT_TRUE(order_of_lattice(4, {}).empty());
}

// Checksums of the numbers with blanks between them. A script made them from the coordinates that Gmsh 4.8
// gives the nodes of a tetrahedron of each order, and from vtkLagrangeTetra::GetParametricCoords of VTK 9.1.
TEST(OrderOfTetrahedra, OfAllDegrees) {
  constexpr std::array<unsigned long, 9> expected{0xb30ad529, 0x75e2605b, 0x1ebaa387, 0x0d913e2b, 0x71b8ddf2,
                                                  0x9271cb1b, 0xeb97e90b, 0x450f965e, 0x300a31bd};
  for (int degree = 2; degree <= 10; ++degree) {
    const int type = complete_type(Shape::tetrahedron, degree);
    for (const int same : {type, bezier(type)}) {
      const std::string text = fmt::format("{}", fmt::join(node_order(same, NodeOrder::vtk), " "));
      EXPECT_EQ(::crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())),
                expected[static_cast<std::size_t>(degree) - 2])
          << degree;
    }
  }
  EXPECT_TRUE(node_order(complete_type(Shape::triangle, 7), NodeOrder::vtk).empty());
}

}  // namespace
}  // namespace tetproof::io
