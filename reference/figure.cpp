// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "io/error.hpp"
#include "reference/improve.hpp"
#include "reference/weights.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// Coordinates are whole numbers of this many to a pixel: short in the file, and fine enough to magnify.
constexpr int fineness = 10;
constexpr int drawing = 760;  // pixels along the longer side of the cut
constexpr int margin = 20, header = 46, footer = 34, legend = 150;

using Pixel = std::array<int, 2>;

// Classes of a measured value: class i holds what lies below bounds[i], the last one the rest.
struct Classes {
  std::string heading;
  std::vector<double> bounds;
  std::vector<std::string> labels;  // of the bounds

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

// Powers of two that leave a hundredth of the tetrahedra in the cut below the lowest and above the highest
// bound.
Classes volume_classes(std::vector<double> relative) {
  std::sort(relative.begin(), relative.end());
  const auto power = [&](double part) {
    const double value = relative[static_cast<std::size_t>(part * static_cast<double>(relative.size() - 1))];
    return value > 0 ? static_cast<int>(std::clamp(std::round(std::log2(value)), -60.0, 60.0)) : -60;
  };
  int lowest = power(0.01), highest = std::max(power(0.99), lowest + 1);
  const int step = (highest - lowest) / 9 + 1;
  Classes classes{"volume / mean volume", {}, {}};
  for (int p = lowest; p <= highest; p += step) {
    classes.bounds.push_back(std::exp2(p));
    classes.labels.push_back(p >= 0    ? fmt::format("{:.0f}", std::exp2(p))
                             : p > -20 ? fmt::format("1/{:.0f}", std::exp2(-p))
                                       : fmt::format("{:.0e}", std::exp2(p)));
  }
  return classes;
}

// From the default of --improve-below to the regular tetrahedron's 0.0439.
Classes quality_classes() {
  return {"smallest solid angle / 4\u03c0",
          {0.0005, 0.002, 0.005, 0.01, 0.015, 0.02, 0.03},
          {"0.0005", "0.002", "0.005", "0.01", "0.015", "0.02", "0.03"}};
}

// Viridis, whose lightness grows evenly; without its darkest part, on which edges would not show.
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

std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text) {
    if (c == '&')
      all += "&amp;";
    else if (c == '<')
      all += "&lt;";
    else if (c == '>')
      all += "&gt;";
    else if (static_cast<unsigned char>(c) >= ' ')
      all += c;
  }
  return all;
}

// A path's data: closed polygons or open lines, in steps from point to point.
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

// Segments put end to end as far as they go.
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

// From the plane to the picture.
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
    scale_ = fineness * drawing / size.maxCoeff();
    left_ = low[0];
    top_ = high[1];
    for (int i = 0; i < 2; ++i) size_[i] = static_cast<int>(std::lround(size[i] * scale_));
  }
  Pixel operator()(const Vector3d& point) const {
    return {static_cast<int>(std::lround((axes_[0].dot(point) - left_) * scale_)),
            static_cast<int>(std::lround((top_ - axes_[1].dot(point)) * scale_))};
  }
  Pixel size() const { return size_; }  // in fine units

 private:
  std::array<Vector3d, 2> axes_;
  double scale_, left_, top_;
  Pixel size_;
};

std::string legend_svg(const Classes& classes, int x, int y) {
  constexpr int height = 24, width = 26;
  const std::size_t count = classes.bounds.size() + 1;
  std::string svg =
      fmt::format("<g font-size=\"12\">\n<text x=\"{}\" y=\"{}\">{}</text>\n", x, y + 10, classes.heading);
  for (std::size_t i = 0; i < count; ++i) {  // the largest on top
    const int top = y + 22 + static_cast<int>(count - 1 - i) * height;
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x, top, width,
                       height, colour(i, count));
    if (i < classes.bounds.size())
      svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", x + width + 6, top + 4, classes.labels[i]);
  }
  const int below = y + 22 + static_cast<int>(count) * height;
  svg += fmt::format(
      "<path d=\"M{} {}h{}\" stroke=\"#c00020\" stroke-width=\"2\"/>\n<text x=\"{}\" y=\"{}\">the "
      "surface</text>\n</g>\n",
      x, below + 18, width, x + width + 6, below + 22);
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
  const Classes classes = by_volume ? volume_classes(values) : quality_classes();

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
            page_height = header + std::max(height, 280) + footer;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{3}\" y=\"28\" font-size=\"18\">{2}</text>\n"
      "<g transform=\"translate({3} {4}) scale({5})\" stroke=\"#1b1e3a\" stroke-width=\"3\" "
      "stroke-linejoin=\"round\">\n",
      page_width, page_height, escaped(options.title), margin, header, 1.0 / fineness);
  for (std::size_t i = fills.size();
       i-- > 0;)  // the small ones last: their edges lie over those of the large ones
    if (!fills[i].text().empty())
      svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colour(i, fills.size()), fills[i].text());
  if (!outline.empty())
    svg += fmt::format("<path fill=\"none\" stroke=\"#c00020\" stroke-width=\"16\" d=\"{}\"/>\n",
                       chained(outline).text());
  svg += "</g>\n" + legend_svg(classes, margin + std::max(width, 400) + margin, header);
  svg += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"12\">{}: {} of {} tetrahedra cut, {} triangles and {} "
      "quadrilaterals</text>\n</svg>\n",
      margin, page_height - 12, plane_text(options.plane), cut.polygons.size(), mesh.tets.size(), triangles,
      cut.polygons.size() - triangles);
  return svg;
}

}  // namespace tetproof::reference
