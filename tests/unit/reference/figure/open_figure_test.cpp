// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a grid that is cut open: what is drawn, where, in which colours, and as sound XML.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/figure/figure.hpp"
#include "reference/generate.hpp"
#include "tests/unit/reference/figure/sections.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using test::block;
using ::testing::HasSubstr;
using ::testing::Not;

struct Picture {
  std::string title, texts;
  int width = 0, height = 0, triangles = 0, layers = 0;
  double area = 0;  // of the triangles, in square pixels, counted once for each that covers a place
  double body = 0;  // of those in the surface's colour
  std::set<std::string> fills;
};

Picture parse(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);  // throws if it is not well-formed
  Picture picture;
  const auto& root = tree.get_child("svg");
  picture.title = root.get<std::string>("title");
  picture.width = root.get<int>("<xmlattr>.width");
  picture.height = root.get<int>("<xmlattr>.height");
  for (const auto& [name, node] : root)
    if (name == "text") picture.texts += node.data() + "\n";
  for (const auto& [name, node] : root.get_child("g").get_child("g")) {
    if (name != "path") continue;
    ++picture.layers;
    const std::string fill = node.get<std::string>("<xmlattr>.fill");
    picture.fills.insert(fill);
    // The surface is orange in any light; no other colour has that little blue.
    const bool is_body =
        std::stoi(fill.substr(1, 2), nullptr, 16) - std::stoi(fill.substr(5), nullptr, 16) > 50;
    std::istringstream data(node.get<std::string>("<xmlattr>.d"));
    char move, line, end;
    double x, y, x1, y1, x2, y2;
    while (data >> move >> x >> y >> line >> x1 >> y1 >> x2 >> y2 >> end) {
      EXPECT_EQ(std::string({move, line, end}), "mlz");
      // The second corner is relative to the first one, the third to the second.
      const double area = std::abs(x1 * y2 - x2 * y1) / 2 / 25;
      picture.area += area;
      if (is_body) picture.body += area;
      ++picture.triangles;
    }
    EXPECT_TRUE(data.eof());
  }
  return picture;
}

TEST(OpenFigure, ShowsTheBlocksThreeSidesOnce) {
  // The half of a cube, seen along its diagonal: two halves of a side and one side, all in projection.
  const TetMesh mesh = block(4);
  const Vector3d view(1, 1, 1);
  const Picture picture = parse(
      figure(mesh, {}, {.plane = {Vector3d::UnitX(), 0.6}, .view = view, .title = "a <b> & \"c\" \x01\xFF"}));
  EXPECT_EQ(picture.title, "a <b> & \"c\" ??");
  EXPECT_EQ(picture.triangles, 2 * (16 + 8 + 8));
  EXPECT_THAT(picture.texts,
              HasSubstr("Cut open at x = 0.6: the 192 of 384 tetrahedra that are wholly behind it, "
                        "seen from (1, 1, 1)"));
  EXPECT_THAT(picture.texts, Not(HasSubstr("wrong order")));
  // The longer side of the picture is upright, from (0.5, 1, 0) and (0, ...) up; it is 760 pixels.
  const double high = std::sqrt(2.0 / 3) + 1.5 / std::sqrt(6.0), unit = 760 / high;
  EXPECT_NEAR(picture.area, 2 / std::sqrt(3.0) * unit * unit, 0.01 * picture.area);
}

TEST(OpenFigure, OfGridsInsideAndOutside) {
  const TriangleSurface surface = corpus::open_surface("torus:R=1,r=0.4,n=2000");
  for (const Region region : {Region::inside, Region::outside}) {
    const Generation made =
        generate(surface, {.region = region, .cells = {13, 0, 0}, .adapt = AdaptOptions{}});
    for (const char* text : {"3d", "0,0,1", "0,1,0", "-1,2,0.5", "1e-300,0,2e-300"})
      for (const FigureColour colour : {FigureColour::volume, FigureColour::quality}) {
        const Vector3d view = parse_view(text);
        const FigureOptions options{
            .plane = plane_for_view(view, surface), .view = view, .colour = colour, .title = text};
        const std::string svg = figure(made.mesh(), surface, options);
        EXPECT_EQ(svg, figure(made.mesh(), surface, options));
        EXPECT_THAT(svg, Not(HasSubstr("nan")));
        EXPECT_THAT(svg, Not(HasSubstr("inf")));
        EXPECT_THAT(svg, HasSubstr("mask=\"url(#m"));  // the surface's part before the cut
        const Picture picture = parse(svg);
        EXPECT_LE(picture.width, 1000);
        EXPECT_LE(picture.height, 900);
        EXPECT_GT(picture.triangles, 200);
        EXPECT_LT(picture.layers, picture.triangles / 5);
        EXPECT_GT(picture.fills.size(), 8u);
      }
  }
}

