// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/figure.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>

#include "io/error.hpp"
#include "reference/figure/classes.hpp"
#include "reference/figure/open_figure.hpp"
#include "reference/figure/svg.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using svg::fineness;
using svg::PathData;
using svg::Pixel;

double area(const CutPolygon& polygon) {
  const auto& [a, b, c, d] = polygon.points;
  const double triangle = (b - a).cross(c - a).norm() / 2;
  return polygon.corners == 3 ? triangle : triangle + (c - a).cross(d - a).norm() / 2;
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
    scale_ = size.maxCoeff() > 0 ? fineness * drawing_side / size.maxCoeff() : 1;
    left_ = low[0];
    top_ = high[1];
    for (int i = 0; i < 2; ++i) size_[i] = static_cast<int>(std::lround(size[i] * scale_));
  }
  Pixel operator()(const Vector3d& point) const {
    return {static_cast<int>(std::lround((axes_[0].dot(point) - left_) * scale_)),
            static_cast<int>(std::lround((top_ - axes_[1].dot(point)) * scale_))};
  }
  Pixel size() const { return size_; }

 private:
  std::array<Vector3d, 2> axes_;
  double scale_, left_, top_;
  Pixel size_;
};

std::string plane_figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options) {
  const PlaneCut cut = reference::cut(mesh, surface, options.plane);
  if (cut.polygons.empty())
    throw InputError(fmt::format("the plane {} misses the grid, which has {} tetrahedra",
                                 plane_text(options.plane), mesh.tets.size()));

  std::vector<Index> tets;
  std::vector<double> areas;
  for (const CutPolygon& polygon : cut.polygons) {
    tets.push_back(polygon.tet);
    areas.push_back(area(polygon));
  }
  const std::vector<double> values = shown_values(mesh, tets, options.colour);
  const Classes classes = classes_for(values, areas, options.colour);

  const View view(cut, options.plane);
  std::vector<PathData> fills(classes.count());
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < cut.polygons.size(); ++i) {
    const CutPolygon& polygon = cut.polygons[i];
    triangles += polygon.corners == 3;
    std::vector<Pixel> points;
    for (int c = 0; c < polygon.corners; ++c) points.push_back(view(polygon.points[c]));
    fills[classes.of(values[i])].add_polygon(points);
  }
  std::vector<std::array<Pixel, 2>> outline;
  for (const CutSegment& segment : cut.outline)
    if (const std::array<Pixel, 2> ends{view(segment[0]), view(segment[1])}; ends[0] != ends[1])
      outline.push_back(ends);

  std::string drawing = fmt::format("<g stroke=\"{}\" stroke-width=\"{}\">\n", edge_colour, 0.22 * fineness);
  // The classes of small values come last, so that their edges are drawn over those of large values.
  for (std::size_t i = fills.size(); i-- > 0;)
    if (!fills[i].empty())
      drawing +=
          fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", hexadecimal(classes.colour(i)), fills[i].text());
  drawing += "</g>\n";
  if (!outline.empty())
    drawing += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" d=\"{}\"/>\n", surface_line,
                           1.3 * fineness, svg::chained(outline).text());
  const int line = classes.legend_height() + 18;
  return svg::page(
      {.title = options.title,
       .drawing = drawing,
       .legend = classes.legend() +
                 fmt::format("<path d=\"M0 {}h26\" stroke=\"{}\" stroke-width=\"2\"/>\n<text x=\"32\" "
                             "y=\"{}\">the surface</text>\n",
                             line, surface_line, line + 4),
       .caption = {fmt::format("{}: {} of {} tetrahedra cut, {} triangles and {} quadrilaterals",
                               plane_text(options.plane), cut.polygons.size(), mesh.tets.size(), triangles,
                               cut.polygons.size() - triangles)},
       .width = view.size()[0] / fineness,
       .height = view.size()[1] / fineness,
       .legend_height = line + 12});
}

}  // namespace

std::string figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options) {
  return options.view ? open_figure(mesh, surface, options) : plane_figure(mesh, surface, options);
}

}  // namespace tetproof::reference
