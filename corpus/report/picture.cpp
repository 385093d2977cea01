// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "corpus/report/labels.hpp"
#include "corpus/report/projection.hpp"
#include "io/bytes/xml_text.hpp"

namespace tetproof::corpus {
namespace {

using Eigen::Vector3d;

constexpr int width = 640, height = 470, top = 44, bottom = 54, margin = 14;
constexpr std::size_t letters = 98;  // of the small print in a line: as many digits fit
constexpr std::size_t most_triangles = 400, most_numbered = 30;
constexpr const char* red = "#c8102e";
// Of the marked tetrahedra, each in its colour.
constexpr const char* colours[] = {"#c8102e", "#f08a24", "#8e44ad", "#1f7a8c", "#7a5c1e", "#5c6f1a"};

DrawnTriangle corners_of(const std::vector<Vector3d>& points, const std::array<Index, 3>& t) {
  return {points[static_cast<std::size_t>(t[0])], points[static_cast<std::size_t>(t[1])],
          points[static_cast<std::size_t>(t[2])]};
}

std::string path_of(const Projection& project, std::span<const Vector3d> points) {
  std::string path;
  Pixel at{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Pixel next = project(points[i]);
    path += i == 0 ? fmt::format("M{} {}", next[0], next[1])
                   : fmt::format("l{} {}", next[0] - at[0], next[1] - at[1]);
    at = next;
  }
  return path + "z";
}

// What is marked: the tetrahedra, faces, triangles and points, with all their corners.
struct Defect {
  std::vector<std::array<Vector3d, 4>> tets;
  std::vector<DrawnTriangle> faces;         // of the mesh and of the surface
  std::vector<const char*> face_colours{};  // of each: its marked tetrahedron's, or red
  std::vector<std::pair<Vector3d, std::string>> vertices;
  std::vector<Vector3d> points;

  std::vector<Vector3d> all() const {
    std::vector<Vector3d> result = points;
    for (const auto& tet : tets) result.insert(result.end(), tet.begin(), tet.end());
    for (const auto& face : faces) result.insert(result.end(), face.begin(), face.end());
    for (const auto& [p, name] : vertices) result.push_back(p);
    return result;
  }
  std::vector<DrawnTriangle> triangles() const {
    std::vector<DrawnTriangle> result = faces;
    for (const auto& tet : tets)
      for (const auto& f : tet_faces)
        result.push_back({tet[static_cast<std::size_t>(f[0])], tet[static_cast<std::size_t>(f[1])],
                          tet[static_cast<std::size_t>(f[2])]});
    return result;
  }
};

Defect defect_of(const TriangleSurface& surface, const TetMesh& mesh, const Numbering& numbering,
                 const Marks& marks) {
  Defect defect;
  std::set<Index> named;
  const auto usable = [&](Index v) {
    return v >= 0 && v < static_cast<Index>(mesh.points.size()) &&
           mesh.points[static_cast<std::size_t>(v)].allFinite();
  };
  const auto name = [&](Index v) {
    if (usable(v) && named.insert(v).second)
      defect.vertices.emplace_back(mesh.points[static_cast<std::size_t>(v)],
                                   fmt::format("{}", numbering.point(v)));
  };
  const auto colour_of = [&](const std::array<Index, 3>& face) {
    for (std::size_t i = 0; i < marks.tets.size(); ++i) {
      const auto& tet = mesh.tets[static_cast<std::size_t>(marks.tets[i])];
      if (std::all_of(face.begin(), face.end(),
                      [&](Index v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); }))
        return colours[i % std::size(colours)];
    }
    return red;
  };
  for (const Index v : marks.vertices) name(v);
  for (const auto& face : marks.faces) {
    if (!std::all_of(face.begin(), face.end(), usable)) continue;
    defect.faces.push_back(corners_of(mesh.points, face));
    defect.face_colours.push_back(colour_of(face));
    for (const Index v : face) name(v);
  }
  for (const Index t : marks.tets) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(t)];
    if (!std::all_of(tet.begin(), tet.end(), usable)) continue;
    std::array<Vector3d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.points[static_cast<std::size_t>(tet[k])];
    defect.tets.push_back(corners);
    for (const Index v : tet) name(v);
  }
  for (const Index t : marks.triangles) {
    defect.faces.push_back(corners_of(surface.vertices, surface.triangles[static_cast<std::size_t>(t)]));
    defect.face_colours.push_back(red);
  }
  for (const Vector3d& p : marks.points)
    if (p.allFinite()) defect.points.push_back(p);
  return defect;
}

