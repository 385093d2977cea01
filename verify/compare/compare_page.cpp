// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/bytes/words.hpp"
#include "io/page/page.hpp"
#include "io/page/picture.hpp"
#include "io/page/surface_layer.hpp"

namespace tetproof::verify {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;
using io::PageCell;
using io::PageRow;

constexpr const char* reference_colour = "#1f5a99";
constexpr const char* other_colour = "#c8102e";

// Collects what one side names, as a layer of a scene with a mark for each single point.
class Side {
 public:
  Side(io::Scene& scene, std::string id, std::string name, const char* colour)
      : scene_(scene),
        layer_{.id = std::move(id), .name = std::move(name), .colour = colour, .opacity = 0.55} {}

  void add_tet(const std::array<Vector3d, 4>& corners, std::int64_t number) {
    if (!std::all_of(corners.begin(), corners.end(), [](const Vector3d& p) { return p.allFinite(); })) return;
    std::array<Index, 4> tet;
    for (std::size_t k = 0; k < 4; ++k) tet[k] = add(corners[k]);
    const auto t = static_cast<std::uint32_t>(scene_.tets.size());
    scene_.tets.push_back(tet);
    scene_.tet_numbers.push_back(number);
    for (std::uint32_t face = 0; face < 4; ++face) layer_.faces.push_back(t << 2 | face);
    tets_.push_back(static_cast<Index>(t));
  }
  void add_triangle(const std::array<Vector3d, 3>& corners) {
    faces_.push_back({add(corners[0]), add(corners[1]), add(corners[2])});
  }
  void add_edge(const std::array<Vector3d, 2>& ends) { edges_.push_back({add(ends[0]), add(ends[1])}); }
  void add_point(const Vector3d& p, const std::string& text) {
    if (!p.allFinite()) return;
    nodes_.push_back(add(p));
    scene_.marks.push_back({p, text, layer_.colour});
  }

  // Puts the side into the scene. Returns its target, or -1 if it names no place.
  int finish(const std::string& text) {
    if (!low_.allFinite()) return -1;
    const std::string id = layer_.id, name = layer_.name, colour = layer_.colour;
    if (!layer_.faces.empty()) scene_.layers.push_back(std::move(layer_));
    if (!faces_.empty())
      scene_.layers.push_back({.id = id + "-faces",
                               .name = name + ": faces",
                               .triangles = faces_,
                               .colour = colour,
                               .opacity = 0.55});
    if (!edges_.empty())
      scene_.edges.push_back(
          {.id = id + "-edges", .name = name + ": edges", .edges = edges_, .colour = colour});
    scene_.targets.push_back(
        {low_ / 2 + high_ / 2, (high_ / 2 - low_ / 2).stableNorm(), text, tets_, nodes_});
    return static_cast<int>(scene_.targets.size()) - 1;
  }

 private:
  Index add(const Vector3d& p) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
    scene_.points.push_back(p);
    scene_.point_numbers.push_back(-1);
    return static_cast<Index>(scene_.points.size()) - 1;
  }

  io::Scene& scene_;
  io::SceneLayer layer_;
  std::vector<std::array<Index, 3>> faces_;
  std::vector<std::array<Index, 2>> edges_;
  std::vector<Index> tets_, nodes_;
  Vector3d low_ = Vector3d::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
};

bool is_point(const Json& value) {
  return value.is_array() && value.size() == 3 &&
         std::all_of(value.begin(), value.end(), [](const Json& c) { return c.is_number(); });
}

