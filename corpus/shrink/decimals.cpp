// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/decimals.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace tetproof::corpus {
namespace {

double number(const std::string& text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

struct Box {
  Eigen::Vector3d low, high;
  double size() const { return (high - low).maxCoeff(); }
};

Box box_of(const TriangleSurface& surface) {
  Box box{surface.vertices.at(0), surface.vertices.at(0)};
  for (const Eigen::Vector3d& p : surface.vertices)
    box.low = box.low.cwiseMin(p), box.high = box.high.cwiseMax(p);
  return box;
}

}  // namespace

int decimals_of(double x) {
  if (x == 0) return std::numeric_limits<int>::min();
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::scientific).ptr;
  const std::string text(buffer, end);
  const std::size_t e = text.find('e'), point = text.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(e - point) - 1;
  return digits - std::atoi(text.c_str() + e + 1);
}

double rounded(double x, int decimals) {
  const double unit = number(fmt::format("1e{}", -decimals));
  if (!(unit > 0)) return x;
  const double value = number(fmt::format("{:.0f}e{}", std::round(x / unit), -decimals));
  return std::isfinite(value) ? value + 0.0 : x;  // -0 + 0 is 0
}

int coarsest_decimals(const TriangleSurface& surface) {
  const double size = box_of(surface).size();
  if (!(size > 0) || !std::isfinite(size)) return 0;
  const std::string text = fmt::format("{:.0e}", size);
  return -std::atoi(text.c_str() + text.find('e') + 1);
}

std::int64_t decimals_beyond(const TriangleSurface& surface, int coarsest) {
  std::int64_t sum = 0;
  for (const Eigen::Vector3d& p : surface.vertices)
    for (const double x : p) sum += std::max(decimals_of(x), coarsest) - coarsest;
  return sum;
}

int most_decimals(const TriangleSurface& surface, int coarsest) {
  int most = coarsest;
  for (const Eigen::Vector3d& p : surface.vertices)
    for (const double x : p) most = std::max(most, decimals_of(x));
  return most;
}

TriangleSurface brought_near(const TriangleSurface& surface, bool move, bool scale) {
  TriangleSurface result = surface;
  const Box box = box_of(surface);
  const double size = box.size();
  if (!(size > 0) || !std::isfinite(size)) return result;
  const double far = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  if (move && far > 8 * size)
    for (Eigen::Vector3d& p : result.vertices) p -= box.low;
  if (scale && (size < 0.1 || size > 1000)) {
    const int exponent = -std::ilogb(size);
    for (Eigen::Vector3d& p : result.vertices)
      for (double& x : p) x = std::ldexp(x, exponent);
  }
  return result;
}

}  // namespace tetproof::corpus