// The triangles that are drawn: all, or those nearest to the place.
std::vector<Index> drawn(const TriangleSurface& surface, const std::vector<Vector3d>& around) {
  std::vector<Index> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.size() <= most_triangles) return order;
  Vector3d place = Vector3d::Zero();
  for (const Vector3d& p : around) place += p / static_cast<double>(around.size());
  if (around.empty()) place = surface.vertices[static_cast<std::size_t>(surface.triangles[0][0])];
  std::vector<double> far;
  for (const auto& t : surface.triangles) {
    const auto [a, b, c] = corners_of(surface.vertices, t);
    far.push_back((a / 3 + b / 3 + c / 3 - place).stableNorm());
  }
  const auto at = [&](Index i) { return far[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return at(a) < at(b); });
  order.resize(most_triangles);
  return order;
}

// The surface: hidden triangles light, then those that face the eye, the farthest first.
std::string surface_svg(const std::vector<DrawnTriangle>& triangles, const Projection& project) {
  struct Item {
    double depth;
    bool front;
    int shade;
    std::size_t at;
  };
  std::vector<Item> items;
  double size = 0;
  for (const DrawnTriangle& t : triangles)
    for (int k = 1; k < 3; ++k)
      size = std::max(size, (t[static_cast<std::size_t>(k)] - t[0]).cwiseAbs().maxCoeff());
  if (!(size > 0)) size = 1;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const Vector3d n = ((b - a) / size).cross((c - a) / size);
    const double seen = n.norm() > 0 ? n.dot(project.seen_from()) / n.norm() : 0;
    items.push_back({project.depth(a) / 3 + project.depth(b) / 3 + project.depth(c) / 3, seen > 0,
                     196 + static_cast<int>(std::lround(48 * std::clamp(seen, 0.0, 1.0))), i});
  }
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.front != b.front ? b.front : a.depth < b.depth;
  });
  std::string svg;
  for (const bool front : {false, true}) {
    svg += front ? "<g stroke=\"#5b6b7a\" stroke-width=\"7\" fill-opacity=\"0.62\">\n"
                 : "<g stroke=\"#c3ccd4\" stroke-width=\"6\" fill=\"none\">\n";
    for (const Item& item : items)
      if (item.front == front)
        svg += fmt::format("<path{} d=\"{}\"/>\n",
                           front ? fmt::format(" fill=\"#{0:02x}{1:02x}{2:02x}\"", item.shade, item.shade + 5,
                                               item.shade + 11)
                                 : "",
                           path_of(project, triangles[item.at]));
    svg += "</g>\n";
  }
  return svg;
}

std::string defect_svg(const Defect& defect, const Projection& project, const Frame& frame, bool numbers) {
  std::string svg = "<g stroke-linejoin=\"round\">\n";
  for (std::size_t i = 0; i < defect.faces.size(); ++i)
    svg += fmt::format(
        "<path fill=\"{0}\" fill-opacity=\"0.3\" stroke=\"{0}\" stroke-width=\"{1}\" d=\"{2}\"/>\n",
        defect.face_colours[i], numbers ? 20 : 14, path_of(project, defect.faces[i]));
  for (std::size_t i = 0; i < defect.tets.size(); ++i) {
    const auto& tet = defect.tets[i];
    const char* colour = colours[i % std::size(colours)];
    std::string path;
    for (const auto& f : tet_faces)
      path += path_of(project,
                      std::array{tet[static_cast<std::size_t>(f[0])], tet[static_cast<std::size_t>(f[1])],
                                 tet[static_cast<std::size_t>(f[2])]});
    svg += fmt::format(
        "<path fill=\"{0}\" fill-opacity=\"0.16\" stroke=\"{0}\" stroke-width=\"{1}\" d=\"{2}\"/>\n", colour,
        numbers ? 14 : 11, path);
  }
  svg += "</g>\n";
  Labels labels(frame);
  for (const auto& [p, name] : defect.vertices) {
    const Pixel at = project(p);
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", at[0], at[1],
                       numbers ? 30 : 20, red);
    labels.keep_free(at);
  }
  for (const Vector3d& p : defect.points) {
    const auto [x, y] = project(p);
    svg += fmt::format("<path d=\"M{} {}l80 80m0 -80l-80 80\" stroke=\"#000\" stroke-width=\"16\"/>\n",
                       x - 40, y - 40);
  }
  if (!numbers) return svg;
  for (const auto& [p, name] : defect.vertices) labels.add(project(p), name, "#000");
  return svg + labels.svg();
}

std::string cut(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // no half of a letter
  return text.substr(0, end) + "...";
}

std::string direction_text(const Vector3d& d) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", d.x(), d.y(), d.z());
}

std::string stretch_text(const Projection& project) {
  return project.stretch() > 1.01 ? fmt::format("heights stretched x{:.2g}", project.stretch()) : "";
}

// Three numbers as text with one blank; -0 is 0.
Vector3d without_minus_zero(Vector3d d) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(d[k]) < 0.005) d[k] = 0;
  return d;
}

}  // namespace

