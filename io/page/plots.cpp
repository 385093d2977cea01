// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/bytes/xml_text.hpp"

namespace tetproof::io {
namespace {

constexpr int width = 520, height = 250, left = 64, right = 14, top = 34, bottom = 62;
constexpr int across = width - left - right, up = height - top - bottom;
constexpr std::size_t most_points = 4000;

std::string begin(const std::string& id, const std::string& title) {
  return fmt::format(
      "<svg id=\"{}\" class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-label=\"{}\">\n<text x=\"{}\" y=\"20\" class=\"title\">{}</text>\n",
      xml_escaped(id), width, height, xml_escaped(title), left, xml_escaped(title));
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     xml_escaped(text));
}

// About `parts` round numbers in a range.
std::vector<double> round_numbers(double low, double high, int parts) {
  const double raw = (high - low) / parts;
  if (!(raw > 0) || !std::isfinite(raw)) return {low};
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double step = raw / power <= 1   ? power
                      : raw / power <= 2 ? 2 * power
                      : raw / power <= 5 ? 5 * power
                                         : 10 * power;
  std::vector<double> all;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && all.size() < 20; ++k)
    all.push_back(k * step + 0.0);  // no -0
  return all;
}

// The first and last point are kept, and points between them at equal steps.
std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points) {
  if (points.size() <= most_points) return points;
  std::vector<std::pair<double, double>> some;
  for (std::size_t i = 0; i < most_points; ++i)
    some.push_back(points[i * (points.size() - 1) / (most_points - 1)]);
  return some;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen() {
    if (!(low <= high)) low = 0, high = 1;
    if (low == high) {
      const double by = low == 0 ? 1 : std::abs(low) / 2;
      low -= by;
      high += by;
    }
  }
  double part(double value) const { return (value - low) / (high - low); }
};

}  // namespace

std::string histogram_svg(const Histogram& histogram) {
  std::string svg = begin(histogram.id, histogram.title);
  const std::size_t bars = histogram.counts.size();
  const std::int64_t most = bars ? *std::max_element(histogram.counts.begin(), histogram.counts.end()) : 0;
  for (const double tick : round_numbers(0, static_cast<double>(std::max<std::int64_t>(most, 1)), 4)) {
    const double y = top + up * (1 - tick / static_cast<double>(std::max<std::int64_t>(most, 1)));
    svg += fmt::format("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n", left,
                       left + across, y, y);
    svg += text_at(left - 6, y + 4, "end", fmt::format("{:.6g}", tick));
  }
  const double step = bars ? static_cast<double>(across) / static_cast<double>(bars) : 0;
  const std::size_t every = bars > 12 ? (bars + 11) / 12 : 1;
  for (std::size_t i = 0; i < bars; ++i) {
    const double part =
        static_cast<double>(histogram.counts[i]) / static_cast<double>(std::max<std::int64_t>(most, 1));
    const double x = left + step * static_cast<double>(i);
    const std::string interval =
        i + 1 < histogram.edges.size()
            ? fmt::format("{:.4g} to {:.4g}", histogram.edges[i], histogram.edges[i + 1])
            : fmt::format("from {:.4g}", i < histogram.edges.size() ? histogram.edges[i] : 0.0);
    svg += fmt::format(
        "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{}: "
        "{}</title></rect>\n",
        x + 0.5, top + up * (1 - part), std::max(step - 1, 0.5), up * part, interval, histogram.counts[i]);
    if (i % every == 0 && i < histogram.edges.size())
      svg += text_at(x, top + up + 16, "middle", fmt::format("{:.4g}", histogram.edges[i]));
  }
  svg += fmt::format("<line class=\"axis\" x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>\n", left, left + across,
                     top + up, top + up);
  svg += text_at(left + across / 2.0, height - 10, "middle", histogram.below);
  return svg + "</svg>";
}

std::string plot_svg(const Plot& plot) {
  Range x, y;
  std::size_t left_out = 0, not_drawn = 0;
  const auto value = [&](double v) { return plot.logarithmic ? std::log10(v) : v; };
  const auto usable = [&](const std::pair<double, double>& p) {
    return std::isfinite(p.first) && std::isfinite(p.second) && (!plot.logarithmic || p.second > 0);
  };
  std::vector<std::vector<std::pair<double, double>>> drawn;
  for (const Curve& curve : plot.curves) {
    std::vector<std::pair<double, double>> points;
    for (const auto& p : curve.points)
      if (usable(p))
        points.emplace_back(p.first, value(p.second));
      else
        ++left_out;
    drawn.push_back(thinned(points));
    not_drawn += points.size() - drawn.back().size();
    for (const auto& [a, b] : drawn.back()) x.add(a), y.add(b);
  }
  x.widen();
  y.widen();
  std::string svg = begin(plot.id, plot.title);
  for (const double tick : round_numbers(y.low, y.high, 4)) {
    const double at = top + up * (1 - y.part(tick));
    svg += fmt::format("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n", left,
                       left + across, at, at);
    svg += text_at(left - 6, at + 4, "end",
                   fmt::format("{:.4g}", plot.logarithmic ? std::pow(10.0, tick) : tick));
  }
  for (const double tick : round_numbers(x.low, x.high, 6))
    svg += text_at(left + across * x.part(tick), top + up + 16, "middle", fmt::format("{:.6g}", tick));
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    const Curve& curve = plot.curves[c];
    std::string path;
    for (const auto& [a, b] : drawn[c]) {
      const double px = left + across * x.part(a), py = top + up * (1 - y.part(b));
      path += curve.dots ? fmt::format("M{:.1f} {:.1f}h0", px, py)
                         : fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
    }
    svg += fmt::format("<path class=\"{}\" stroke=\"{}\" fill=\"none\" d=\"{}\"/>\n",
                       curve.dots ? "dots" : "curve", xml_escaped(curve.colour), path);
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" fill=\"{}\">{}</text>\n", left + across,
                    top + 12 + 14 * static_cast<int>(c), xml_escaped(curve.colour), xml_escaped(curve.name));
  }
  svg += fmt::format("<line class=\"axis\" x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>\n", left, left + across,
                     top + up, top + up);
  std::string below = plot.across;
  if (left_out > 0) below += fmt::format(" ({} values that are not positive numbers are left out)", left_out);
  if (not_drawn > 0) below += fmt::format(" ({} of the points are not drawn)", not_drawn);
  svg += text_at(left + across / 2.0, height - 24, "middle", below);
  svg += fmt::format(
      "<text x=\"12\" y=\"{}\" transform=\"rotate(-90 12 {})\" text-anchor=\"middle\">{}</text>\n",
      top + up / 2, top + up / 2, xml_escaped(plot.up));
  return svg + "</svg>";
}

}  // namespace tetproof::io
