// SPDX-License-Identifier: GPL-3.0-or-later
// Checks numbers and coordinates: the conditions without which a tetrahedron has no geometry.
#include <fmt/core.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "verify/checks/evidence.hpp"
#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {
namespace {

bool less(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : p.z() < q.z();
}

// Sets of finite points with equal coordinates (-0 equals 0). Each set ascends; the sets are sorted by their
// first point.
std::vector<std::vector<Index>> equal_points(const std::vector<Eigen::Vector3d>& points) {
  struct Record {
    std::uint64_t hash;
    Index point;
  };
  std::vector<Record> records(points.size());
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k)
      hash = (hash ^ std::bit_cast<std::uint64_t>(points[i][k] + 0.0)) * 0x9e3779b97f4a7c15u,
      hash ^= hash >> 29;
    records[i] = {hash, static_cast<Index>(i)};
  });
  tbb::parallel_sort(records.begin(), records.end(), [](const Record& a, const Record& b) {
    return a.hash != b.hash ? a.hash < b.hash : a.point < b.point;
  });
  std::vector<std::vector<Index>> groups;
  for (auto i = records.begin(); i < records.end();) {
    auto j = i + 1;
    while (j < records.end() && j->hash == i->hash) ++j;
    if (j - i > 1) {
      std::vector<Index> same;
      for (auto k = i; k < j; ++k)
        if (points[k->point].allFinite()) same.push_back(k->point);
      std::stable_sort(same.begin(), same.end(),
                       [&](Index a, Index b) { return less(points[a], points[b]); });
      for (auto a = same.begin(); a < same.end();) {
        auto b = a + 1;
        while (b < same.end() && points[*b] == points[*a]) ++b;
        if (b - a > 1) groups.emplace_back(a, b);
        a = b;
      }
    }
    i = j;
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
}

}  // namespace

PointEvidence examine_points(const TetMesh& mesh, const Record& record) {
  const auto points = static_cast<Index>(mesh.points.size());
  const auto in_range = [=](Index v) { return v >= 0 && v < points; };
  enum Fault { out_of_range, not_finite, repeats };
  std::vector<std::uint8_t> finite(mesh.points.size());
  tbb::parallel_for(std::size_t{0}, mesh.points.size(),
                    [&](std::size_t i) { finite[i] = mesh.points[i].allFinite(); });
  const auto faults = collect_in_order<std::pair<Index, Fault>>(
      mesh.tets.size(), 65536,
      [&](std::size_t begin, std::size_t end, std::vector<std::pair<Index, Fault>>& found) {
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c, d] = mesh.tets[t];
          const auto tet = static_cast<Index>(t);
          if (!in_range(a) || !in_range(b) || !in_range(c) || !in_range(d))
            found.emplace_back(tet, out_of_range);
          else if (!finite[a] || !finite[b] || !finite[c] || !finite[d])
            found.emplace_back(tet, not_finite);
          if (a == b || a == c || a == d || b == c || b == d || c == d) found.emplace_back(tet, repeats);
        }
      });
  PointEvidence evidence;
  if (!faults.empty()) evidence.excluded.assign(mesh.tets.size(), 0);
  for (const auto& [t, fault] : faults) {
    evidence.excluded[t] = 1;
    if (fault == out_of_range) evidence.out_of_range.push_back(t);
    if (fault == repeats) evidence.repeating.push_back(t);
    if (fault == not_finite)
      for (const Index v : mesh.tets[t])
        if (!finite[v]) evidence.not_finite.emplace_back(v, t);
  }
  std::sort(evidence.not_finite.begin(), evidence.not_finite.end());
  if (record.wants(Check::duplicate_point) || record.wants(Check::duplicate_tet) ||
      record.wants(Check::crack))
    evidence.same_place = equal_points(mesh.points);
  return evidence;
}

void check_points(const TetMesh& mesh, const PointEvidence& evidence, const Unjudged& unjudged,
                  Record& record) {
  const auto points = static_cast<Index>(mesh.points.size());
  const auto in_range = [=](Index v) { return v >= 0 && v < points; };
  if (record.wants(Check::index_range))
    record[Check::index_range] = {
        .count = evidence.out_of_range.size(),
        .finding = [&](std::size_t i) { return Finding{.tets = {evidence.out_of_range[i]}}; },
        .describe =
            [in_range, &mesh](std::size_t, Finding& finding) {
              for (const Index v : mesh.tets[finding.tets[0]])
                if (!in_range(v)) finding.vertices.push_back(v);
              finding.what = finding.vertices.size() == 1
                                 ? "names a point that does not exist"
                                 : fmt::format("names {} points that do not exist", finding.vertices.size());
            }};
  if (record.wants(Check::finite_coordinates)) {
    const auto& not_finite = evidence.not_finite;
    std::vector<Finding> vertices;
    for (std::size_t i = 0; i < not_finite.size(); ++i) {
      const auto& [vertex, tet] = not_finite[i];
      if (i == 0 || vertex != not_finite[i - 1].first) vertices.push_back({.vertices = {vertex}});
      std::vector<Index>& tets = vertices.back().tets;
      if (tets.empty() || tets.back() != tet) tets.push_back(tet);
    }
    record[Check::finite_coordinates] = Suspects::complete(std::move(vertices));
    record[Check::finite_coordinates].describe = [&mesh](std::size_t, Finding& finding) {
      finding.what = "its coordinates are not finite: " + place(mesh.points[finding.vertices[0]]);
    };
  }
  if (record.wants(Check::repeated_vertex))
    record[Check::repeated_vertex] = {
        .count = evidence.repeating.size(),
        .finding = [&](std::size_t i) { return Finding{.tets = {evidence.repeating[i]}}; },
        .describe =
            [&mesh](std::size_t, Finding& finding) {
              std::array<Index, 4> tet = mesh.tets[finding.tets[0]];
              std::sort(tet.begin(), tet.end());
              for (int k = 1; k < 4; ++k)
                if (tet[k] == tet[k - 1] && (finding.vertices.empty() || finding.vertices.back() != tet[k]))
                  finding.vertices.push_back(tet[k]);
              finding.what = "names a point more than once";
            }};
  if (record.wants(Check::duplicate_point))
    record[Check::duplicate_point] = {
        .count = evidence.same_place.size(),
        .finding = [&](std::size_t i) { return Finding{.vertices = evidence.same_place[i]}; },
        .describe =
            [&mesh](std::size_t, Finding& finding) {
              finding.point = mesh.points[finding.vertices[0]];
              finding.what = fmt::format("{} points with the same coordinates", finding.vertices.size());
            }};
  if (!unjudged.points_known) {
    record.could_not_run({Check::unused_point}, "elements that were not read may use any point");
  }
  if (record.wants(Check::unused_point)) {
    std::vector<std::uint8_t> used(mesh.points.size(), 0);
    for (const auto& tet : mesh.tets)
      for (const Index v : tet)
        if (in_range(v)) used[v] = 1;
    for (const Index v : unjudged.points)
      if (in_range(v)) used[v] = 1;
    std::vector<Index> unused;
    for (Index v = 0; v < points; ++v)
      if (!used[v]) unused.push_back(v);
    const std::size_t count = unused.size();
    record[Check::unused_point] = {
        .count = count,
        .finding = [unused = std::move(unused)](std::size_t i) { return Finding{.vertices = {unused[i]}}; },
        .describe = [](std::size_t, Finding& finding) { finding.what = "belongs to no tetrahedron"; }};
  }
}

}  // namespace tetproof::verify
