// SPDX-License-Identifier: GPL-3.0-or-later
// Pages: what no name may become, what the policy admits, plots and the picture. The view itself is tested in
// a browser (tests/browser).
#include "io/page/page.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "io/page/picture.hpp"
#include "io/page/plots.hpp"
#include "io/page/reduced.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

const std::string nasty = "</script><script>alert('1\"')</script><!--&amp;\x01\xff";

std::size_t count(const std::string& text, std::string_view what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

Scene one_tetrahedron() {
  Scene scene;
  scene.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.tets = {{0, 1, 2, 3}};
  scene.cut_tets = 1;
  scene.tet_numbers = {17};
  scene.point_numbers = {4, 5, 6, 9};
  scene.layers.push_back({.id = "boundary", .name = "boundary", .faces = {0, 1, 2, 3}});
  return scene;
}

TEST(Page, texts_never_become_markup) {
  Page page(nasty, {.text = nasty, .kind = "fail"});
  page.part("part", nasty);
  page.paragraph(nasty);
  page.lines(nasty);
  page.table("table", {nasty}, {{{.text = nasty, .target = 0}}, {{.text = nasty, .link = nasty}}});
  page.svg(histogram_svg({.id = "h", .title = nasty, .edges = {0, 1}, .counts = {1, 2}, .below = nasty}));
  page.svg(
      plot_svg({.id = "p", .title = nasty, .across = nasty, .up = nasty, .curves = {{nasty, {{0, 1}}}}}));
  Scene scene = one_tetrahedron();
  scene.regions = {nasty};
  scene.marks = {{Vector3d::Zero(), nasty}};
  scene.targets = {{Vector3d::Zero(), 1, nasty, {}, {}}};
  scene.layers[0].name = nasty;
  page.view(scene, picture_svg(scene));
  const std::string text = page.text();
  // A quote is always a reference, or follows a backslash in JSON.
  EXPECT_EQ(count(text, "alert('1\""), 0u);
  EXPECT_EQ(count(text, "<script>alert"), 0u);
  EXPECT_EQ(count(text, "<script>"), 8u);   // the page's own
  EXPECT_EQ(count(text, "</script>"), 9u);  // and the scene's
  EXPECT_EQ(count(text, "<!--"), 1u);       // the licence of three.js
}

TEST(Page, without_a_view_there_is_no_script) {
  Page page("title");
  page.paragraph("text");
  const std::string text = page.text();
  EXPECT_EQ(count(text, "<script"), 0u);
  EXPECT_NE(text.find("script-src 'none'"), std::string::npos);
}

TEST(Scene, numbers_are_runs_and_arrays_are_base64) {
  const auto json = nlohmann::json::parse(scene_json(one_tetrahedron()));
  EXPECT_EQ(json["tet_numbers"], nlohmann::json::parse("[[0, 17]]"));
  EXPECT_EQ(json["point_numbers"], nlohmann::json::parse("[[0, 4], [3, 9]]"));
  EXPECT_EQ(json["tets"], "AAAAAQAAAgAAAwAA");  // three bytes each: 0, 1, 2, 3
  EXPECT_EQ(json["layers"][0]["faces"], "AAAAAAEAAAACAAAAAwAAAA==");
}

TEST(Scene, numbers_in_no_order_are_an_array) {
  Scene scene = one_tetrahedron();
  scene.tet_numbers = {std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()};
  EXPECT_EQ(nlohmann::json::parse(scene_json(scene))["tet_numbers"],
            nlohmann::json::parse("[[0, 9223372036854775807], [1, -9223372036854775808]]"));
  scene.tet_numbers.clear();
  for (std::int64_t i = 0; i < 20; ++i) scene.tet_numbers.push_back(i * 7 % 20);
  const auto json = [&] { return nlohmann::json::parse(scene_json(scene))["tet_numbers"]; };
  EXPECT_EQ(json()["int32"].get<std::string>().substr(0, 16), "AAAAAAcAAAAOAAAA");  // 0, 7, 14
  scene.tet_numbers[1] = std::int64_t{1} << 40;
  EXPECT_EQ(json()["float64"].get<std::string>().size(), 216u);  // 160 bytes
}

TEST(Scene, faces_are_wound_as_those_of_the_tetrahedron) {
  const Scene scene = one_tetrahedron();
  const auto triangles = triangles_of(scene, scene.layers[0]);
  ASSERT_EQ(triangles.size(), 4u);
  for (const auto& [a, b, c] : triangles) {
    const Vector3d normal =
        (scene.points[static_cast<std::size_t>(b)] - scene.points[static_cast<std::size_t>(a)])
            .cross(scene.points[static_cast<std::size_t>(c)] - scene.points[static_cast<std::size_t>(a)]);
    EXPECT_GT(normal.dot(scene.points[static_cast<std::size_t>(a)] - Vector3d::Constant(0.2)), 0);
  }
}

// A wavy sheet of 2 * n * n triangles.
std::pair<std::vector<Vector3d>, std::vector<std::array<Index, 3>>> sheet(Index n, double scale) {
  std::vector<Vector3d> points;
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) points.push_back(scale * Vector3d(i, j, 0.1 * ((i * 7 + j * 3) % 5)) / n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  return {points, triangles};
}

TEST(Reduced, few_triangles_stay_as_they_are) {
  const auto [points, triangles] = sheet(5, 1);
  const ReducedTriangles all = reduced(points, triangles, 50);
  EXPECT_EQ(all.triangles, triangles);
  EXPECT_EQ(all.cell, 0);
}

TEST(Reduced, fewer_of_the_same_shape) {
  for (const double scale : {1.0, 1e300, 1e-300}) {
    const auto [points, triangles] = sheet(100, scale);
    const ReducedTriangles fewer = reduced(points, triangles, 1000);
    EXPECT_LE(fewer.triangles.size(), 1000u);
    EXPECT_GE(fewer.triangles.size(), 300u) << "far fewer than asked for";
    ASSERT_EQ(fewer.from.size(), fewer.triangles.size());
    EXPECT_GT(fewer.cell, 0);
    std::set<std::array<Index, 3>> seen;
    for (std::size_t i = 0; i < fewer.triangles.size(); ++i) {
      std::array<Index, 3> t = fewer.triangles[i];
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
      for (std::size_t k = 0; k < 3; ++k) {  // each corner is near the one that it stands for
        const Vector3d off = points[static_cast<std::size_t>(t[k])] -
                             points[static_cast<std::size_t>(triangles[fewer.from[i]][k])];
        EXPECT_LE(off.cwiseAbs().maxCoeff(), fewer.cell * (1 + 1e-12));
      }
      std::sort(t.begin(), t.end());
      EXPECT_TRUE(seen.insert(t).second) << "a triangle twice";
    }
  }
}

TEST(Picture, draws_faces_and_marks_at_every_scale) {
  for (const double scale : {1.0, 1e300, 1e-300}) {
    Scene scene = one_tetrahedron();
    for (Vector3d& p : scene.points) p *= scale;
    scene.marks = {{scene.points[3], "here"}};
    const std::string svg = picture_svg(scene);
    EXPECT_EQ(count(svg, "<path"), 4u);
    EXPECT_EQ(count(svg, "<circle"), 1u);
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0u);
  }
}