TEST(OpenFigure, FacesOnTheSurfaceHaveAColourOfTheirOwn) {
  const TriangleSurface surface = corpus::open_surface("sphere:r=1,n=2000");
  const auto draw = [&](Region region, double x, const Vector3d& view = {1, 0, 0}) {
    const Generation made =
        generate(surface, {.region = region, .cells = {21, 0, 0}, .box_scale = 2, .adapt = std::nullopt});
    return parse(figure(made.mesh(), surface, {.plane = {Vector3d::UnitX(), x}, .view = view, .title = "t"}));
  };
  // Seen along the plane's normal, the box's other half is a square of four by four units, 760 pixels wide,
  // with a hollow: a disc as large as the sphere just behind the plane. A grid inside is all disc.
  const double unit = 190;
  const Picture outside = draw(Region::outside, 0);
  EXPECT_NEAR(outside.area, 16 * unit * unit, 0.01 * outside.area);
  EXPECT_NEAR(outside.body, 3.1416 * unit * unit, 0.05 * outside.body);
  // From (1, 2, 2), the cut takes a third of its area and the box's sides two thirds of theirs, 16 in all. Of
  // the hollow, half a disc and half a third of one face the viewer, and a third of a disc is missing in the
  // cut.
  const Picture oblique = draw(Region::outside, 0, {1, 2, 2});
  const double body = 3.1416 * (1 + 1.0 / 3) / 2;
  EXPECT_NEAR(oblique.body / oblique.area, body / (16 - 3.1416 / 3 + body), 0.01);
  const Picture whole = draw(Region::inside, 9), half = draw(Region::inside, 0);
  EXPECT_EQ(whole.body, whole.area);
  EXPECT_EQ(half.body, 0) << "one looks at the cut";
}

TEST(OpenFigure, TheOtherWayRoundThePlaneIsTheSame) {
  const TetMesh mesh = block(3);
  const auto draw = [&](const Plane& plane) {
    const std::string svg = figure(mesh, {}, {.plane = plane, .view = Vector3d(3, 1, 1), .title = "t"});
    return svg.substr(0, svg.find("Cut open"));
  };
  EXPECT_EQ(draw({Vector3d::UnitX(), 0.5}), draw({-Vector3d::UnitX(), -0.5}));
  EXPECT_NE(draw({Vector3d::UnitX(), 0.5}), draw({Vector3d::UnitX(), 0.7}));
}

TEST(OpenFigure, DoesNotDependOnTheScale) {
  const TriangleSurface surface = corpus::open_surface("sphere:r=1,n=200");
  const Generation made =
      generate(surface, {.region = Region::outside, .cells = {7, 0, 0}, .adapt = AdaptOptions{}});
  const auto draw = [&](double scale, const std::optional<Vector3d>& view, FigureColour colour) {
    TetMesh mesh = made.mesh();
    TriangleSurface scaled = surface;
    for (Vector3d& p : mesh.points) p *= scale;
    for (Vector3d& p : scaled.vertices) p *= scale;
    const std::string svg =
        figure(mesh, scaled, {.plane = {Vector3d::UnitX(), 0}, .view = view, .colour = colour, .title = "t"});
    return svg;
  };
  for (const FigureColour colour : {FigureColour::volume, FigureColour::quality})
    for (const double scale : {std::ldexp(1, -600), std::ldexp(1, 600)})
      EXPECT_EQ(draw(scale, Vector3d(3, 1, 1), colour), draw(1, Vector3d(3, 1, 1), colour));
  // Points in one plane have no face that one sees.
  TetMesh flat = block(2);
  for (Vector3d& p : flat.points) p.z() = 0;
  EXPECT_THROW(figure(flat, {}, {.plane = {Vector3d::UnitX(), 2}, .view = Vector3d(1, 0, 0)}), InputError);
}

TEST(OpenFigure, NothingBehindThePlaneIsRefused) {
  try {
    figure(block(2), {}, {.plane = {Vector3d::UnitX(), 0.4}, .view = Vector3d(1, 0, 0)});
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "behind the plane x = 0.4 there is no whole tetrahedron of the grid, which has 48");
  }
  EXPECT_THROW(figure({}, {}, {.view = Vector3d(1, 0, 0)}), InputError);
}

TEST(OpenFigure, ViewsAreRead) {
  EXPECT_EQ(parse_view("3d"), Vector3d(1, -0.5, 0.45));
  EXPECT_EQ(parse_view("0,-4,2"), Vector3d(0, -1, 0.5));
  EXPECT_EQ(parse_view("1e300,-1e300,0"), Vector3d(1, -1, 0));
  for (const char* bad : {"", "0,0,0", "0,-0,0", "nan,0,1", "inf,0,1", "1,2", "1,2,3,4", "1,,2", "1,2,", "x",
                          "x,y,z", "top", "1;2;3", "3d,", "1e999,0,0"})
    EXPECT_THROW(parse_view(bad), InputError) << bad;
  TriangleSurface surface;
  surface.vertices = {{1, -4, 0}, {3, 5, 7}};
  EXPECT_EQ(plane_text(plane_for_view({1, -0.5, 0.45}, surface)), "x = 2");
  EXPECT_EQ(plane_text(plane_for_view({1, -2, 0.45}, surface)), "y = 0.5");
  EXPECT_EQ(plane_text(plane_for_view({1, -1, 1}, surface)), "x = 2");
}

}  // namespace
}  // namespace tetproof::reference
