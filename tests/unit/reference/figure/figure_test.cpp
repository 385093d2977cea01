// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a plane through a grid: its polygons fill the domain's cross-section once, wherever the plane
// runs; and the picture made of them.
#include "reference/figure/figure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// The unit cube in n x n x n cells of six tetrahedra.
TetMesh block(int n) {
  TetMesh mesh;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.points.push_back(Vector3d(i, j, k) / n);
  const int step[] = {1, n + 1, (n + 1) * (n + 1)};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          const int a = i + (n + 1) * (j + (n + 1) * k), b = a + step[axes[0]], c = b + step[axes[1]];
          mesh.tets.push_back({a, b, c, c + step[axes[2]]});
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return mesh;
}

// The area of a polygon by the shoelace formula around its first corner.
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

// Polygons meet edge to edge: each edge belongs to one or two of them, and those of one close up to loops.
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

// The cross-section's area from the boundary faces alone: a sum over the directed segments in which the plane
// x_axis = value meets them. For planes through no vertex.
double section_area(const TetMesh& mesh, int axis, double value) {
  std::map<std::array<Index, 3>, std::pair<int, std::array<Index, 3>>> faces;
  for (const auto& tet : mesh.tets)
    for (const auto& [a, b, c] : tet_faces) {
      const std::array<Index, 3> face{tet[a], tet[b], tet[c]};
      std::array<Index, 3> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      auto& [count, directed] = faces[sorted];
      ++count, directed = face;
    }
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double twice = 0;
  for (const auto& [sorted, entry] : faces) {
    if (entry.first != 1) continue;
    std::array<Vector3d, 2> ends;  // where the face goes down through the plane, and up
    int met = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector3d a = mesh.points[entry.second[i]], b = mesh.points[entry.second[(i + 1) % 3]];
      if ((a[axis] > value) == (b[axis] > value)) continue;
      ends[a[axis] > value ? 0 : 1] = a + (value - a[axis]) / (b[axis] - a[axis]) * (b - a);
      ++met;
    }
    if (met == 2) twice += ends[0][u] * ends[1][v] - ends[0][v] * ends[1][u];
  }
  return std::abs(twice) / 2;
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
          expect_conforming(section);  // corners coincide
        for (const CutPolygon& polygon : section.polygons)
          for (int i = 0; i < polygon.corners; ++i) EXPECT_EQ(polygon.points[i][axis], value);
      }
    for (const double value : {-0.1, 1.1, std::nextafter(1.0, 2), std::nextafter(0.0, -1)})
      EXPECT_TRUE(cut(mesh, none, {Vector3d::UnitX(), value}).polygons.empty());
    // Obliquely: a regular hexagon, a triangle, the diagonal plane (a lattice plane of the split), a corner.
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
      // In a plane of the lattice: as much as close beside it.
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
  EXPECT_EQ(corners({0, 0, 1}, 0.5), 3);   // one vertex on its own
  EXPECT_EQ(corners({1, 1, 0}, 0.5), 4);   // two and two
  EXPECT_EQ(corners({0, 0, 1}, 1), 0);     // touches a vertex
  EXPECT_EQ(corners({1, 0, 1}, 0), 0);     // touches an edge
  EXPECT_EQ(corners({0, 0, 1}, 0), 3);     // holds a face
  EXPECT_EQ(corners({1, -1, 0}, 0), 3);    // holds an edge
  EXPECT_EQ(corners({1, -0.5, 0}, 0), 3);  // holds an edge
  EXPECT_EQ(corners({1, 2, -1}, 0), 3);    // holds a vertex, between one and two others
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
  EXPECT_EQ(cut(mesh, {}, plane).polygons.at(0).tet, 0);  // only one above is left
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
  // Through an octahedron's vertices and edges, between them, and beside it.
  EXPECT_NEAR(length(outline("octahedron:", Vector3d::UnitZ(), 0)), 4 * std::sqrt(2), 1e-14);
  EXPECT_EQ(outline("octahedron:", Vector3d::UnitZ(), 0).outline.size(), 4u);
  EXPECT_NEAR(length(outline("octahedron:", Vector3d::UnitZ(), 0.5)), 2 * std::sqrt(2), 1e-14);
  EXPECT_NEAR(length(outline("octahedron:", {1, 1, 0}, 0)), 4 * std::sqrt(1.5), 1e-14);
  EXPECT_EQ(length(outline("octahedron:", Vector3d::UnitZ(), 1)), 0);
  EXPECT_TRUE(outline("octahedron:", Vector3d::UnitZ(), 2).outline.empty());
  // A box's face in the plane: its border, not the triangles in it.
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

