// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a plane through a grid: its polygons fill the cross-section of the domain once, wherever the
// plane is. Also the outline of the surface, and planes as text.
#include "reference/figure/plane_cut.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/generate.hpp"
#include "tests/unit/reference/figure/sections.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using test::block;
using test::section_area;

double area(const CutPolygon& polygon) {
  Vector3d twice = Vector3d::Zero();
  for (int i = 1; i + 1 < polygon.corners; ++i)
    twice += (polygon.points[i] - polygon.points[0]).cross(polygon.points[i + 1] - polygon.points[0]);
  return twice.norm() / 2;
}
double area(const PlaneCut& cut) {
  double sum = 0;
  for (const CutPolygon& polygon : cut.polygons) sum += area(polygon);
  return sum;
}

using Key = std::array<double, 3>;
Key key(const Vector3d& point) {
  return {point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};
}

// Polygons meet edge to edge: each edge belongs to one or two polygons, and the edges that belong to one form
// closed loops.
void expect_conforming(const PlaneCut& cut) {
  std::map<std::set<Key>, int> edges;
  for (const CutPolygon& polygon : cut.polygons)
    for (int i = 0; i < polygon.corners; ++i)
      ++edges[{key(polygon.points[i]), key(polygon.points[(i + 1) % polygon.corners])}];
  std::map<Key, int> ends;
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(edge.size(), 2u);
    ASSERT_LE(count, 2);
    if (count == 1)
      for (const Key& end : edge) ++ends[end];
  }
  for (const auto& [end, count] : ends) ASSERT_EQ(count % 2, 0);
}

TEST(PlaneCut, FillsTheCubesSectionWhereverThePlaneRuns) {
  const TriangleSurface none;
  for (const int n : {1, 2, 3, 5}) {
    const TetMesh mesh = block(n);
    for (int axis = 0; axis < 3; ++axis)
      // Through cells, through lattice planes, and through the cube's own faces.
      for (const double value :
           {0.1, 0.5, 1.0 / 3, 1.0 / 5, 2.0 / 5, 0.0, 1.0, 1e-300, std::nextafter(1.0, 0)}) {
        const PlaneCut section = cut(mesh, none, {Vector3d::Unit(axis), value});
        EXPECT_NEAR(area(section), 1, 1e-14) << n << " cells, axis " << axis << " at " << value;
        if (value != 1e-300 && value != std::nextafter(1.0, 0))
          expect_conforming(section);  // at those two values corners coincide
        for (const CutPolygon& polygon : section.polygons)
          for (int i = 0; i < polygon.corners; ++i) EXPECT_EQ(polygon.points[i][axis], value);
      }
    for (const double value : {-0.1, 1.1, std::nextafter(1.0, 2), std::nextafter(0.0, -1)})
      EXPECT_TRUE(cut(mesh, none, {Vector3d::UnitX(), value}).polygons.empty());
    // Oblique planes: a regular hexagon, a triangle, the diagonal plane (a lattice plane of the split), a
    // corner.
    const Vector3d ones(1, 1, 1);
    EXPECT_NEAR(area(cut(mesh, none, {ones, 1.5})), 0.75 * std::sqrt(3), 1e-14);
    EXPECT_NEAR(area(cut(mesh, none, {ones, 1})), 0.5 * std::sqrt(3), 1e-14);
    EXPECT_NEAR(area(cut(mesh, none, {Vector3d(1, -1, 0), 0})), std::sqrt(2), 1e-14);
    EXPECT_NEAR(area(cut(mesh, none, {Vector3d(2, -2, 0), 0})), std::sqrt(2), 1e-14);
    EXPECT_EQ(area(cut(mesh, none, {ones, 0})), 0);
  }
}

TEST(PlaneCut, FillsTheSectionOfAGrid) {
  for (const Region region : {Region::inside, Region::outside})
    for (const char* name : {"sphere:r=1,n=500", "torus:R=1,r=0.4,n=800", "random:seed=5,n=500"}) {
      const TriangleSurface surface = corpus::open_surface(name);
      const Generation made =
          generate(surface, {.region = region, .cells = {12, 0, 0}, .adapt = AdaptOptions{}});
      for (int axis = 0; axis < 3; ++axis)
        for (const double value : {0.0123, -0.31, 0.27}) {
          const PlaneCut section = cut(made.mesh(), surface, {Vector3d::Unit(axis), value});
          const double expected = section_area(made.mesh(), axis, value);
          EXPECT_GT(expected, 0.1);
          EXPECT_NEAR(area(section), expected, 1e-12) << name << ", axis " << axis << " at " << value;
          expect_conforming(section);
        }
      // In a lattice plane the area is that of a plane close by.
      for (int axis = 0; axis < 3; ++axis) {
        const auto& planes = made.lattice.planes[axis];
        const double value = planes[planes.size() / 2];
        const PlaneCut section = cut(made.mesh(), surface, {Vector3d::Unit(axis), value});
        EXPECT_NEAR(area(section), section_area(made.mesh(), axis, value + 1e-9), 1e-7)
            << name << ", axis " << axis;
        for (const CutPolygon& polygon : section.polygons)
          for (int i = 0; i < polygon.corners; ++i) EXPECT_EQ(polygon.points[i][axis], value);
      }
    }
}

