// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a plane's cut shows the whole cross-section once, and the outline of the surface.
#include "reference/figure/figure.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdio>
#include <sstream>
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

// The sum of the areas of the closed polygons of a path, which consists of moves and lines in relative
// coordinates.
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
  for (const auto& [name, node] : drawing)
    if (name == "path") picture.outline = node.get<std::string>("<xmlattr>.d");
  for (const auto& [name, node] : drawing.get_child("g")) {
    if (name != "path") continue;
    ++picture.paths;
    picture.area += path_area(node.get<std::string>("<xmlattr>.d"), &picture.polygons) * scale * scale;
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
    // The box is four by four units and is drawn 760 pixels wide. Corners are rounded to a fifth of a pixel.
    const double expected = section_area(made.mesh(), 0, 0.01);
    EXPECT_NEAR(picture.area / (190 * 190), expected, 2e-3 * expected);
    const PlaneCut section = cut(made.mesh(), surface, options.plane);
    EXPECT_LE(picture.polygons, static_cast<int>(section.polygons.size()));
    EXPECT_GT(picture.polygons, static_cast<int>(section.polygons.size()) * 9 / 10);
    EXPECT_GT(picture.paths, 3);
    // One closed line around the sphere. It is a polygon, so its area is a little less than the circle's.
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
  // A plane along the grid's boundary shows this boundary.
  EXPECT_EQ(parse(figure(block(2), {}, {.plane = {Vector3d::UnitX(), 1}, .title = "t"})).polygons, 8);
}

}  // namespace
}  // namespace tetproof::reference