// The closed polygons of a path: moves and lines in relative coordinates.
double path_area(const std::string& data, int* polygons) {
  std::istringstream stream(data);
  double x = 0, y = 0, twice = 0, x0 = 0, y0 = 0;
  char c;
  while (stream >> c) {
    if (c == 'z') {
      x = x0, y = y0;
      continue;
    }
    EXPECT_EQ(c, 'm');
    double dx, dy, sum = 0;
    stream >> dx >> dy;
    x += dx, y += dy, x0 = x, y0 = y;
    stream >> c;
    EXPECT_EQ(c, 'l');
    while (stream >> std::ws && stream.peek() != 'z') {
      if (!(stream >> dx >> dy)) {
        ADD_FAILURE() << "a number is missing in " << data.substr(0, 100);
        return 0;
      }
      sum += (x - x0) * (y + dy - y0) - (x + dx - x0) * (y - y0);
      x += dx, y += dy;
    }
    twice += std::abs(sum);
    ++*polygons;
  }
  return twice / 2;
}

struct Picture {
  int paths = 0, polygons = 0;
  double area = 0;  // of the filled paths, in square pixels
  std::string outline, title, texts;
};

// Reads the SVG as XML.
Picture parse(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  Picture picture;
  const auto& root = tree.get_child("svg");
  picture.title = root.get<std::string>("title");
  for (const auto& [name, node] : root)
    if (name == "text") picture.texts += node.data() + "\n";
  const auto& drawing = root.get_child("g");
  double scale = 0;
  const std::string transform = drawing.get<std::string>("<xmlattr>.transform");
  EXPECT_EQ(std::sscanf(transform.c_str(), "translate(%*d %*d) scale(%lf)", &scale), 1);
  for (const auto& [name, node] : drawing) {
    if (name != "path") continue;
    const std::string data = node.get<std::string>("<xmlattr>.d");
    if (node.get<std::string>("<xmlattr>.fill") == "none") {
      picture.outline = data;
    } else {
      ++picture.paths;
      picture.area += path_area(data, &picture.polygons) * scale * scale;
    }
  }
  return picture;
}

TEST(Figure, ShowsTheWholeSectionOnce) {
  const TriangleSurface surface = corpus::open_surface("sphere:r=1,n=2000");
  const Generation made = generate(
      surface, {.region = Region::outside, .cells = {15, 0, 0}, .box_scale = 2, .adapt = AdaptOptions{}});
  for (const FigureColour colour : {FigureColour::volume, FigureColour::quality}) {
    const FigureOptions options{
        .plane = {Vector3d::UnitX(), 0.01}, .colour = colour, .title = "a <b> & \"c\" \x01\xFF"};
    const std::string svg = figure(made.mesh(), surface, options);
    EXPECT_EQ(svg, figure(made.mesh(), surface, options));
    const Picture picture = parse(svg);
    EXPECT_EQ(picture.title, "a <b> & \"c\" ??");
    // The box is four by four lengths, drawn 760 pixels wide; corners are rounded to a fifth of a pixel.
    const double expected = section_area(made.mesh(), 0, 0.01);
    EXPECT_NEAR(picture.area / (190 * 190), expected, 2e-3 * expected);
    const PlaneCut section = cut(made.mesh(), surface, options.plane);
    EXPECT_LE(picture.polygons, static_cast<int>(section.polygons.size()));
    EXPECT_GT(picture.polygons, static_cast<int>(section.polygons.size()) * 9 / 10);
    EXPECT_GT(picture.paths, 3);
    // One closed line around the sphere: the area in it is that of the circle, but for its being a polygon.
    int loops = 0;
    EXPECT_NEAR(path_area(picture.outline, &loops) / (950.0 * 950), 3.1416, 0.02);
    EXPECT_EQ(loops, 1);
    EXPECT_NE(picture.texts.find("x = 0.01: " + std::to_string(section.polygons.size()) + " of " +
                                 std::to_string(made.mesh().tets.size()) + " tetrahedra cut, "),
              std::string::npos)
        << picture.texts;
  }
}

TEST(Figure, APlaneThatMissesTheGridIsRefused) {
  try {
    figure(block(2), {}, {.plane = {Vector3d::UnitX(), 2}});
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "the plane x = 2 misses the grid, which has 48 tetrahedra");
  }
  EXPECT_THROW(figure({}, {}, {}), InputError);
  // A plane that runs along the grid's boundary shows it.
  EXPECT_EQ(parse(figure(block(2), {}, {.plane = {Vector3d::UnitX(), 1}, .title = "t"})).polygons, 8);
}

}  // namespace
}  // namespace tetproof::reference