TEST(Plots, bars_have_the_height_of_their_counts) {
  const std::string svg = histogram_svg({.id = "h", .title = "t", .edges = {0, 1, 2}, .counts = {5, 10, 0}});
  EXPECT_NE(svg.find("height=\"77.0\"><title>0 to 1: 5<"), std::string::npos) << svg;
  EXPECT_NE(svg.find("height=\"154.0\"><title>1 to 2: 10<"), std::string::npos) << svg;
  EXPECT_NE(svg.find("height=\"0.0\"><title>from 2: 0<"), std::string::npos) << svg;
}

TEST(Plots, what_is_not_drawn_is_said) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Plot plot{.id = "p", .title = "t", .across = "x", .curves = {{"c", {{0, 1}, {1, 0}, {2, nan}, {3, 10}}}}};
  plot.logarithmic = true;
  EXPECT_NE(plot_svg(plot).find("(2 values that are not positive numbers are left out)"), std::string::npos);
  plot.curves[0].points.assign(10000, {1, 1});
  EXPECT_NE(plot_svg(plot).find("(6000 of the points are not drawn)"), std::string::npos);
  plot.curves.clear();
  EXPECT_EQ(count(plot_svg(plot), "nan"), 0u);
}

}  // namespace
}  // namespace tetproof::io