TEST(PlaneCut, ATetrahedronInEveryPosition) {
  const TetMesh mesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tets = {{0, 1, 2, 3}}};
  const TriangleSurface none;
  const auto corners = [&](const Vector3d& normal, double offset) {
    const PlaneCut section = cut(mesh, none, {normal, offset});
    return section.polygons.empty() ? 0 : section.polygons.at(0).corners;
  };
  EXPECT_EQ(corners({0, 0, 1}, 0.5), 3);   // one vertex on one side
  EXPECT_EQ(corners({1, 1, 0}, 0.5), 4);   // two vertices on each side
  EXPECT_EQ(corners({0, 0, 1}, 1), 0);     // touches one vertex
  EXPECT_EQ(corners({1, 0, 1}, 0), 0);     // touches one edge
  EXPECT_EQ(corners({0, 0, 1}, 0), 3);     // contains a face
  EXPECT_EQ(corners({1, -1, 0}, 0), 3);    // contains an edge
  EXPECT_EQ(corners({1, -0.5, 0}, 0), 3);  // contains an edge
  EXPECT_EQ(corners({1, 2, -1}, 0), 3);    // contains a vertex; one is on one side, two on the other
  EXPECT_EQ(corners({1, 1, 1}, 2), 0);
}

TEST(PlaneCut, AFaceInThePlaneIsDrawnOnceForTheNegativeSide) {
  TetMesh mesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
               .tets = {{0, 1, 2, 3}, {0, 2, 1, 4}}};
  const Plane plane{Vector3d::UnitZ(), 0};
  PlaneCut section = cut(mesh, {}, plane);
  ASSERT_EQ(section.polygons.size(), 1u);
  EXPECT_EQ(section.polygons[0].tet, 1);
  std::swap(mesh.tets[0], mesh.tets[1]);
  EXPECT_EQ(cut(mesh, {}, plane).polygons.at(0).tet, 0);
  mesh.tets.erase(mesh.tets.begin());
  EXPECT_EQ(cut(mesh, {}, plane).polygons.at(0).tet, 0);  // only the one above is left
}

double length(const PlaneCut& section) {
  double sum = 0;
  for (const CutSegment& segment : section.outline) sum += (segment[1] - segment[0]).norm();
  return sum;
}

TEST(Outline, RunsAroundTheSurfaceOnce) {
  const TetMesh none;
  const auto outline = [&](const char* name, const Vector3d& normal, double offset) {
    return cut(none, corpus::open_surface(name), {normal, offset});
  };
  // Planes through an octahedron's vertices and edges, between them, and beside it.
  EXPECT_NEAR(length(outline("octahedron:", Vector3d::UnitZ(), 0)), 4 * std::sqrt(2), 1e-14);
  EXPECT_EQ(outline("octahedron:", Vector3d::UnitZ(), 0).outline.size(), 4u);
  EXPECT_NEAR(length(outline("octahedron:", Vector3d::UnitZ(), 0.5)), 2 * std::sqrt(2), 1e-14);
  EXPECT_NEAR(length(outline("octahedron:", {1, 1, 0}, 0)), 4 * std::sqrt(1.5), 1e-14);
  EXPECT_EQ(length(outline("octahedron:", Vector3d::UnitZ(), 1)), 0);
  EXPECT_TRUE(outline("octahedron:", Vector3d::UnitZ(), 2).outline.empty());
  // If a face of a box is in the plane, the outline is its border and not the triangles in it.
  for (const double x : {0.0, 0.3, 0.5, 1.0})
    EXPECT_NEAR(length(outline("box:n=4", Vector3d::UnitX(), x)), 4, 1e-14) << x;
}

TEST(PlaneText, IsReadAndWritten) {
  TriangleSurface surface;
  surface.vertices = {{1, -4, 0}, {3, 5, 7}};
  const auto read = [&](const std::string& text) { return parse_plane(text, surface); };
  EXPECT_EQ(read("x=0").normal, Vector3d::UnitX());
  EXPECT_EQ(read("z = -1.5e1").offset, -15);
  EXPECT_EQ(read("y").normal, Vector3d::UnitY());
  EXPECT_EQ(read("y").offset, 0.5);
  EXPECT_EQ(read("1,-2,0.5,3").normal, Vector3d(1, -2, 0.5));
  EXPECT_EQ(read(" 1, -2, 0.5, 3").offset, 3);
  EXPECT_EQ(plane_text(read("x=0.25")), "x = 0.25");
  EXPECT_EQ(plane_text(read("-1,2,0,3")), "-x + 2 y = 3");
  EXPECT_EQ(plane_text(read("1,1,-0.5,0.1")), "x + y - 0.5 z = 0.1");
  for (const char* bad : {"", "w=0", "x=", "x=a", "x:0", "xy", "1,2,3", "1,2,3,4,5", "1,2,,4", "0,0,0,1",
                          "nan,0,0,1", "x=inf", "1e308,1e308,1e308,0"})
    EXPECT_THROW(read(bad), InputError) << bad;
  for (const char* text : {"x=0", "y=0", "z=0", "1,2,3,4", "0,0,2,1", "1,0,1,0", "0,1,1e-9,0"}) {
    const Plane plane = read(text);
    const auto [right, up] = picture_axes(plane);
    EXPECT_NEAR(right.norm(), 1, 1e-15);
    EXPECT_NEAR(up.norm(), 1, 1e-15);
    EXPECT_NEAR(right.dot(up), 0, 1e-15);
    EXPECT_NEAR(right.dot(plane.normal) + up.dot(plane.normal), 0, 1e-14) << text;
  }
}

}  // namespace
}  // namespace tetproof::reference
