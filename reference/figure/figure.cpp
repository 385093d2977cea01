// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/figure.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "io/error.hpp"
#include "reference/engine/adaptation/improve.hpp"
#include "reference/equations.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// Coordinates in the file are whole numbers, in units of 1/fineness pixel: short, and fine enough to magnify.
constexpr int fineness = 5;
constexpr int drawing = 760;  // pixels along the longer side of the cut
constexpr int margin = 20, header = 46, footer = 34, legend = 165;

using Pixel = std::array<int, 2>;

// Classes of a measured value. Class i holds the values below bounds[i] that are in no lower class; the last
// class holds the rest.
struct Classes {
  std::string heading;
  std::vector<double> bounds;
  std::vector<std::string> labels;  // one for each bound

  std::size_t of(double value) const {
    return static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), value) - bounds.begin());
  }
};

std::array<Vector3d, 4> corners(const TetMesh& mesh, Index t) {
  const auto& [a, b, c, d] = mesh.tets[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
}

double volume_of(const TetMesh& mesh, Index t) {
  const auto [a, b, c, d] = corners(mesh, t);
  return std::abs(volume(a, b, c, d));
}

double area(const CutPolygon& polygon) {
  const auto& [a, b, c, d] = polygon.points;
  const double triangle = (b - a).cross(c - a).norm() / 2;
  return polygon.corners == 3 ? triangle : triangle + (c - a).cross(d - a).norm() / 2;
}

// The bounds are powers of two. About one hundredth of the picture's area is below the lowest of them, and
// one hundredth above the highest.
Classes volume_classes(const std::vector<double>& relative, const std::vector<CutPolygon>& polygons) {
  // Weighted by area, because many slivers take up little of the picture.
  std::vector<std::pair<double, double>> weighted;
  double all = 0;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    weighted.emplace_back(relative[i], area(polygons[i]));
    all += weighted.back().second;
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

// The colour map viridis, whose lightness grows evenly. Its darkest part, on which edges would be invisible,
// is left out.
std::string colour(std::size_t i, std::size_t count) {
  constexpr int anchors[][3] = {{0x41, 0x44, 0x87}, {0x35, 0x5f, 0x8d}, {0x2a, 0x78, 0x8e},
                                {0x21, 0x91, 0x8c}, {0x22, 0xa8, 0x84}, {0x44, 0xbf, 0x70},
                                {0x7a, 0xd1, 0x51}, {0xbd, 0xdf, 0x26}, {0xfd, 0xe7, 0x25}};
  constexpr std::size_t last = std::size(anchors) - 1;
  const double at = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) * last : last;
  const std::size_t low = std::min(static_cast<std::size_t>(at), last - 1);
  int mixed[3];
  for (int c = 0; c < 3; ++c)
    mixed[c] = static_cast<int>(std::lround(anchors[low][c] + (at - static_cast<double>(low)) *
                                                                  (anchors[low + 1][c] - anchors[low][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

// Text for XML. Bytes outside printable ASCII become '?', because they may not be valid UTF-8.
std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text)
    all += c == '&'             ? "&amp;"
           : c == '<'           ? "&lt;"
           : c == '>'           ? "&gt;"
           : c < ' ' || c > '~' ? "?"
                                : std::string(1, c);
  return all;
}

// The data of an SVG path: closed polygons or open lines, in relative coordinates.
class PathData {
 public:
  void add(const std::vector<Pixel>& points, bool closed) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      text_ += i == 0 ? "m" : i == 1 ? "l" : points[i][0] < at_[0] ? "" : " ";
      text_ += fmt::format("{}{}{}", points[i][0] - at_[0], points[i][1] < at_[1] ? "" : " ",
                           points[i][1] - at_[1]);
      at_ = points[i];
    }
    if (closed) {
      text_ += 'z';
      at_ = points.front();
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  Pixel at_{0, 0};
};

// Joins segments that share an end into lines that are as long as possible.
PathData chained(const std::vector<std::array<Pixel, 2>>& segments) {
  std::map<Pixel, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const Pixel& end : segments[i]) at[end].push_back(i);
  std::vector<bool> used(segments.size(), false);
  PathData data;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::vector<Pixel> line{segments[i][0], segments[i][1]};
    for (bool going = true; going;) {
      going = false;
      for (const std::size_t next : at[line.back()])
        if (!used[next]) {
          used[next] = going = true;
          line.push_back(segments[next][segments[next][0] == line.back() ? 1 : 0]);
          break;
        }
    }
    const bool closed = line.size() > 2 && line.front() == line.back();
    if (closed) line.pop_back();
    data.add(line, closed);
  }
  return data;
}

// Maps points of the plane to the picture.
class View {
 public:
  View(const PlaneCut& cut, const Plane& plane) : axes_(picture_axes(plane)) {
    Eigen::Array2d low(HUGE_VAL, HUGE_VAL), high = -low;
    for (const CutPolygon& polygon : cut.polygons)
      for (int i = 0; i < polygon.corners; ++i) {
        const Eigen::Array2d at(axes_[0].dot(polygon.points[i]), axes_[1].dot(polygon.points[i]));
        low = low.min(at);
        high = high.max(at);
      }
    const Eigen::Array2d size = high - low;
    scale_ = size.maxCoeff() > 0 ? fineness * drawing / size.maxCoeff() : 1;
    left_ = low[0];
    top_ = high[1];
    for (int i = 0; i < 2; ++i) size_[i] = static_cast<int>(std::lround(size[i] * scale_));
  }
  Pixel operator()(const Vector3d& point) const {
    return {static_cast<int>(std::lround((axes_[0].dot(point) - left_) * scale_)),
            static_cast<int>(std::lround((top_ - axes_[1].dot(point)) * scale_))};
  }
  Pixel size() const { return size_; }  // in units of 1/fineness pixel

 private:
  std::array<Vector3d, 2> axes_;
  double scale_, left_, top_;
  Pixel size_;
};

// The parts of the legend: a heading, a coloured field for each class, and a sample of the surface's outline.
constexpr int field_height = 24, field_width = 26, legend_top = 22, legend_bottom = 30;

int legend_height(const Classes& classes) {
  return legend_top + field_height * static_cast<int>(classes.bounds.size() + 1) + legend_bottom;
}

std::string legend_svg(const Classes& classes, int x, int y) {
  const std::size_t count = classes.bounds.size() + 1;
  const int beside = x + field_width + 6;
  std::string svg =
      fmt::format("<g font-size=\"12\">\n<text x=\"{}\" y=\"{}\">{}</text>\n", x, y + 10, classes.heading);
  for (std::size_t i = 0; i < count; ++i) {  // the largest on top
    const int top = y + legend_top + static_cast<int>(count - 1 - i) * field_height;
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x, top,
                       field_width, field_height, colour(i, count));
    if (i < classes.bounds.size())
      svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", beside, top + 4, classes.labels[i]);
  }
  const int line = y + legend_height(classes) - legend_bottom + 18;
  svg += fmt::format(
      "<path d=\"M{} {}h{}\" stroke=\"#c00020\" stroke-width=\"2\"/>\n<text x=\"{}\" y=\"{}\">the "
      "surface</text>\n</g>\n",
      x, line, field_width, beside, line + 4);
  return svg;
}

}  // namespace

