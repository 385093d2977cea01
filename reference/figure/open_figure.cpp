// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/open_figure.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "reference/figure/classes.hpp"
#include "reference/figure/cut_open.hpp"
#include "reference/figure/near_part.hpp"
#include "reference/figure/painters_order.hpp"
#include "reference/figure/svg.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using svg::fineness;
using svg::PathData;
using svg::Pixel;

constexpr Colour body_colour{0xf3, 0xb5, 0x8b};
constexpr int shades = 6;  // of each colour

// Coordinates as the viewer sees them: to the right, up, and towards the viewer.
class Viewer {
 public:
  /// Divides all coordinates by `unit`.
  Viewer(const Vector3d& direction, double unit) : unit_(unit) {
    const auto [right, up] = axes_seen_from(direction);
    axes_ << right.transpose(), up.transpose(), direction.stableNormalized().transpose();
  }
  Vector3d operator()(const Vector3d& point) const { return axes_ * (point / unit_); }

 private:
  double unit_;
  Eigen::Matrix3d axes_;
};

// Maps seen coordinates to the picture, which holds all points that it was given.
class Frame {
 public:
  void hold(const Vector3d& seen) {
    low_ = low_.cwiseMin(seen.head<2>());
    high_ = high_.cwiseMax(seen.head<2>());
  }
  double scale() const {
    const double side = (high_ - low_).maxCoeff();
    return side > 0 ? fineness * drawing_side / side : 1;
  }
  Pixel operator()(const Vector3d& seen) const {
    return {static_cast<int>(std::lround((seen.x() - low_.x()) * scale())),
            static_cast<int>(std::lround((high_.y() - seen.y()) * scale()))};
  }
  Pixel size() const { return (*this)(Vector3d(high_.x(), low_.y(), 0)); }

 private:
  Vector2d low_{HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL};
};

// How light a face is, from 0 to `shades` - 1. The light comes from above the viewer's left shoulder.
int shade_of(const std::array<Vector3d, 3>& seen) {
  const Vector3d normal = (seen[1] - seen[0]).cross(seen[2] - seen[0]).stableNormalized();
  const double light = normal.dot(Vector3d(-0.3, 0.5, 0.8).normalized());
  return std::clamp(static_cast<int>(light * shades), 0, shades - 1);
}

// In the shade, colours turn a quarter towards slate: black would make them muddy.
Colour shaded(const Colour& colour, int shade) {
  constexpr Colour slate{0x4c, 0x5c, 0x7c};
  const double dark = 0.28 * (shades - 1 - shade) / (shades - 1);
  Colour result;
  for (int c = 0; c < 3; ++c)
    result[c] = static_cast<int>(std::lround(colour[c] + dark * (slate[c] - colour[c])));
  return result;
}

// Tells the faces of the outer box from those on the surface. The box of a grid outside is larger than the
// surface's on all sides; a grid inside has no box.
class OuterBox {
 public:
  OuterBox(const TetMesh& mesh, const TriangleSurface& surface) : box_(box_of(mesh.points)) {
    const Eigen::AlignedBox3d inner = box_of(surface.vertices);
    is_there_ = !inner.isEmpty() && (box_.min().array() < inner.min().array()).all() &&
                (box_.max().array() > inner.max().array()).all();
  }
  bool has(const std::array<Vector3d, 3>& face) const {
    for (int i = 0; is_there_ && i < 3; ++i)
      for (const double side : {box_.min()[i], box_.max()[i]})
        if (face[0][i] == side && face[1][i] == side && face[2][i] == side) return true;
    return false;
  }

 private:
  static Eigen::AlignedBox3d box_of(const std::vector<Vector3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : points) box.extend(point);
    return box;
  }
  Eigen::AlignedBox3d box_;
  bool is_there_;
};

