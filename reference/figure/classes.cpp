// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/classes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "reference/engine/adaptation/improve.hpp"
#include "reference/equations.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

constexpr int legend_top = 20, field_height = 19, field_width = 26;

std::array<Vector3d, 4> corners(const TetMesh& mesh, Index t, double unit) {
  const auto& [a, b, c, d] = mesh.tets[t];
  return {mesh.points[a] / unit, mesh.points[b] / unit, mesh.points[c] / unit, mesh.points[d] / unit};
}

double volume_of(const std::array<Vector3d, 4>& tet) {
  const auto& [a, b, c, d] = tet;
  return std::abs(volume(a, b, c, d));
}

Classes volume_classes(const std::vector<double>& relative, const std::vector<double>& areas) {
  // Weighted by area, because many slivers take up little of the picture.
  std::vector<std::pair<double, double>> weighted;
  double all = 0;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    weighted.emplace_back(relative[i], areas[i]);
    all += areas[i];
  }
  std::sort(weighted.begin(), weighted.end());
  const auto power = [&](double part) {
    double sum = 0;
    std::size_t i = 0;
    while (i + 1 < weighted.size() && (sum += weighted[i].second) < part * all) ++i;
    return static_cast<int>(
        std::clamp(std::round(std::log2(std::max(weighted[i].first, 1e-18))), -60.0, 60.0));
  };
  const int lowest = power(0.01), highest = std::max(power(0.99), lowest + 1),
            step = (highest - lowest) / 8 + 1;
  Classes classes{"volume / mean volume", {}, {}};
  for (int p = lowest; p <= highest; p += step) {
    classes.bounds.push_back(std::exp2(p));
    classes.labels.push_back(p >= 0     ? fmt::format("{:.0f}", std::exp2(p))
                             : p >= -12 ? fmt::format("1/{:.0f}", std::exp2(-p))
                                        : fmt::format("{:.1e}", std::exp2(p)));
  }
  return classes;
}

// The bounds cover the range from around the default of --improve-below up to the regular tetrahedron,
// 0.0439.
Classes quality_classes() {
  return {"smallest solid angle / 4\u03c0",
          {0.0005, 0.002, 0.005, 0.01, 0.015, 0.02, 0.03},
          {"0.0005", "0.002", "0.005", "0.01", "0.015", "0.02", "0.03"}};
}

}  // namespace

std::string hexadecimal(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::size_t Classes::of(double value) const {
  return static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), value) - bounds.begin());
}

Colour Classes::colour(std::size_t i) const {
  constexpr int anchors[][3] = {
      {0x55, 0xb4, 0xcf}, {0x7f, 0xcd, 0xc0}, {0xb0, 0xdf, 0xb8}, {0xdd, 0xf0, 0xb5}, {0xfd, 0xf9, 0xd6}};
  constexpr std::size_t last = std::size(anchors) - 1;
  const double at = static_cast<double>(i) / static_cast<double>(count() - 1) * last;
  const std::size_t low = std::min(static_cast<std::size_t>(at), last - 1);
  Colour mixed;
  for (int c = 0; c < 3; ++c)
    mixed[c] = static_cast<int>(std::lround(anchors[low][c] + (at - static_cast<double>(low)) *
                                                                  (anchors[low + 1][c] - anchors[low][c])));
  return mixed;
}

std::string Classes::legend() const {
  std::string svg = fmt::format("<text y=\"10\">{}</text>\n", heading);
  for (std::size_t i = 0; i < count(); ++i) {
    const int top = legend_top + static_cast<int>(count() - 1 - i) * field_height;
    svg += fmt::format("<rect y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", top, field_width,
                       field_height, hexadecimal(colour(i)));
    if (i < bounds.size())
      svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", field_width + 6, top + 4, labels[i]);
  }
  return svg +
         fmt::format("<path d=\"M0 {}h{}v{}h-{}z\" fill=\"none\" stroke=\"#667\" stroke-width=\"0.5\"/>\n",
                     legend_top, field_width, field_height * count(), field_width);
}

int Classes::legend_height() const {
  return legend_top + field_height * static_cast<int>(count());
}

std::vector<double> shown_values(const TetMesh& mesh, const std::vector<Index>& tets, FigureColour what) {
  const double unit = unit_of(mesh.points);
  double mean = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mean += volume_of(corners(mesh, static_cast<Index>(t), unit));
  mean /= static_cast<double>(mesh.tets.size());
  std::vector<double> values;
  for (const Index t : tets) {
    const auto tet = corners(mesh, t, unit);
    values.push_back(what == FigureColour::volume ? volume_of(tet) / mean
                                                  : solid_angle_of(smallest_solid_angle(tet)));
  }
  return values;
}

Classes classes_for(const std::vector<double>& values, const std::vector<double>& areas, FigureColour what) {
  return what == FigureColour::volume ? volume_classes(values, areas) : quality_classes();
}

}  // namespace tetproof::reference