std::string picture(const TriangleSurface& surface, const TetMesh& mesh, const Numbering& numbering,
                    const Marks& marks, const PictureText& text) {
  const Defect defect = defect_of(surface, mesh, numbering, marks);
  const std::vector<Vector3d> place = defect.all();
  const std::vector<Index> shown = drawn(surface, place);
  std::vector<DrawnTriangle> triangles;
  std::vector<Vector3d> points = place;
  for (const Index t : shown) {
    triangles.push_back(corners_of(surface.vertices, surface.triangles[static_cast<std::size_t>(t)]));
    points.insert(points.end(), triangles.back().begin(), triangles.back().end());
  }
  const bool two = !defect.faces.empty() || !defect.tets.empty() || defect.vertices.size() > 1;
  const Frame whole{margin + 16, top + 26, (two ? 350 : width - 2 * margin - 32), height - top - bottom - 60};
  const Projection project(best_direction(triangles), points, whole);

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n<text x=\"{3}\" y=\"24\" font-size=\"14\" "
      "font-weight=\"bold\">{2}</text>\n",
      width, height, io::xml_escaped(cut(text.title, 82)), margin);
  const auto small = [&](int x, int y, const std::string& line, const char* colour = "#444") {
    svg += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"{}\">{}</text>\n", x, y, colour,
                       io::xml_escaped(line));
  };
  std::string cut_off;
  if (shown.size() < surface.triangles.size())
    cut_off = fmt::format("{} of {} triangles are drawn, the nearest{}", shown.size(),
                          surface.triangles.size(), two ? " to the defect" : "");
  std::string first = text.below, second;
  if (first.size() > letters) {
    const std::size_t blank = first.rfind(' ', letters);
    const std::size_t end = blank == std::string::npos ? letters : blank;
    second = cut(first.substr(end), letters);
    first.resize(end);
  }
  small(margin, height - 40, first);
  small(margin, height - 25, second);
  std::string view =
      fmt::format("the surface from {}", direction_text(without_minus_zero(project.seen_from())));
  for (const std::string& more : {stretch_text(project), std::string("hidden triangles are light"), cut_off})
    if (!more.empty()) view += "; " + more;
  small(margin, height - 9, view);
  svg += fmt::format("<g transform=\"scale(0.1)\" stroke-linejoin=\"round\">\n{}",
                     surface_svg(triangles, project));
  svg += defect_svg(defect, project, whole, !two);
  if (place.empty() && surface.vertices.size() <= most_numbered) {
    Labels labels(whole);
    for (const Vector3d& p : surface.vertices) labels.keep_free(project(p));
    for (std::size_t i = 0; i < surface.vertices.size(); ++i)
      labels.add(project(surface.vertices[i]), fmt::format("{}", i), "#234");
    svg += labels.svg();
  }
  svg += "</g>\n";
  if (two) {
    const Frame panel{width - margin - 226, top, 226, height - top - bottom - 46};
    const int rows = static_cast<int>(marks.tets.size() + (defect.points.empty() ? 0 : 1)) * 15;
    const Frame inner{panel.left + 30, panel.top + 36, panel.width - 60, panel.height - 64 - rows};
    const std::vector<DrawnTriangle> seen = defect.triangles();
    const Projection near(seen.empty() ? project.seen_from() : best_direction(seen), place, inner);
    svg +=
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#fcfcfd\" stroke=\"#99a\"/>\n",
                    panel.left, panel.top, panel.width, panel.height);
    const double larger = near.pixels_per_length() / project.pixels_per_length();
    small(panel.left + 8, panel.top + 16,
          larger > 1.5 ? fmt::format("the defect, x{:.3g}", larger) : std::string("the defect"), "#000");
    small(panel.left, panel.top + panel.height + 14,
          fmt::format("from {}", direction_text(without_minus_zero(near.seen_from()))));
    small(panel.left, panel.top + panel.height + 27, stretch_text(near));
    int y = panel.top + panel.height - rows + 4;
    for (std::size_t i = 0; i < marks.tets.size(); ++i, y += 15) {
      svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"9\" height=\"9\" fill=\"{}\"/>\n", panel.left + 8,
                         y - 9, colours[i % std::size(colours)]);
      small(panel.left + 22, y, fmt::format("tetrahedron {}", numbering.tet(marks.tets[i])));
    }
    if (!defect.points.empty()) {
      svg += fmt::format("<path d=\"M{} {}l8 8m0 -8l-8 8\" stroke=\"#000\" stroke-width=\"1.6\"/>\n",
                         panel.left + 8, y - 8);
      small(panel.left + 22, y, "the place");
    }
    svg += fmt::format("<g transform=\"scale(0.1)\">\n{}</g>\n", defect_svg(defect, near, inner, true));
  }
  return svg + "</svg>\n";
}

}  // namespace tetproof::corpus
