// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/touching_parts.hpp"

#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "verify/mesh/parts.hpp"
#include "verify/mesh/tet_pairs.hpp"
#include "verify/triangles/box.hpp"
#include "verify/triangles/common_area.hpp"

namespace tetproof::verify {
namespace {

using Parts = std::array<Index, 2>;
using Candidates = std::map<Parts, std::vector<std::array<Index, 2>>>;

Parts ascending(Index s, Index t) {
  return s < t ? Parts{s, t} : Parts{t, s};
}

// Removes the parts that overlap. Only tetrahedra near a place where two boxes of parts meet are compared.
// False if these are too many.
bool remove_overlapping(const TetMesh& mesh, const std::vector<Index>& part_of_tet, Candidates& candidates) {
  std::map<Index, Eigen::AlignedBox3d> box_of_part;
  for (const auto& [parts, faces] : candidates)
    for (const Index part : parts) box_of_part[part];
  const auto box = [&](std::size_t t) {
    Eigen::AlignedBox3d all;
    for (const Index v : mesh.tets[t]) all.extend(mesh.points[v]);
    return all;
  };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (const auto part = box_of_part.find(part_of_tet[t]); part != box_of_part.end())
      part->second.extend(box(t));
  std::map<Index, std::vector<Eigen::AlignedBox3d>> places;  // of each part, where it may meet another one
  for (const auto& [parts, faces] : candidates) {
    const Eigen::AlignedBox3d place = box_of_part[parts[0]].intersection(box_of_part[parts[1]]);
    for (const Index part : parts) places[part].push_back(place);
  }
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto part = places.find(part_of_tet[t]);
    if (part == places.end()) continue;
    const Eigen::AlignedBox3d own = box(t);
    if (std::none_of(part->second.begin(), part->second.end(),
                     [&](const Eigen::AlignedBox3d& place) { return place.intersects(own); }))
      continue;
    boxes.push_back(
        {{own.min().x(), own.min().y(), own.min().z()}, {own.max().x(), own.max().y(), own.max().z()}, t});
  }
  std::size_t compared = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (compared > most_compared_tets) return;
    const Parts parts = ascending(part_of_tet[a.number], part_of_tet[b.number]);
    if (parts[0] == parts[1]) return;
    const auto pair = candidates.find(parts);
    if (pair == candidates.end()) return;
    if (++compared <= most_compared_tets && overlap(mesh.points, mesh.tets[a.number], mesh.tets[b.number]))
      candidates.erase(pair);
  });
  return compared <= most_compared_tets;
}

}  // namespace

std::optional<std::size_t> Interfaces::between(Index s, Index t) const {
  if (touching.empty()) return std::nullopt;
  const Parts parts =
      ascending(part_of_tet[static_cast<std::size_t>(s)], part_of_tet[static_cast<std::size_t>(t)]);
  const auto found = std::lower_bound(touching.begin(), touching.end(), parts,
                                      [](const TouchingParts& a, const Parts& b) { return a.parts < b; });
  if (found == touching.end() || found->parts != parts) return std::nullopt;
  return static_cast<std::size_t>(found - touching.begin());
}

Interfaces find_touching_parts(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                               const Boundary& boundary, std::span<const std::array<Index, 2>> pairs,
                               const std::function<bool(Index, Index)>& explained,
                               std::span<const std::array<FaceId, 2>> cracks,
                               const std::vector<Index>& not_positive) {
  std::vector<std::array<Index, 2>> back;
  for (const auto& [s, t] : pairs)
    if (back_to_back(mesh.points, boundary.triangles[s], boundary.triangles[t]) && !explained(s, t))
      back.push_back({s, t});
  Interfaces result;
  if (back.empty()) return result;
  result.part_of_tet = parts_of(mesh, excluded, cracks);
  std::set<Index> faulty;
  for (const Index t : not_positive) faulty.insert(result.part_of_tet[static_cast<std::size_t>(t)]);
  Candidates candidates;
  for (const auto& [s, t] : back) {
    const Parts parts = ascending(result.part_of_tet[tet_of(boundary.faces[s])],
                                  result.part_of_tet[tet_of(boundary.faces[t])]);
    if (parts[0] != parts[1] && !faulty.contains(parts[0]) && !faulty.contains(parts[1]))
      candidates[parts].push_back({s, t});
  }
  if (!candidates.empty() && !remove_overlapping(mesh, result.part_of_tet, candidates)) {
    result.given_up = true;
    candidates.clear();
  }
  for (auto& [parts, faces] : candidates) result.touching.push_back({parts, std::move(faces)});
  if (result.touching.empty()) result.part_of_tet.clear();
  return result;
}

}  // namespace tetproof::verify
