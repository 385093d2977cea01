// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/reports/report_scene.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/page/reduced.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/findings_text.hpp"
#include "verify/mesh/faces.hpp"

namespace tetproof::verify {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_bytes = 16'500'000;  // of the scene; the page's scripts and tables have the rest
constexpr std::size_t most_boundary = 150'000, most_surface = 60'000, most_ring_edges = 150'000;
constexpr std::size_t most_marks = 60;

class Builder {
 public:
  Builder(const Report& report, const PageSubject& subject)
      : report_(report),
        subject_(subject),
        mesh_(subject.mesh),
        place_of_point_(mesh_.points.size(), -1),
        place_of_tet_(mesh_.tets.size(), -1) {}

  ReportScene build() {
    find_drawable();
    find_named();
    choose_boundary();
    hold_tets();
    add_boundary();
    add_surface();
    add_defects();
    add_targets();
    add_largest_distances();
    finish_points();
    return std::move(result_);
  }

 private:
  io::Scene& scene() { return result_.scene; }

  bool usable(Index v) const {
    return v >= 0 && v < static_cast<Index>(mesh_.points.size()) &&
           mesh_.points[static_cast<std::size_t>(v)].allFinite();
  }

  void find_drawable() {
    undrawable_.assign(mesh_.tets.size(), 0);
    std::int64_t count = 0;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const auto& tet = mesh_.tets[t];
      bool fine = true;
      for (std::size_t i = 0; i < 4; ++i) {
        fine = fine && usable(tet[i]);
        for (std::size_t j = 0; j < i; ++j) fine = fine && tet[i] != tet[j];
      }
      undrawable_[t] = !fine;
      count += !fine;
    }
    if (count > 0)
      result_.left_out.push_back(
          fmt::format("{} cannot be drawn: they lack points, repeat them, or have coordinates that are no "
                      "numbers. The points "
                      "that they have are marked.",
                      io::counted(count, "tetrahedra")));
  }

