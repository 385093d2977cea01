// SPDX-License-Identifier: GPL-3.0-or-later
// Plots for pages, as SVG: histograms, and curves through points.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tetproof::io {

/// A histogram: counts[i] values lie in [edges[i], edges[i + 1]); the last interval has no upper end.
struct Histogram {
  std::string id;     ///< of the SVG: letters and "-"
  std::string title;  ///< what was counted, with its unit
  std::vector<double> edges;
  std::vector<std::int64_t> counts;
  std::string below;  ///< a line under the plot, for example the least and the largest value
};
std::string histogram_svg(const Histogram& histogram);

/// Curves or points over one axis.
struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool dots = false;  ///< single points; else a line
  std::string colour = "#1f5a99";
};
struct Plot {
  std::string id, title, across, up;  ///< the last two: what the axes show, with units
  std::vector<Curve> curves;
  bool logarithmic = false;  ///< the axis upwards; values that are not positive are left out and counted
};
/// At most 4000 points of each curve are drawn, evenly chosen, the first and last among them; the plot says
/// so.
std::string plot_svg(const Plot& plot);

}  // namespace tetproof::io
