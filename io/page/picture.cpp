// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "io/bytes/xml_text.hpp"
#include "io/page/reduced.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

constexpr int width = 760, height = 520, margin = 24;
constexpr std::size_t most_triangles = 3000;

// From the picture to the eye, to the right, and up: fixed numbers of length 1, so that no function of the C
// library decides about the picture's bytes.
const Vector3d towards{0.48, -0.6, 0.64}, right{0.7808688094430304, 0.6246950475544243, 0},
    up{-0.39980483043483155, 0.49975603804353946, 0.7683749084919419};

struct Drawn {
  double depth = 0;
  std::string path;
};

std::string shade(const std::string& colour, double light) {
  const long rgb = std::strtol(colour.c_str() + 1, nullptr, 16);
  const auto part = [&](int shift) {
    return static_cast<int>(std::lround(static_cast<double>(rgb >> shift & 255) * light));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(16), part(8), part(0));
}

}  // namespace

std::string picture_svg(const Scene& scene) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vector3d& p : scene.points) {
    low = low.cwiseMin(p / 2);
    high = high.cwiseMax(p / 2);
  }
  const Vector3d middle = low / 2 + high / 2;
  const double size =
      scene.points.empty() ? 1 : std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
  // In units of the box: halves first, because the box of the largest doubles is wider than doubles can say.
  const auto in_box = [&](const Vector3d& p) -> Vector3d { return (p / 2 - middle) / size; };
  double reach_x = 1e-9, reach_y = 1e-9;
  for (const Vector3d& p : scene.points) {
    reach_x = std::max(reach_x, std::abs(right.dot(in_box(p))));
    reach_y = std::max(reach_y, std::abs(up.dot(in_box(p))));
  }
  const double scale = std::min((width / 2 - margin) / reach_x, (height / 2 - margin) / reach_y);
  const auto at = [&](const Vector3d& p) -> std::array<double, 2> {
    const Vector3d q = in_box(p);
    return {width / 2 + scale * right.dot(q), height / 2 - scale * up.dot(q)};
  };

  std::vector<Drawn> drawn;
  std::size_t reduced_layers = 0;
  for (const SceneLayer& layer : scene.layers) {
    if (!layer.shown) continue;
    const ReducedTriangles fewer = reduced(scene.points, triangles_of(scene, layer), most_triangles);
    reduced_layers += fewer.cell > 0;
    for (const auto& t : fewer.triangles) {
      std::array<Vector3d, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = in_box(scene.points[static_cast<std::size_t>(t[k])]);
      const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
      const double length = normal.norm();
      const double light = length > 0 ? 0.55 + 0.45 * std::abs(normal.dot(towards)) / length : 0.7;
      std::string path = "M";
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [x, y] = at(scene.points[static_cast<std::size_t>(t[k])]);
        path += fmt::format("{}{:.1f} {:.1f}", k == 0 ? "" : "L", x, y);
      }
      drawn.push_back(
          {towards.dot(p[0] + p[1] + p[2]),
           layer.opacity < 1
               ? fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-opacity=\"0.5\" d=\"{}Z\"/>\n",
                             xml_escaped(layer.colour), path)
               : fmt::format("<path fill=\"{}\" stroke=\"#333\" d=\"{}Z\"/>\n", shade(layer.colour, light),
                             path)});
    }
  }
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const Drawn& a, const Drawn& b) { return a.depth < b.depth; });
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"img\" "
      "aria-label=\"picture of the mesh\">\n<g stroke-width=\"0.4\" stroke-linejoin=\"round\">\n",
      width, height);
  for (const Drawn& d : drawn) svg += d.path;
  svg += "</g>\n";
  for (const SceneMark& mark : scene.marks) {
    const auto [x, y] = at(mark.point);
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"none\" stroke=\"{2}\" stroke-width=\"2\"/>\n"
        "<text x=\"{3:.1f}\" y=\"{1:.1f}\" fill=\"{2}\">{4}</text>\n",
        x, y, xml_escaped(mark.colour), x + 8, xml_escaped(mark.text));
  }
  if (reduced_layers > 0)
    svg += fmt::format("<text x=\"8\" y=\"{}\">drawn by fewer triangles</text>\n", height - 8);
  return svg + "</svg>";
}

}  // namespace tetproof::io
