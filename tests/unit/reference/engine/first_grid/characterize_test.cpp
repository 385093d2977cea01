// SPDX-License-Identifier: GPL-3.0-or-later
// Steps (ii) and (iii) against brute force in rational arithmetic, on surfaces that deliberately hit the
// lattice and on random ones.
#include <gtest/gtest.h>

#include "corpus/surfaces.hpp"
#include "reference/engine/first_grid/contacts.hpp"
#include "reference/engine/first_grid/indicators.hpp"
#include "reference/engine/first_grid/inside.hpp"
#include "tests/support/exact_surface.hpp"

namespace tetproof::reference {
namespace {

using exact_mesh::exact;
using exact_mesh::Point;
using exact_mesh::Rational;

struct Example {
  const char* name;
  const char* spec;
  std::array<int, 3> cells;
  double box_scale;
  int least_on_surface;  // at least so many lattice vertices lie on the surface
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

// A body of 2 or 4 cells in a box scaled by 2, with 4 or 8 cells, has its faces exactly in lattice planes.
const Example examples[] = {
    {"CubeInLatticePlanes", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", {8, 8, 8}, 2, 98},
    {"CubeBesideLatticePlanes", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", {6, 6, 6}, 1.5, 1},
    {"CubeHalfACellOff", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", {5, 5, 5}, 1.25, 0},
    {"FineCubeInLatticePlanes", "box:x0=0,x1=2,y0=0,y1=2,z0=0,z1=2,n=3", {4, 4, 4}, 2, 26},
    {"OctahedronOnLatticePoints", "octahedron", {4, 4, 4}, 2, 6},
    {"OctahedronOnLatticeEdges", "octahedron", {5, 5, 5}, 1.5, 0},
    {"GrooveOneCellWide", "groove:m=4,width=1,depth=2", {8, 8, 8}, 2, 90},
    {"Terrain", "terrain:m=4,seed=3", {8, 8, 8}, 2, 70},
    {"ThinShell", "hollow:m=4,wall=0.25", {8, 8, 8}, 2, 98},
    {"ThinShellOff", "hollow:m=4,wall=0.3", {7, 7, 7}, 1.3, 0},
    {"TwoBodies", "pair:m=2,gap=0.5", {9, 5, 5}, 1.25, 0},
    {"CoarseSphere", "sphere:r=1,n=100", {6, 5, 7}, 1.2, 0},
    {"Shells", "shells:n=200", {5, 5, 5}, 1.2, 0},
    {"RandomStar", "random:seed=5,n=200", {5, 6, 5}, 1.1, 0},
    {"VerySmallTerrain", "terrain:m=4,seed=3", {8, 8, 8}, 2, 70, Eigen::Vector3d::Constant(0x1p-290)},
    {"VeryLargeTerrain", "terrain:m=4,seed=3", {8, 8, 8}, 2, 70, Eigen::Vector3d::Constant(0x1p290)},
    // The area of its projection along x is a subnormal double, with only a few digits.
    {"NeedleOfRandomStar", "random:seed=5,n=60", {4, 4, 4}, 1.1, 0, {1, 0x1p-536, 0x1p-536}},
};

class Classification : public testing::TestWithParam<Example> {
 protected:
  void SetUp() override {
    surface = corpus::make_surface(GetParam().spec);
    for (Eigen::Vector3d& v : surface.vertices) v = v.cwiseProduct(GetParam().scale);
    if (surface.triangles.size() > 3000)
      GTEST_FAIL() << "too large for brute force: " << surface.triangles.size();
    lattice = make_lattice(surface, GetParam().cells, GetParam().box_scale);
    contacts = find_contacts(lattice, surface);
    truth.emplace(surface);
  }
  TriangleSurface surface;
  Lattice lattice;
  Contacts contacts;
  std::optional<exact_surface::Surface> truth;
};

TEST_P(Classification, IndicatorsAreExact) {
  const auto indicators =
      initial_indicators(inside_by_parity(lattice, surface), contacts.on_surface, {}, Region::inside);
  int on_surface = 0;
  for (Vertex v = 0; v < lattice.vertices(); ++v) {
    const int expected = truth->locate(lattice.point(v));
    ASSERT_EQ(indicators[v], expected) << "vertex " << v << " at " << lattice.point(v).transpose();
    on_surface += expected == 0;
  }
  EXPECT_GE(on_surface, GetParam().least_on_surface);
}

TEST_P(Classification, EdgeIntersectionsAreCountedExactly) {
  const auto found = intersect_edges(lattice, surface, contacts, [](Edge) { return true; });
  std::map<Edge, const EdgeIntersections*> by_edge;
  for (const EdgeIntersections& e : found) by_edge[e.edge] = &e;
  EXPECT_EQ(by_edge.size(), found.size());
  for (Vertex low = 0; low < lattice.vertices(); ++low)
    for (int direction = 1; direction < 8; ++direction) {
      const auto at = lattice.position(low);
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
        inside = inside && at[axis] + (direction >> axis & 1) <= lattice.cells[axis];
      if (!inside) continue;
      const Edge edge = Edge{low} * 8 + direction;
      const Point a = exact(lattice.point(low)), b = exact(lattice.point(lattice.high(edge)));
      const auto expected = truth->points_on(lattice.point(low), lattice.point(lattice.high(edge)));
      const auto here = by_edge.find(edge);
      ASSERT_EQ(here == by_edge.end() ? 0 : here->second->count, static_cast<int>(expected.size()))
          << "edge " << edge;
      if (expected.empty()) continue;
      const double length = (lattice.point(lattice.high(edge)) - lattice.point(low)).norm();
      const auto distance = [&](const Eigen::Vector3d& point, const Rational& t) {
        Eigen::Vector3d off;
        for (int x = 0; x < 3; ++x)
          off[x] = Rational(a[x] + t * (b[x] - a[x]) - Rational(point[x])).convert_to<double>();
        return off.norm();
      };
      EXPECT_LT(distance(here->second->nearest_low, expected.front()), 1e-12 * length) << "edge " << edge;
      EXPECT_LT(distance(here->second->nearest_high, expected.back()), 1e-12 * length) << "edge " << edge;
    }
}

TEST_P(Classification, PointsOfTheInsideTest) {
  const InsideTest inside(lattice, surface);
  std::uint64_t state = 12345;
  const auto draw = [&](int n) {
    return static_cast<int>((state = state * 6364136223846793005u + 1442695040888963407u) >> 33) % n;
  };
  for (int trial = 0; trial < 300; ++trial) {
    // Lattice points, midpoints of edges and centroids of lattice tetrahedra, to be on the surface as often
    // as possible.
    const Eigen::Vector3d a =
        lattice.point(draw(lattice.cells[0]), draw(lattice.cells[1]), draw(lattice.cells[2]));
    const Eigen::Vector3d h = lattice.point(1, 1, 1) - lattice.point(0, 0, 0);
    const Eigen::Vector3d p = a + h.cwiseProduct(Eigen::Vector3d(draw(5), draw(5), draw(5)) / 4);
    EXPECT_EQ(inside(p), truth->locate(p)) << p.transpose();
  }
}

TEST_P(Classification, NearVerticesAreThoseWithinTheRadius) {
  const double radius = 0.3 * lattice.shortest_edge, size = GetParam().scale.maxCoeff();
  if (!std::isnormal(radius * radius)) GTEST_SKIP() << "doubles cannot hold squared distances of this size";
  const auto near = find_near_vertices(lattice, surface, radius, [](Vertex) { return true; });
  std::map<Vertex, NearVertex> by_vertex;
  for (const NearVertex& n : near) by_vertex[n.vertex] = n;
  EXPECT_EQ(by_vertex.size(), near.size());
  for (Vertex v = 0; v < lattice.vertices(); ++v) {
    double best = HUGE_VAL;
    for (const auto& [a, b, c] : surface.triangles)
      best = std::min(best, (closest_point({surface.vertices[a], surface.vertices[b], surface.vertices[c]},
                                           lattice.point(v)) -
                             lattice.point(v))
                                .squaredNorm());
    const auto at = by_vertex.find(v);
    ASSERT_EQ(at != by_vertex.end(), best < radius * radius) << v;
    if (at != by_vertex.end()) {
      EXPECT_LE(std::abs(at->second.squared_distance - best), 1e-28 * size * size) << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Classification, testing::ValuesIn(examples),
                         [](const auto& each) { return each.param.name; });

TEST(ClosestPoint, EveryRegionOfATriangle) {
  const std::array<Eigen::Vector3d, 3> t{Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {0, 4, 0}};
  const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> cases{
      {{1, 1, 3}, {1, 1, 0}},  {{-1, -2, 5}, {0, 0, 0}}, {{6, -1, 0}, {4, 0, 0}}, {{-1, 7, 2}, {0, 4, 0}},
      {{2, -3, 1}, {2, 0, 0}}, {{-2, 1, 0}, {0, 1, 0}},  {{4, 4, -1}, {2, 2, 0}}, {{1, 2, 0}, {1, 2, 0}}};
  for (const auto& [p, expected] : cases)
    for (const auto& order : {std::array{0, 1, 2}, {1, 2, 0}, {2, 1, 0}})
      for (const double scale : {1.0, 0x1p-290, 0x1p290})
        EXPECT_EQ(closest_point({scale * t[order[0]], scale * t[order[1]], scale * t[order[2]]}, scale * p),
                  scale * expected)
            << p.transpose() << " times " << scale;
}

// Table 3 on a single edge: a lattice of one cell, with indicators and points given by hand.
struct Table3Case {
  const char* name;
  std::int8_t low, high;
  int count;
  bool settled_low;
  std::int8_t new_low, new_high;
  const char* row;  // nullptr: Table 3 does not apply
  int cuts;
};

TEST(Table3Applied, EachRow) {
  const Table3Case cases[] = {
      {"two points between outside and outside", -1, -1, 2, false, -1, -1, "1", 0},
      {"a point between outside and surface", -1, 0, 1, false, -1, -1, "2", 0},
      {"one point between outside and inside", -1, 1, 1, false, -1, 1, nullptr, 1},
      {"three points between outside and inside", -1, 1, 3, false, -1, 1, "3b", 1},
      {"two points, an odd number of crossings", -1, 1, 2, false, -1, 1, "3b", 1},
      {"a point between surface and surface", 0, 0, 1, false, 1, 1, "4", 0},
      {"a point between surface and inside", 0, 1, 1, false, 1, 1, "5", 0},
      {"two points between inside and inside", 1, 1, 2, false, 1, 1, "6", 0},
      {"a settled vertex takes no request", 0, 1, 1, true, 0, 1, nullptr, 0},
      {"a settled vertex makes no request", 0, 0, 2, true, 0, 0, nullptr, 0},
  };
  Lattice lattice{{1, 1, 1}, {{{0, 1}, {0, 1}, {0, 1}}}, 1};
  for (const Table3Case& one : cases) {
    std::vector<std::int8_t> initial(8, one.high == 1 ? 1 : -1);  // the rest agrees with the edge 0-1
    initial[0] = one.low;
    initial[1] = one.high;
    SurfaceVertices settled;
    if (one.settled_low) settled.add({{0, 0, lattice.point(0)}});
    const EdgeIntersections met{1, one.count, {0.25, 0, 0}, {0.75, 0, 0}};
    const Indicators result = characterize(lattice, initial, {met}, settled);
    EXPECT_EQ(result.sign[0], one.new_low) << one.name;
    EXPECT_EQ(result.sign[1], one.new_high) << one.name;
    for (std::size_t r = 0; r < tables::table3.size(); ++r)
      EXPECT_EQ(result.table3[r], one.row && tables::table3[r].name == one.row ? 1 : 0)
          << one.name << " row " << tables::table3[r].name;
    ASSERT_EQ(static_cast<int>(result.cuts.points.size()), one.cuts) << one.name;
    if (one.cuts) {
      EXPECT_EQ(result.cuts.points[0].x(), 0.25) << one.name << ": the point closest to the exterior end";
    }
  }
}

TEST(Table3Applied, TheExteriorEndMayBeTheHigherNumber) {
  Lattice lattice{{1, 1, 1}, {{{0, 1}, {0, 1}, {0, 1}}}, 1};
  std::vector<std::int8_t> initial(8, -1);
  initial[0] = 1;
  const Indicators result = characterize(lattice, initial, {{1, 3, {0.25, 0, 0}, {0.75, 0, 0}}}, {});
  ASSERT_EQ(result.cuts.points.size(), 1u);
  EXPECT_EQ(result.cuts.points[0].x(), 0.75);
  EXPECT_EQ(result.cuts.find(1), 0);
  EXPECT_EQ(result.cuts.find(2), -1);
}

TEST(Table3Applied, AskedForBothSignsBecomesExterior) {
  Lattice lattice{{1, 1, 1}, {{{0, 1}, {0, 1}, {0, 1}}}, 1};
  std::vector<std::int8_t> initial{0, -1, 1, 1, 1, 1, 1, 1};
  const Eigen::Vector3d p(0.5, 0, 0);
  const Indicators result =
      characterize(lattice, initial, {{1, 1, p, p}, {2, 1, p, p}}, {});  // 0-1: row 2, 0-2: row 5
  EXPECT_EQ(result.sign[0], -1);
  // Edge 0-2 is then between -1 and +1, and its cut is the exterior end itself, which was 0 (readings D6,
  // D7).
  EXPECT_EQ(result.cuts.points.size(), 0u);
}

TEST(InitialIndicators, OutsideExchangesTheWords) {
  EXPECT_EQ(initial_indicators({1, -1, 1, -1}, {2}, {}, Region::inside),
            (std::vector<std::int8_t>{1, -1, 0, -1}));
  EXPECT_EQ(initial_indicators({1, -1, 1, -1}, {2}, {}, Region::outside),
            (std::vector<std::int8_t>{-1, 1, 0, 1}));
}

TEST(InsideByParity, RefusesAnOpenSurface) {
  TriangleSurface open = corpus::make_surface("sphere:r=1,n=100");
  const Lattice lattice = make_lattice(open, {12, 12, 12}, 1.2);
  std::erase_if(open.triangles, [&](const auto& t) { return open.vertices[t[0]].x() > 0.3; });
  EXPECT_THROW(inside_by_parity(lattice, open), std::logic_error);
}

}  // namespace
}  // namespace tetproof::reference
