// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/reports/report_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/page/surface_layer.hpp"
#include "verify/findings_text.hpp"
#include "verify/reports/drawn_mesh.hpp"

namespace tetproof::verify {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_ring_edges = 150'000;
constexpr std::size_t most_edges_at_first = 5'000;  // more would hide what they surround
constexpr std::size_t most_marks = 60;

struct Box {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void add(const Vector3d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vector3d middle() const { return low / 2 + high / 2; }
  double radius() const { return (high / 2 - low / 2).stableNorm(); }
};

class Builder {
 public:
  Builder(const Report& report, const PageSubject& subject)
      : report_(report),
        subject_(subject),
        mesh_(subject.mesh),
        drawn_(subject, result_.scene, result_.left_out) {}

  ReportScene build(std::size_t most_bytes) {
    for (const Vector3d& p : mesh_.points)
      if (p.allFinite()) box_.add(p);
    find_named();
    const std::size_t surface =
        subject_.surface ? std::min(io::most_surface_triangles, subject_.surface->triangles.size()) : 0;
    std::size_t findings = 0;
    for_each_finding([&](const CheckResult&, const Finding&) { ++findings; });
    const std::size_t others =
        surface * 28 + named_.size() * 32 + std::min(6 * ring_.size(), most_ring_edges) * 8 + findings * 600;
    drawn_.choose(most_bytes - std::min(most_bytes, others));
    result_.scene.layers.push_back(drawn_.boundary(report_.fidelity && subject_.surface));
    if (!named_.empty()) result_.scene.layers.back().opacity = 0.3;
    add_surface();
    add_defects();
    add_ring();
    add_targets();
    add_largest_distances();
    if (!report_.not_judged.empty() || !report_.left_out.empty() || report_.by_corners)
      result_.left_out.emplace_back(
          "The view shows tetrahedra with straight edges, and nothing else: parts that were not judged are "
          "not drawn.");
    return std::move(result_);
  }

 private:
  const Vector3d& at(Index v) const { return mesh_.points[static_cast<std::size_t>(v)]; }
  const std::array<Index, 4>& tet(Index t) const { return mesh_.tets[static_cast<std::size_t>(t)]; }

  template <class Visit>
  void for_each_finding(const Visit& visit) const {
    for (const CheckResult& result : report_.checks)
      for (const Finding& finding : result.findings) visit(result, finding);
  }

  // The tetrahedra that findings name, and their neighbours: all that share a vertex with them.
  void find_named() {
    std::vector<std::uint8_t> broken_at(mesh_.points.size(), 0), is_named(mesh_.tets.size(), 0);
    const auto touch = [&](Index v) {
      if (v >= 0 && v < static_cast<Index>(mesh_.points.size())) broken_at[static_cast<std::size_t>(v)] = 1;
    };
    bool runs = false;
    for_each_finding([&](const CheckResult&, const Finding& finding) {
      runs = runs || !finding.tet_runs.empty();
      for (const Index t : finding.tets) {
        is_named[static_cast<std::size_t>(t)] = 1;
        std::for_each(tet(t).begin(), tet(t).end(), touch);
      }
      for (const auto& face : finding.faces) std::for_each(face.begin(), face.end(), touch);
      std::for_each(finding.vertices.begin(), finding.vertices.end(), touch);
    });
    for (Index t = 0; t < static_cast<Index>(mesh_.tets.size()); ++t) {
      if (!drawn_.drawable(t)) continue;
      if (is_named[static_cast<std::size_t>(t)])
        named_.push_back(t);
      else if (std::any_of(tet(t).begin(), tet(t).end(),
                           [&](Index v) { return broken_at[static_cast<std::size_t>(v)]; }))
        ring_.push_back(t);
    }
    if (runs)
      result_.left_out.emplace_back(
          "Of findings that concern ranges of tetrahedra, the view shows those that the finding lists one by "
          "one.");
  }

  void add_surface() {
    if (!subject_.surface) return;
    io::SurfaceLayer drawn = io::surface_layer(result_.scene, *subject_.surface);
    drawn.layer.opacity = 0.25;
    drawn.layer.shown = false;
    result_.scene.layers.push_back(std::move(drawn.layer));
    if (!drawn.left_out.empty()) result_.left_out.push_back(std::move(drawn.left_out));
  }

  // The face in the scene's points; nothing if it names one that is not usable.
  std::optional<std::array<Index, 3>> drawn_face(std::array<Index, 3> face) {
    if (!std::all_of(face.begin(), face.end(), [&](Index v) { return drawn_.usable(v); }))
      return std::nullopt;
    for (Index& v : face) v = drawn_.point(v);
    return face;
  }