Vector3d point_of(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

// The points in a list of them; none if it is something else, such as the lattice vertices of a cut, which
// are whole numbers.
template <std::size_t n>
std::optional<std::array<Vector3d, n>> points_of(const Json& value) {
  if (!value.is_array() || value.size() != n || !std::all_of(value.begin(), value.end(), is_point)) return {};
  std::array<Vector3d, n> points;
  for (std::size_t k = 0; k < n; ++k) points[k] = point_of(value[k]);
  return points;
}

void add_record(Side& side, const Json& record, const std::string& name) {
  if (!record.is_object()) return;
  const bool cut = record.value("record", "") == "cut";  // its edge is of the lattice
  for (const auto& [key, value] : record.items()) {
    if (key == "tet") {
      if (const auto tet = points_of<4>(value)) side.add_tet(*tet, 0);
    } else if (key == "face") {
      if (const auto face = points_of<3>(value)) side.add_triangle(*face);
    } else if (key == "edge" && !cut) {
      if (const auto edge = points_of<2>(value)) side.add_edge(*edge);
    } else if ((key == "point" || key == "from" || key == "to") && is_point(value)) {
      side.add_point(point_of(value), name + ": " + key);
    }
  }
}

Json parsed(const std::string& record) {
  return record.empty() ? Json() : Json::parse(record, nullptr, false);
}

// A row for each key of the two records.
std::vector<PageRow> rows_of(const Json& reference, const Json& other) {
  std::vector<std::string> keys;
  for (const Json* record : {&reference, &other})
    if (record->is_object())
      for (const auto& [key, value] : record->items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  const auto text = [](const Json& record, const std::string& key) -> std::string {
    if (!record.is_object() || !record.contains(key)) return "(not there)";
    return record[key].is_string() ? record[key].get<std::string>() : record[key].dump();
  };
  std::vector<PageRow> rows;
  for (const std::string& key : keys) {
    const std::string a = text(reference, key), b = text(other, key);
    rows.push_back({{.text = key},
                    {.text = a},
                    {.text = b},
                    a == b ? PageCell{.text = "same"} : PageCell{.text = "differs", .kind = "warning"}});
  }
  return rows;
}

std::string coordinates(const Vector3d& p) {
  return p.allFinite() ? fmt::format("({}, {}, {})", p.x(), p.y(), p.z()) : "no point";
}

void add_grid_side(io::Page& page, io::Scene& scene, const GridSide& side, const std::string& id,
                   const char* colour) {
  page.part(id, "Only in " + side.file);
  page.paragraph(fmt::format("{} of {} and {} of {}.", side.tets_only, io::counted(side.tets, "tetrahedra"),
                             side.points_only, io::counted(side.points, "points")));
  std::vector<PageRow> rows;
  for (std::size_t i = 0; i < side.first_tets.size(); ++i) {
    const GridSide::Tet& tet = side.first_tets[i];
    std::array<Vector3d, 4> corners;
    std::string text;
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = tet.corners[k].at;
      text += fmt::format("{}{} {}", k ? ", " : "", tet.corners[k].number, coordinates(corners[k]));
    }
    Side one(scene, fmt::format("{}-tet-{}", id, i),
             fmt::format("tetrahedron {} of {}", tet.number, side.file), colour);
    one.add_tet(corners, tet.number);
    rows.push_back(
        {{.text = fmt::format("tetrahedron {}", tet.number)},
         {.text = text,
          .target = one.finish(fmt::format("only in {}: tetrahedron {}", side.file, tet.number))}});
  }
  for (std::size_t i = 0; i < side.first_points.size(); ++i) {
    const GridSide::Point& point = side.first_points[i];
    Side one(scene, fmt::format("{}-point-{}", id, i), "", colour);
    one.add_point(point.at, fmt::format("{}", point.number));
    rows.push_back({{.text = fmt::format("point {}", point.number)},
                    {.text = coordinates(point.at),
                     .target = one.finish(fmt::format("only in {}: point {}", side.file, point.number))}});
  }
  const auto all = side.tets_only + side.points_only;
  if (all > static_cast<std::int64_t>(rows.size()))
    page.paragraph(fmt::format("The first {} are listed.", rows.size()));
  if (!rows.empty()) page.table(id + "-only", {"element", "where"}, rows);
  for (const Loss& loss : side.not_compared)
    page.paragraph(fmt::format("Not compared: {} {} ({}).", loss.count, loss.item, loss.example));
}

// A single point is looked at from a tenth of the scene's size.
void widen_targets(io::Scene& scene) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vector3d& p : scene.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (io::SceneTarget& target : scene.targets)
    if (target.radius == 0) target.radius = std::max((high / 2 - low / 2).stableNorm() / 10, 1e-300);
}

}  // namespace

std::string comparison_page(const TraceComparison& c, const TriangleSurface* surface) {
  const bool diverges = c.verdict == TraceComparison::Verdict::diverges;
  const bool incomplete = c.verdict == TraceComparison::Verdict::unresolved || !c.not_compared.empty();
  io::Page page(c.other.file + " beside " + c.reference.file, {.text = name_of(c.verdict),
                                                               .kind = diverges     ? "fail"
                                                                       : incomplete ? "warning"
                                                                                    : "pass"});
  page.lines(comparison_text(c));
  if (c.verdict == TraceComparison::Verdict::equal) return page.text();
  const Json reference = parsed(c.reference.record), other = parsed(c.other.record);
  io::Scene scene;
  Side first(scene, "reference", "the reference's choice", reference_colour),
      second(scene, "other", "the other's choice", other_colour);
  add_record(first, reference, "reference");
  add_record(second, other, "other");
  const int to_first = first.finish("reference: " + c.reference.says),
            to_second = second.finish("other: " + c.other.says);
  if (surface) {
    io::SurfaceLayer drawn = io::surface_layer(scene, *surface);
    drawn.layer.opacity = 0.25;
    scene.layers.push_back(std::move(drawn.layer));
    if (!drawn.left_out.empty()) page.paragraph(drawn.left_out);
  }
  widen_targets(scene);
  page.part("choices", "Both choices in place");
  page.table("sides", {"", "file", "line", "says"},
             {{{.text = "reference"},
               {.text = c.reference.file},
               {.text = fmt::format("{}", c.reference.line), .number = true},
               {.text = c.reference.says, .target = to_first}},
              {{.text = "other"},
               {.text = c.other.file},
               {.text = fmt::format("{}", c.other.line), .number = true},
               {.text = c.other.says, .target = to_second}}});
  if (to_first >= 0 || to_second >= 0)
    page.view(scene, io::picture_svg(scene));
  else
    page.paragraph("The two records name no points: there is nothing to draw.");
  page.part("records", "The two records");
  const std::vector<PageRow> rows = rows_of(reference, other);
  if (rows.empty())
    page.paragraph("There is no single record on either side.");
  else
    page.table("record", {"key", "reference", "other", ""}, rows);
  return page.text();
}

std::string comparison_page(const GridComparison& c) {
  io::Page page(c.other.file + " beside " + c.reference.file, {.text = !c.equal()     ? "different"
                                                                       : c.complete() ? "equal"
                                                                                      : "incomplete",
                                                               .kind = !c.equal()     ? "fail"
                                                                       : c.complete() ? "pass"
                                                                                      : "warning"});
  page.lines(comparison_text(c));
  io::Scene scene;
  add_grid_side(page, scene, c.reference, "reference", reference_colour);
  add_grid_side(page, scene, c.other, "other", other_colour);
  widen_targets(scene);
  if (!scene.targets.empty()) page.view(scene, io::picture_svg(scene));
  return page.text();
}

}  // namespace tetproof::verify