// The axes as the viewer sees them, as lines of SVG around (40, top + 40).
std::string axes_svg(const Vector3d& view, int top) {
  const Viewer directions(view, 1);
  std::string svg;
  for (int i = 0; i < 3; ++i) {
    const Vector3d tip = directions(Vector3d::Unit(i));
    const auto at = [&](double length) {
      return Pixel{static_cast<int>(std::lround(40 + length * tip.x())),
                   static_cast<int>(std::lround(top + 40 - length * tip.y()))};
    };
    const Pixel end = at(27), name = at(37);
    svg += fmt::format(
        "<path d=\"M40 {}L{} {}\" stroke=\"#444\" stroke-width=\"1.2\"/>\n<text x=\"{}\" y=\"{}\" "
        "text-anchor=\"middle\" font-style=\"italic\">{}</text>\n",
        top + 40, end[0], end[1], name[0], name[1] + 4, "xyz"[i]);
  }
  return svg;
}

// The surface's part before the cut: a veil with a border. The mask hides what of the border lies behind the
// part. Its name comes from the data, so that several figures can stand in one page.
std::string near_part_svg(const std::string& data) {
  std::uint32_t name = 2166136261u;  // FNV-1a
  for (const char c : data) name = (name ^ static_cast<unsigned char>(c)) * 16777619u;
  return fmt::format(
      "<mask id=\"m{0:08x}\" maskUnits=\"userSpaceOnUse\" x=\"-99\" y=\"-99\" width=\"{1}\" "
      "height=\"{1}\">\n<path fill=\"#fff\" d=\"M-99-99h{1}v{1}h-{1}z\"/>\n<path fill=\"#000\" "
      "d=\"{2}\"/>\n</mask>\n"
      "<path fill=\"{3}\" fill-opacity=\"0.18\" d=\"{2}\"/>\n"
      "<path fill=\"none\" stroke=\"{4}\" stroke-width=\"{5}\" mask=\"url(#m{0:08x})\" d=\"{2}\"/>\n",
      name, fineness * drawing_side + 198, data, hexadecimal(body_colour), surface_line, 2 * 1.1 * fineness);
}

// The direction from which one looks, and the plane turned so that its positive side is the near one.
Plane towards_the_viewer(const Plane& plane, const Vector3d& view) {
  return plane.normal.dot(view) < 0 ? Plane{-plane.normal, -plane.offset} : plane;
}

}  // namespace

