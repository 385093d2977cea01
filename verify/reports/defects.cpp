// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/defects.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"

namespace tetproof::verify {
namespace {

constexpr int point_element = 15;  // Gmsh's number

class Defects {
 public:
  Defects(const TetMesh& mesh, const Numbering& numbering, const Report& report)
      : mesh_(mesh), numbering_(numbering), place_(mesh.points.size(), -1), marked_(report.checks.size()) {
    add_tetrahedra(report);
    tets_ = part_.tets.size();
    for (std::size_t c = 0; c < report.checks.size(); ++c)
      for (const Finding& finding : report.checks[c].findings) add_finding(c, finding);
  }

  Document document(const Report& report) const {
    Document all = document_of(part_);
    if (!witnesses_.empty()) {
      all.blocks.push_back({.type = point_element,
                            .dim = 0,
                            .entity = 1,
                            .nodes_each = 1,
                            .count = witnesses_.size(),
                            .first = tets_,
                            .nodes = all.connectivity.size()});
      all.connectivity.insert(all.connectivity.end(), witnesses_.begin(), witnesses_.end());
    }
    all.element_values.push_back(integers("number", numbers_));
    for (std::size_t c = 0; c < report.checks.size(); ++c) {
      if (report.checks[c].findings.empty()) continue;
      std::vector<std::int64_t> values(numbers_.size(), 0);
      for (const std::size_t element : marked_[c]) values[element] = 1;
      all.element_values.push_back(integers(info(report.checks[c].check).id, std::move(values)));
    }
    return all;
  }

 private:
  static Values integers(const char* name, std::vector<std::int64_t> values) {
    return {.name = name, .components = 1, .reals = {}, .integers = std::move(values)};
  }

  bool in_range(Index v) const { return v >= 0 && v < static_cast<Index>(mesh_.points.size()); }

  // The position in `part_` of a point of the mesh, which is added when first asked for.
  Index point(Index v) {
    if (place_[v] < 0) {
      place_[v] = static_cast<Index>(part_.points.size());
      part_.points.push_back(mesh_.points[v]);
    }
    return place_[v];
  }

  // Adds all tetrahedra that share a vertex with an element that a finding names.
  void add_tetrahedra(const Report& report) {
    std::vector<std::uint8_t> broken_at(mesh_.points.size(), 0);
    const auto touch = [&](Index v) {
      if (in_range(v)) broken_at[v] = 1;
    };
    for (const CheckResult& result : report.checks)
      for (const Finding& finding : result.findings) {
        for (const Index t : finding.tets) std::for_each(mesh_.tets[t].begin(), mesh_.tets[t].end(), touch);
        for (const auto& face : finding.faces) std::for_each(face.begin(), face.end(), touch);
        std::for_each(finding.vertices.begin(), finding.vertices.end(), touch);
      }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      std::array<Index, 4> tet = mesh_.tets[t];
      // A viewer cannot draw a tetrahedron without a point.
      if (!std::all_of(tet.begin(), tet.end(), [&](Index v) { return in_range(v); })) continue;
      if (std::none_of(tet.begin(), tet.end(), [&](Index v) { return broken_at[v]; })) continue;
      for (Index& v : tet) v = point(v);
      part_.tets.push_back(tet);
      original_.push_back(static_cast<Index>(t));
      numbers_.push_back(numbering_.tet(static_cast<Index>(t)));
    }
  }

  void add_finding(std::size_t check, const Finding& finding) {
    for (const Index t : finding.tets) {
      const auto at = std::lower_bound(original_.begin(), original_.end(), t);
      if (at != original_.end() && *at == t)
        marked_[check].push_back(static_cast<std::size_t>(at - original_.begin()));
      else  // the points that it has
        for (const Index v : mesh_.tets[t]) add_vertex(check, v);
    }
    for (const Index v : finding.vertices) add_vertex(check, v);
    if (!finding.point || !finding.point->allFinite()) return;
    if (finding.vertices.size() == 1 && in_range(finding.vertices[0]) &&
        mesh_.points[finding.vertices[0]] == *finding.point)
      return;  // the vertex itself
    part_.points.push_back(*finding.point);
    add_witness(check, static_cast<Index>(part_.points.size()) - 1, -1);
  }

  void add_vertex(std::size_t check, Index v) {
    if (in_range(v) && mesh_.points[v].allFinite()) add_witness(check, point(v), numbering_.point(v));
  }

  void add_witness(std::size_t check, Index at, std::int64_t number) {
    marked_[check].push_back(tets_ + witnesses_.size());
    witnesses_.push_back(at);
    numbers_.push_back(number);
  }

  const TetMesh& mesh_;
  const Numbering& numbering_;
  TetMesh part_;
  std::vector<Index> place_;     // position of each point of the mesh in `part_`; -1: not there
  std::vector<Index> original_;  // position of each tetrahedron of `part_` in the mesh
  std::size_t tets_ = 0;
  std::vector<Index> witnesses_;                  // points of `part_` that are elements of their own
  std::vector<std::int64_t> numbers_;             // of all elements, in the file
  std::vector<std::vector<std::size_t>> marked_;  // elements, by check
};

}  // namespace

Document defects_document(const TetMesh& mesh, const Numbering& numbering, const Report& report) {
  return Defects(mesh, numbering, report).document(report);
}

void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report) {
  write_document(path, defects_document(mesh, numbering, report));
}

}  // namespace tetproof::verify