std::string figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options) {
  const PlaneCut cut = reference::cut(mesh, surface, options.plane);
  if (cut.polygons.empty())
    throw InputError(fmt::format("the plane {} misses the grid, which has {} tetrahedra",
                                 plane_text(options.plane), mesh.tets.size()));

  double mean = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) mean += volume_of(mesh, static_cast<Index>(t));
  mean /= static_cast<double>(mesh.tets.size());
  const bool by_volume = options.colour == FigureColour::volume;
  std::vector<double> values;
  for (const CutPolygon& polygon : cut.polygons)
    values.push_back(by_volume ? volume_of(mesh, polygon.tet) / mean
                               : solid_angle_of(smallest_solid_angle(corners(mesh, polygon.tet))));
  const Classes classes = by_volume ? volume_classes(values, cut.polygons) : quality_classes();

  const View view(cut, options.plane);
  std::vector<PathData> fills(classes.bounds.size() + 1);
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < cut.polygons.size(); ++i) {
    const CutPolygon& polygon = cut.polygons[i];
    triangles += polygon.corners == 3;
    std::vector<Pixel> points;
    for (int c = 0; c < polygon.corners; ++c)
      if (const Pixel pixel = view(polygon.points[c]); points.empty() || points.back() != pixel)
        points.push_back(pixel);
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (points.size() > 2) fills[classes.of(values[i])].add(points, true);  // others are too small to be seen
  }
  std::vector<std::array<Pixel, 2>> outline;
  for (const CutSegment& segment : cut.outline)
    if (const std::array<Pixel, 2> ends{view(segment[0]), view(segment[1])}; ends[0] != ends[1])
      outline.push_back(ends);

  const int width = view.size()[0] / fineness, height = view.size()[1] / fineness;
  const int page_width = margin + std::max(width, 400) + margin + legend,
            page_height = header + std::max(height, legend_height(classes)) + footer;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{3}\" y=\"28\" font-size=\"18\">{2}</text>\n"
      "<g transform=\"translate({3} {4}) scale({5})\" stroke=\"#1b1e3a\" stroke-width=\"{6}\" "
      "stroke-linejoin=\"round\">\n",
      page_width, page_height, escaped(options.title), margin, header, 1.0 / fineness, 0.3 * fineness);
  // The classes of small values come last, so that their edges are drawn over those of large values.
  for (std::size_t i = fills.size(); i-- > 0;)
    if (!fills[i].text().empty())
      svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colour(i, fills.size()), fills[i].text());
  if (!outline.empty())
    svg += fmt::format("<path fill=\"none\" stroke=\"#c00020\" stroke-width=\"{}\" d=\"{}\"/>\n",
                       1.5 * fineness, chained(outline).text());
  svg += "</g>\n" + legend_svg(classes, margin + std::max(width, 400) + margin, header);
  svg += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"12\">{}: {} of {} tetrahedra cut, {} triangles and {} "
      "quadrilaterals</text>\n</svg>\n",
      margin, page_height - 12, plane_text(options.plane), cut.polygons.size(), mesh.tets.size(), triangles,
      cut.polygons.size() - triangles);
  return svg;
}

}  // namespace tetproof::reference