std::string open_figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options) {
  const Plane plane = towards_the_viewer(options.plane, *options.view);
  const CutOpen open = cut_open(mesh, plane);
  if (open.tets.empty())
    throw InputError(
        fmt::format("behind the plane {} there is no whole tetrahedron of the grid, which has {}",
                    plane_text(options.plane), mesh.tets.size()));

  // Only faces that are turned towards the viewer: another face of the grid is in front of each other one.
  const Viewer viewer(*options.view, unit_of(mesh.points));
  const OuterBox box(mesh, surface);
  Frame frame;
  std::vector<SeenTriangle> seen;
  std::vector<Index> tets;
  std::vector<double> areas;
  std::vector<bool> on_surface;
  for (const OpenFace& face : open.faces) {
    std::array<Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = mesh.points[face.corners[i]];
    const bool is_body = !face.is_cut && !box.has(corners);
    for (Vector3d& corner : corners) corner = viewer(corner);
    const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).z() / 2;
    if (!(area > 0)) continue;
    for (const Vector3d& corner : corners) frame.hold(corner);
    seen.push_back({corners});
    tets.push_back(face.tet);
    areas.push_back(is_body ? 0 : area);
    on_surface.push_back(is_body);
  }
  if (seen.empty())
    throw InputError(fmt::format("the {} tetrahedra behind the plane {} are too flat to be drawn",
                                 open.tets.size(), plane_text(options.plane)));
  const std::vector<double> values = shown_values(mesh, tets, options.colour);
  const Classes classes = classes_for(values, areas, options.colour);
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i].colour = static_cast<int>(on_surface[i] ? classes.count() : classes.of(values[i])) * shades +
                     shade_of(seen[i].corners);
  const std::vector<std::vector<Vector3d>> part = near_part_outline(surface, plane, *options.view);
  for (const auto& line : part)
    for (const Vector3d& point : line) frame.hold(viewer(point));

  std::string drawing = fmt::format("<g stroke=\"{}\" stroke-width=\"{}\">\n", edge_colour, 0.28 * fineness);
  const PaintersOrder order = painters_order(seen);
  for (const auto& layer : order.layers) {
    PathData data;
    for (const std::size_t i : layer) {
      std::vector<Pixel> points;
      for (const Vector3d& corner : seen[i].corners) points.push_back(frame(corner));
      data.add_polygon(points);
    }
    if (data.empty()) continue;
    const auto kind = static_cast<std::size_t>(seen[layer[0]].colour / shades);
    const Colour colour =
        shaded(kind == classes.count() ? body_colour : classes.colour(kind), seen[layer[0]].colour % shades);
    drawing += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", hexadecimal(colour), data.text());
  }
  drawing += "</g>\n";
  PathData outline;
  for (const auto& line : part) {
    std::vector<Pixel> points;
    for (const Vector3d& point : line) points.push_back(frame(viewer(point)));
    outline.add_polygon(points);
  }
  if (!outline.empty()) drawing += near_part_svg(outline.text());

  const int body = classes.legend_height() + 14, before = body + 24, axes = before + 34;
  std::string legend = classes.legend();
  legend += fmt::format(
      "<path d=\"M0 {}h26v16h-26z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"0.5\"/>\n<text x=\"32\" "
      "y=\"{}\">the "
      "surface</text>\n",
      body, hexadecimal(body_colour), edge_colour, body + 12);
  legend += fmt::format(
      "<path d=\"M0 {}h26v16h-26z\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"{}\" "
      "stroke-width=\"1.2\"/>\n<text "
      "x=\"32\" y=\"{}\">its part before the cut</text>\n",
      before, hexadecimal(body_colour), surface_line, before + 12);
  legend += axes_svg(*options.view, axes);
  const Vector3d& from = *options.view;
  std::vector<std::string> caption{fmt::format(
      "Cut open at {}: the {} of {} tetrahedra that are wholly behind it, seen from ({:.6g}, {:.6g}, {:.6g})",
      plane_text(options.plane), open.tets.size(), mesh.tets.size(), from.x(), from.y(), from.z())};
  if (order.wrong_pairs)
    caption.push_back(fmt::format(
        "{} pairs of faces are drawn in the wrong order, because faces cover one another in a circle",
        order.wrong_pairs));
  return svg::page({.title = options.title,
                    .drawing = drawing,
                    .legend = legend,
                    .caption = caption,
                    .width = frame.size()[0] / fineness,
                    .height = frame.size()[1] / fineness,
                    .legend_height = axes + 84});
}

Vector3d parse_view(const std::string& text) {
  if (text == "3d" || text == "3D") return {1, -0.5, 0.45};
  const auto fail = [&]() -> Vector3d {
    throw InputError(fmt::format(
        "--view: expected 3d, or the direction X,Y,Z from which one looks, not 0,0,0, found '{}'", text));
  };
  Vector3d view;
  std::size_t at = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',', at);
    if ((comma == std::string::npos) != (i == 2)) return fail();
    if (!parse_real(text.substr(at, comma - at), view[i]) || !std::isfinite(view[i])) return fail();
    at = comma + 1;
  }
  return view.isZero(0) ? fail() : Vector3d(view / view.cwiseAbs().maxCoeff());
}

Plane plane_for_view(const Vector3d& view, const TriangleSurface& surface) {
  int axis = 0;
  view.cwiseAbs().maxCoeff(&axis);
  return parse_plane(std::string(1, "xyz"[axis]), surface);
}

}  // namespace tetproof::reference