  // The tetrahedra that findings name, and their neighbours: all that share a vertex with them.
  void find_named() {
    std::vector<std::uint8_t> broken_at(mesh_.points.size(), 0);
    const auto touch = [&](Index v) {
      if (v >= 0 && v < static_cast<Index>(mesh_.points.size())) broken_at[static_cast<std::size_t>(v)] = 1;
    };
    std::vector<std::uint8_t> is_named(mesh_.tets.size(), 0);
    bool runs = false;
    for (const CheckResult& result : report_.checks)
      for (const Finding& finding : result.findings) {
        runs = runs || !finding.tet_runs.empty();
        for (const Index t : finding.tets) {
          is_named[static_cast<std::size_t>(t)] = 1;
          for (const Index v : mesh_.tets[static_cast<std::size_t>(t)]) touch(v);
        }
        for (const auto& face : finding.faces) std::for_each(face.begin(), face.end(), touch);
        std::for_each(finding.vertices.begin(), finding.vertices.end(), touch);
      }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      if (undrawable_[t]) continue;
      if (is_named[t])
        named_.push_back(static_cast<Index>(t));
      else if (std::any_of(mesh_.tets[t].begin(), mesh_.tets[t].end(),
                           [&](Index v) { return broken_at[static_cast<std::size_t>(v)]; }))
        ring_.push_back(static_cast<Index>(t));
    }
    if (runs)
      result_.left_out.push_back(
          "Of findings that concern ranges of tetrahedra, the view outlines those that the finding lists one "
          "by "
          "one.");
  }

  void choose_boundary() {
    const FaceMatching matching = match_faces(mesh_, undrawable_);
    std::vector<std::array<Index, 3>> triangles;
    for (const FaceId face : matching.boundary) triangles.push_back(vertices_of(mesh_, face));
    const io::ReducedTriangles fewer = io::reduced(mesh_.points, triangles, most_boundary);
    boundary_ = fewer.triangles;
    for (const std::size_t from : fewer.from) owners_.push_back(tet_of(matching.boundary[from]));
    if (fewer.cell > 0)
      result_.left_out.push_back(
          fmt::format("The boundary of {} is drawn by {}: points within {:.3g} of each other may be joined. "
                      "A click on one "
                      "tells about one of the tetrahedra behind it.",
                      io::counted(static_cast<std::int64_t>(triangles.size()), "faces"),
                      io::counted(static_cast<std::int64_t>(boundary_.size()), "triangles"), fewer.cell));
  }

  Index point(Index v) {
    Index& place = place_of_point_[static_cast<std::size_t>(v)];
    if (place < 0) {
      place = static_cast<Index>(scene().points.size());
      scene().points.push_back(mesh_.points[static_cast<std::size_t>(v)]);
      scene().point_numbers.push_back(subject_.numbering.point(v));
    }
    return place;
  }

  Index tet(Index t) {
    Index& place = place_of_tet_[static_cast<std::size_t>(t)];
    if (place < 0) {
      place = static_cast<Index>(scene().tets.size());
      std::array<Index, 4> corners = mesh_.tets[static_cast<std::size_t>(t)];
      for (Index& v : corners) v = point(v);
      scene().tets.push_back(corners);
      scene().tet_numbers.push_back(subject_.numbering.tet(t));
      if (!subject_.regions.empty())
        scene().tet_regions.push_back(
            static_cast<std::int32_t>(subject_.regions[static_cast<std::size_t>(t)]));
    }
    return place;
  }

  // The tetrahedra that the page holds: those that can be cut first.
  void hold_tets() {
    for (const RegionTag& tag : subject_.region_tags) scene().regions.push_back(region_text(tag));
    const std::size_t drawable =
        mesh_.tets.size() - static_cast<std::size_t>(std::count(undrawable_.begin(), undrawable_.end(), 1));
    const std::size_t surface =
        subject_.surface ? std::min(most_surface, subject_.surface->triangles.size()) : 0;
    const std::size_t rest =
        io::scene_size(0, surface, boundary_.size() + surface + 4 * named_.size()) + ring_.size() * 24;
    if (io::scene_size(drawable, std::min(mesh_.points.size(), 4 * drawable), 0) + rest <= most_bytes) {
      for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
        if (!undrawable_[t]) tet(static_cast<Index>(t));
    } else {
      hold_middle(rest + io::scene_size(boundary_.size(), boundary_.size(), 0));
    }
    scene().cut_tets = scene().tets.size();
    for (const auto* tets : {&named_, &owners_})
      for (const Index t : *tets) tet(t);
  }

  // The tetrahedra that planes through the middle of the box meet; of as many axes as fit.
  void hold_middle(std::size_t rest) {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& triangle : boundary_)
      for (const Index v : triangle) {
        low = low.cwiseMin(mesh_.points[static_cast<std::size_t>(v)]);
        high = high.cwiseMax(mesh_.points[static_cast<std::size_t>(v)]);
      }
    scene().cut_middle = low / 2 + high / 2;
    scene().cut_anywhere = false;
    scene().cut_axes.clear();
    std::vector<std::uint8_t> met(mesh_.tets.size(), 0);
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::size_t> more;
      for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
        if (undrawable_[t] || met[t]) continue;
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Index v : mesh_.tets[t]) {
          least = std::min(least, mesh_.points[static_cast<std::size_t>(v)][axis]);
          most = std::max(most, mesh_.points[static_cast<std::size_t>(v)][axis]);
        }
        if (least <= scene().cut_middle[axis] && most >= scene().cut_middle[axis]) more.push_back(t);
      }
      if (io::scene_size(count + more.size(), count + more.size(), 0) + rest > most_bytes) continue;
      for (const std::size_t t : more) met[t] = 1;
      count += more.size();
      scene().cut_axes += "xyz"[axis];
    }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      if (met[t]) tet(static_cast<Index>(t));
    result_.left_out.push_back(
        scene().cut_axes.empty()
            ? "The mesh is too large to be cut in a page."
            : fmt::format(
                  "The mesh is too large to be cut anywhere in a page of 20 MB. The page holds the {} of "
                  "{} tetrahedra that planes through the middle of the box meet (across {}).",
                  count, mesh_.tets.size(), fmt::join(scene().cut_axes, ", ")));
  }

  void add_boundary() {
    io::SceneLayer layer{.id = "boundary", .name = "boundary of the mesh", .triangles = {}, .tets = {}};
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      std::array<Index, 3> t = boundary_[i];
      for (Index& v : t) v = point(v);
      layer.triangles.push_back(t);
      layer.tets.push_back(tet(owners_[i]));
    }
    layer.boundary = true;
    layer.opacity = named_.empty() ? 1 : 0.3;
    scene().layers.push_back(std::move(layer));
    measure_distances();
  }

  // The distance of each boundary point that is drawn, to a hundredth: it only chooses a colour.
  void measure_distances() {
    if (!report_.fidelity || !subject_.surface) return;
    const TriangleSet surface{subject_.surface->vertices, subject_.surface->triangles};
    const std::array<TriangleSet, 2> sets{TriangleSet{mesh_.points, boundary_}, surface};
    const Units units = units_of(sets);
    if (!units.usable) return;
    const TriangleTree tree(surface, units);
    if (tree.empty()) return;
    std::vector<std::uint8_t> at_boundary(scene().points.size(), 0);
    for (const auto& t : scene().layers.back().triangles)
      for (const Index v : t) at_boundary[static_cast<std::size_t>(v)] = 1;
    scene().point_value_name = "distance to the surface";
    std::vector<float>& values = scene().point_values;
    values.assign(scene().points.size(), std::numeric_limits<float>::quiet_NaN());
    tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
      if (!at_boundary[i]) return;
      const auto nearest = tree.nearest(units.to(scene().points[i]), -1, -1, 0.01);
      // In units of the surface's box diagonal: such a number fits into a float, whatever the file's unit.
      values[i] = static_cast<float>(std::sqrt(nearest.squared) * (units.scale / units.diagonal));
    });
    scene().point_value_name = "distance to the surface / diagonal of the box";
  }

  void add_surface() {
    if (!subject_.surface) return;
    const TriangleSurface& surface = *subject_.surface;
    const io::ReducedTriangles fewer = io::reduced(surface.vertices, surface.triangles, most_surface);
    if (fewer.cell > 0)
      result_.left_out.push_back(
          fmt::format("The surface of {} is drawn by {}: points within {:.3g} of each other may be joined.",
                      io::counted(static_cast<std::int64_t>(surface.triangles.size()), "triangles"),
                      fewer.triangles.size(), fewer.cell));
    io::SceneLayer layer{.id = "surface",
                         .name = "surface",
                         .triangles = {},
                         .tets = {},
                         .colour = "#7a8f3c",
                         .opacity = 0.25,
                         .shown = false};
    std::vector<Index> place(surface.vertices.size(), -1);
    for (std::array<Index, 3> t : fewer.triangles) {
      for (Index& v : t) {
        Index& at = place[static_cast<std::size_t>(v)];
        if (at < 0) at = free_point(surface.vertices[static_cast<std::size_t>(v)]);
        v = at;
      }
      layer.triangles.push_back(t);
    }
    scene().layers.push_back(std::move(layer));
  }

  // A point that is none of the mesh's.
  Index free_point(const Vector3d& p) {
    scene().points.push_back(p);
    scene().point_numbers.push_back(-1);
    return static_cast<Index>(scene().points.size()) - 1;
  }

  void add_defects() {
    if (!named_.empty()) {
      io::SceneLayer layer{.id = "defects",
                           .name = "tetrahedra that findings name",
                           .triangles = {},
                           .tets = {},
                           .colour = "#c8102e"};
      for (const Index t : named_)
        for (const auto& face : tet_faces) {
          const std::array<Index, 4>& corners = scene().tets[static_cast<std::size_t>(tet(t))];
          layer.triangles.push_back({corners[static_cast<std::size_t>(face[0])],
                                     corners[static_cast<std::size_t>(face[1])],
                                     corners[static_cast<std::size_t>(face[2])]});
          layer.tets.push_back(tet(t));
        }
      scene().layers.push_back(std::move(layer));
    }
    io::SceneLayer faces{
        .id = "faces", .name = "faces that findings name", .triangles = {}, .tets = {}, .colour = "#f08a24"};
    for (const CheckResult& result : report_.checks)
      for (const Finding& finding : result.findings)
        for (std::array<Index, 3> face : finding.faces) {
          if (!std::all_of(face.begin(), face.end(), [&](Index v) { return usable(v); })) continue;
          for (Index& v : face) v = point(v);
          faces.triangles.push_back(face);
        }
    if (!faces.triangles.empty()) scene().layers.push_back(std::move(faces));
    add_ring();
  }

  void add_ring() {
    std::vector<std::array<Index, 2>> edges;
    for (const Index t : ring_) {
      const std::array<Index, 4>& tet = mesh_.tets[static_cast<std::size_t>(t)];
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j)
          edges.push_back({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    if (edges.empty()) return;
    if (edges.size() > most_ring_edges) {
      result_.left_out.push_back(
          fmt::format("Of the {} edges around the defects {} are drawn.", edges.size(), most_ring_edges));
      edges.resize(most_ring_edges);
    }
    for (auto& edge : edges)
      for (Index& v : edge) v = point(v);
    scene().edges.push_back({.id = "ring", .name = "edges around them", .edges = std::move(edges)});
  }

  void add_target(std::string text, std::vector<Vector3d> around, std::vector<Index> tets,
                  std::vector<Index> nodes) {
    io::SceneTarget target{Vector3d::Zero(), 0, std::move(text), std::move(tets), std::move(nodes)};
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vector3d& p : around) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    target.middle = low / 2 + high / 2;
    target.radius = (high / 2 - low / 2).stableNorm();
    if (target.radius == 0) target.radius = edge_at(around[0]);
    scene().targets.push_back(std::move(target));
  }

  // A length to look at a single point from: a hundredth of the box.
  double edge_at(const Vector3d&) {
    if (box_ < 0) {
      Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
      for (const Vector3d& p : scene().points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      box_ = scene().points.empty() ? 1 : (high / 2 - low / 2).stableNorm();
    }
    return box_ / 50;
  }

  void add_targets() {
    std::size_t marks_left_out = 0;
    for (const CheckResult& result : report_.checks)
      for (const Finding& finding : result.findings) {
        std::vector<Vector3d> around;
        std::vector<Index> tets, nodes;
        const auto node = [&](Index v) {
          if (!usable(v)) return;
          around.push_back(mesh_.points[static_cast<std::size_t>(v)]);
          nodes.push_back(point(v));
        };
        for (const Index t : finding.tets)
          if (undrawable_[static_cast<std::size_t>(t)]) {
            for (const Index v : mesh_.tets[static_cast<std::size_t>(t)]) node(v);
          } else {
            tets.push_back(tet(t));
            for (const Index v : mesh_.tets[static_cast<std::size_t>(t)])
              around.push_back(mesh_.points[static_cast<std::size_t>(v)]);
          }
        for (const auto& face : finding.faces) std::for_each(face.begin(), face.end(), node);
        std::for_each(finding.vertices.begin(), finding.vertices.end(), node);
        if (finding.point && finding.point->allFinite()) {
          around.push_back(*finding.point);
          if (scene().marks.size() < most_marks)
            scene().marks.push_back({*finding.point, info(result.check).id});
          else
            ++marks_left_out;
        }
        if (around.empty()) {
          result_.targets.push_back(-1);
          continue;
        }
        result_.targets.push_back(static_cast<int>(scene().targets.size()));
        add_target(std::string(info(result.check).id) + ": " + finding_text(finding, subject_.numbering),
                   around, std::move(tets), std::move(nodes));
      }
    if (marks_left_out > 0)
      result_.left_out.push_back(
          fmt::format("{} have no word beside them in the view; the table of findings flies to them.",
                      io::counted(static_cast<std::int64_t>(marks_left_out), "further places")));
  }

  void add_largest_distances() {
    if (!report_.fidelity) return;
    const auto add = [&](const std::optional<Vector3d>& at, const std::optional<double>& distance,
                         const char* what, int& target) {
      if (!at || !distance || !at->allFinite() || *distance == 0) return;
      scene().marks.push_back({*at, fmt::format("{} {:.4g}", what, *distance), "#1f5a99"});
      target = static_cast<int>(scene().targets.size());
      add_target(fmt::format("the largest distance from the {} is at least {} at ({}, {}, {})", what,
                             *distance, at->x(), at->y(), at->z()),
                 {*at}, {}, {});
    };
    add(report_.fidelity->mesh_to_surface_at, report_.fidelity->mesh_to_surface, "mesh to surface",
        result_.to_surface);
    add(report_.fidelity->surface_to_mesh_at, report_.fidelity->surface_to_mesh, "surface to mesh",
        result_.to_mesh);
  }

  // Points that were added after the distances have none.
  void finish_points() {
    if (!scene().point_values.empty())
      scene().point_values.resize(scene().points.size(), std::numeric_limits<float>::quiet_NaN());
  }

  const Report& report_;
  const PageSubject& subject_;
  const TetMesh& mesh_;
  ReportScene result_;
  std::vector<Index> place_of_point_, place_of_tet_;  // in the scene; -1: not there
  std::vector<std::uint8_t> undrawable_;              // tetrahedra
  std::vector<Index> named_, ring_;                   // tetrahedra, ascending
  std::vector<std::array<Index, 3>> boundary_;
  std::vector<Index> owners_;  // the tetrahedron of each triangle of `boundary_`
  double box_ = -1;
};

}  // namespace

ReportScene report_scene(const Report& report, const PageSubject& subject) {
  return Builder(report, subject).build();
}

}  // namespace tetproof::verify