  void add_defects() {
    io::SceneLayer tets{.id = "defects", .name = "tetrahedra that findings name", .colour = "#c8102e"};
    for (const Index t : named_)
      for (std::uint32_t face = 0; face < 4; ++face)
        tets.faces.push_back(static_cast<std::uint32_t>(drawn_.tet(t)) << 2 | face);
    if (!named_.empty()) result_.scene.layers.push_back(std::move(tets));
    io::SceneLayer chosen{.id = "chosen", .name = subject_.chosen_name, .colour = "#e9a23b", .shown = false};
    for (const Index t : subject_.chosen)
      if (drawn_.drawable(t))
        for (std::uint32_t face = 0; face < 4; ++face)
          chosen.faces.push_back(static_cast<std::uint32_t>(drawn_.tet(t)) << 2 | face);
    if (!chosen.name.empty()) result_.scene.layers.push_back(std::move(chosen));
    io::SceneLayer faces{.id = "faces", .name = "faces that findings name", .colour = "#f08a24"};
    for_each_finding([&](const CheckResult&, const Finding& finding) {
      for (const auto& face : finding.faces)
        if (const auto drawn = drawn_face(face)) faces.triangles.push_back(*drawn);
    });
    if (!faces.triangles.empty()) result_.scene.layers.push_back(std::move(faces));
  }

  void add_ring() {
    std::vector<std::array<Index, 2>> edges;
    for (const Index t : ring_)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j)
          edges.push_back({std::min(tet(t)[i], tet(t)[j]), std::max(tet(t)[i], tet(t)[j])});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    if (edges.empty()) return;
    if (edges.size() > most_ring_edges) {
      result_.left_out.push_back(
          fmt::format("Of the {} edges around the defects {} are drawn.", edges.size(), most_ring_edges));
      edges.resize(most_ring_edges);
    }
    for (auto& edge : edges)
      for (Index& v : edge) v = drawn_.point(v);
    const bool few = edges.size() <= most_edges_at_first;
    result_.scene.edges.push_back(
        {.id = "ring", .name = "edges around them", .edges = std::move(edges), .shown = few});
  }

  // Returns the target's position. A single point is looked at from a fiftieth of the mesh's size.
  int add_target(io::SceneTarget target, const Box& around) {
    const double radius = around.radius();
    target.middle = around.middle();
    target.radius = radius > 0 ? radius : box_.radius() / 50;
    result_.scene.targets.push_back(std::move(target));
    return static_cast<int>(result_.scene.targets.size()) - 1;
  }

  void add_targets() {
    std::size_t marks_left_out = 0;
    for_each_finding([&](const CheckResult& result, const Finding& finding) {
      Box around;
      io::SceneTarget target;
      const auto node = [&](Index v) {
        if (!drawn_.usable(v)) return;
        around.add(at(v));
        target.nodes.push_back(drawn_.point(v));
      };
      for (const Index t : finding.tets)
        if (drawn_.drawable(t)) {
          target.tets.push_back(drawn_.tet(t));
          for (const Index v : tet(t)) around.add(at(v));
        } else {
          std::for_each(tet(t).begin(), tet(t).end(), node);
        }
      for (const auto& face : finding.faces) {
        std::for_each(face.begin(), face.end(), node);
        if (const auto drawn = drawn_face(face)) target.faces.push_back(*drawn);
      }
      std::for_each(finding.vertices.begin(), finding.vertices.end(), node);
      const std::size_t number = result_.targets.size() + 1;
      if (finding.point && finding.point->allFinite()) {
        around.add(*finding.point);
        if (result_.scene.marks.size() < most_marks)
          result_.scene.marks.push_back({*finding.point, fmt::format("{}", number)});
        else
          ++marks_left_out;
      }
      target.text = fmt::format("{}: {}", info(result.check).id, finding_text(finding, subject_.numbering));
      result_.targets.push_back(around.low.allFinite() ? add_target(std::move(target), around) : -1);
    });
    if (marks_left_out > 0)
      result_.left_out.push_back(
          fmt::format("{} are not marked in the view; the table of findings flies to them.",
                      io::counted(marks_left_out, "further places")));
  }

  void add_largest_distances() {
    if (!report_.fidelity) return;
    const auto add = [&](const std::optional<Vector3d>& place, const std::optional<double>& distance,
                         const char* what) {
      if (!place || !distance || !place->allFinite()) return -1;
      result_.scene.marks.push_back({*place, fmt::format("{} {:.4g}", what, *distance), "#1f5a99"});
      Box around;
      around.add(*place);
      io::SceneTarget target;
      target.text = fmt::format("the largest distance from {} is at least {}, at ({}, {}, {})", what,
                                *distance, place->x(), place->y(), place->z());
      return add_target(std::move(target), around);
    };
    const Fidelity& f = *report_.fidelity;
    result_.to_surface = add(f.mesh_to_surface_at, f.mesh_to_surface, "mesh to surface");
    result_.to_mesh = add(f.surface_to_mesh_at, f.surface_to_mesh, "surface to mesh");
  }

  const Report& report_;
  const PageSubject& subject_;
  const TetMesh& mesh_;
  ReportScene result_;
  DrawnMesh drawn_;
  Box box_;
  std::vector<Index> named_, ring_;  // tetrahedra, ascending
};

}  // namespace

ReportScene report_scene(const Report& report, const PageSubject& subject, std::size_t most_bytes) {
  return Builder(report, subject).build(most_bytes);
}

}  // namespace tetproof::verify
