// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of numbers and coordinates: what must hold before geometry can be asked.
#include <fmt/core.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "verify/checks/judgement.hpp"
#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {
namespace {

bool less(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : p.z() < q.z();
}

// Sets of finite points with equal coordinates (-0 equals 0), each ascending, by their first.
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

void check_numbers_and_points(Judgement& j) {
  const TetMesh& mesh = j.mesh;
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
  if (!faults.empty()) j.excluded.assign(mesh.tets.size(), 0);
  std::vector<Index> outside, repeating;
  std::vector<std::pair<Index, Index>> infinite;  // vertex, tetrahedron
  for (const auto& [t, fault] : faults) {
    j.excluded[t] = 1;
    if (fault == out_of_range) outside.push_back(t);
    if (fault == repeats) repeating.push_back(t);
    if (fault == not_finite)
      for (const Index v : mesh.tets[t])
        if (!finite[v]) infinite.emplace_back(v, t);
  }
  std::sort(infinite.begin(), infinite.end());

  if (j.wants(Check::index_range))
    j[Check::index_range] = {outside.size(), [=](std::size_t i) { return Finding{.tets = {outside[i]}}; },
                             [=, &mesh](std::size_t i, Finding& finding) {
                               for (const Index v : mesh.tets[outside[i]])
                                 if (!in_range(v)) finding.vertices.push_back(v);
                               finding.what = finding.vertices.size() == 1
                                                  ? "names a point that does not exist"
                                                  : fmt::format("names {} points that do not exist",
                                                                finding.vertices.size());
                             }};
  if (j.wants(Check::finite_coordinates)) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < infinite.size(); ++i)
      if (i == 0 || infinite[i].first != infinite[i - 1].first) starts.push_back(i);
    const std::size_t count = starts.size();
    starts.push_back(infinite.size());
    j[Check::finite_coordinates] = {count,
                                    [=](std::size_t i) {
                                      Finding finding{.vertices = {infinite[starts[i]].first}};
                                      for (std::size_t k = starts[i]; k < starts[i + 1]; ++k)
                                        if (k == starts[i] || infinite[k].second != infinite[k - 1].second)
                                          finding.tets.push_back(infinite[k].second);
                                      return finding;
                                    },
                                    [&mesh](std::size_t, Finding& finding) {
                                      finding.what = "its coordinates are not finite: " +
                                                     place(mesh.points[finding.vertices[0]]);
                                    }};
  }
  if (j.wants(Check::repeated_vertex))
    j[Check::repeated_vertex] = {
        repeating.size(), [=](std::size_t i) { return Finding{.tets = {repeating[i]}}; },
        [=, &mesh](std::size_t i, Finding& finding) {
          std::array<Index, 4> tet = mesh.tets[repeating[i]];
          std::sort(tet.begin(), tet.end());
          for (int k = 1; k < 4; ++k)
            if (tet[k] == tet[k - 1] && (finding.vertices.empty() || finding.vertices.back() != tet[k]))
              finding.vertices.push_back(tet[k]);
          finding.what = "names a point more than once";
        }};
  if (j.wants(Check::duplicate_point) || j.wants(Check::crack)) j.same_place = equal_points(mesh.points);
  if (j.wants(Check::duplicate_point)) {
    j[Check::duplicate_point] = {
        j.same_place.size(), [&j](std::size_t i) { return Finding{.vertices = j.same_place[i]}; },
        [&mesh](std::size_t, Finding& finding) {
          finding.point = mesh.points[finding.vertices[0]];
          finding.what = fmt::format("{} points with the same coordinates", finding.vertices.size());
        }};
  }
  if (j.wants(Check::unused_point)) {
    std::vector<std::uint8_t> used(mesh.points.size(), 0);
    for (const auto& tet : mesh.tets)
      for (const Index v : tet)
        if (in_range(v)) used[v] = 1;
    std::vector<Index> unused;
    for (Index v = 0; v < points; ++v)
      if (!used[v]) unused.push_back(v);
    const std::size_t count = unused.size();
    j[Check::unused_point] = {
        count, [unused = std::move(unused)](std::size_t i) { return Finding{.vertices = {unused[i]}}; },
        [](std::size_t, Finding& finding) { finding.what = "belongs to no tetrahedron"; }};
  }
}

}  // namespace tetproof::verify
