// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the boundary's components with the surface's, one by one.
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "verify/checks/surface_comparison.hpp"
#include "verify/checks/surface_names.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t most_samples = 64;  // faces of a sheet whose nearest triangle is searched for

// A sheet of the boundary that is not the mesh's own.
struct Part {
  Index sheet;
  Index face;              // its first face in the comparison
  std::int64_t component;  // the surface's component that most of its faces are nearest to
};

std::vector<Part> parts_of(const Comparison& c) {
  std::map<Index, std::vector<Index>> faces;
  for (std::size_t f = 0; f < c.faces.size(); ++f) faces[c.sheets[f]].push_back(static_cast<Index>(f));
  std::vector<Part> parts;
  for (const auto& [sheet, all] : faces) {
    std::map<Index, std::int64_t> votes;
    const std::size_t samples = std::min(most_samples, all.size());
    Index guess = -1;
    for (std::size_t s = 0; s < samples; ++s) {
      const auto [p, q, r] = c.mesh_tree->corners(all[s * all.size() / samples]);
      guess = c.surface_tree->nearest((p + q + r) / 3, guess).triangle;
      ++votes[c.judged.component_of[static_cast<std::size_t>(guess)]];
    }
    const auto most = std::max_element(votes.begin(), votes.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    parts.push_back({sheet, all[0], most->first});
  }
  return parts;
}

}  // namespace

void check_topology(const Comparison& c, Record& record) {
  const MeshVolumes& volumes = c.judged_mesh.volumes;
  const Boundary& boundary = c.judged_mesh.boundary;
  const std::vector<SurfaceComponent>& components = c.judged.report.components;
  const std::vector<Sheet>& sheets = boundary.sheets.sheets;
  const bool outside = c.judged_mesh.options.region == Region::outside;
  const std::vector<Part> parts = parts_of(c);
  std::vector<Finding> differences;
  const auto differs = [&](Finding finding, std::string what) {
    finding.what = std::move(what);
    differences.push_back(std::move(finding));
  };
  const auto name = [&](std::size_t component) {
    return fmt::format("the surface's component {} ({} and {} more)", component,
                       triangle_name(c.judged.numbering, components[component].first_triangle),
                       components[component].triangles - 1);
  };
  // In a mesh around the solid, the boundary at a cavity of the solid encloses a positive volume.
  const auto is_cavity = [&](const Part& part) {
    return (volumes.sets.sign(static_cast<std::size_t>(part.sheet)) < 0) != outside;
  };

  // The partner of a component is one of the sheets near it: a cavity if the component is one, and of those
  // the sheet with the most faces.
  std::vector<const Part*> partner(components.size(), nullptr);
  const auto better = [&](const Part& part, const Part& than) {
    const bool cavity = components[static_cast<std::size_t>(part.component)].depth % 2 == 1;
    if (const bool right = is_cavity(part) == cavity; right != (is_cavity(than) == cavity)) return right;
    return sheets[static_cast<std::size_t>(part.sheet)].triangles >
           sheets[static_cast<std::size_t>(than.sheet)].triangles;
  };
  for (const Part& part : parts) {
    const Part*& best = partner[static_cast<std::size_t>(part.component)];
    if (!best || better(part, *best)) best = &part;
  }
  bool paired = true;
  for (const Part& part : parts) {
    const auto component = static_cast<std::size_t>(part.component);
    if (partner[component] == &part) continue;
    paired = false;
    differs(
        c.at_face(part.face),
        fmt::format(
            "a component of the boundary, of {} faces with this one, is none of the surface's: near it is "
            "{}, which has its counterpart",
            sheets[static_cast<std::size_t>(part.sheet)].triangles, name(component)));
  }
  for (std::size_t component = 0; component < components.size(); ++component)
    if (!partner[component]) {
      paired = false;
      const Triangle& t = c.surface.triangles[static_cast<std::size_t>(components[component].first_triangle)];
      differs({.point = c.surface.vertices[static_cast<std::size_t>(t[0])]},
              fmt::format("{} has no counterpart in the boundary; this is a vertex of it", name(component)));
    }

  std::vector<int> depths;
  if (paired)
    depths = nesting_depths(c.judged_mesh.mesh.points, boundary.boundary_triangles(), boundary.sheets);
  for (std::size_t component = 0; component < components.size(); ++component) {
    if (!partner[component]) continue;
    const Part& part = *partner[component];
    const std::int64_t genus = sheets[static_cast<std::size_t>(part.sheet)].genus();
    if (genus != components[component].genus)
      differs(c.at_face(part.face),
              fmt::format("the boundary's component with this face has genus {}, {} has {}", genus,
                          name(component), components[component].genus));
    const bool cavity = is_cavity(part), right = components[component].depth % 2 == 1;
    if (cavity != right)
      differs(c.at_face(part.face),
              fmt::format("the boundary's component with this face bounds {}, {} {}",
                          cavity ? "a cavity of the solid" : "the solid from outside", name(component),
                          right ? "a cavity" : "the solid from outside"));
    if (!paired || cavity != right) continue;
    const int depth = depths[static_cast<std::size_t>(part.sheet)] - outside;
    if (depth != components[component].depth)
      differs(c.at_face(part.face),
              fmt::format("the boundary's component with this face lies in {} others{}, {} in {}", depth,
                          outside ? " (without the outer boundary)" : "", name(component),
                          components[component].depth));
  }
  record[Check::topology] = Suspects::complete(std::move(differences));
}

}  // namespace tetproof::verify
