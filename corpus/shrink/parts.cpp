// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/parts.hpp"

#include <Eigen/Geometry>

#include "corpus/shrink/editable_surface.hpp"
#include "verify/surface.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::corpus {
namespace {

// Whether part `inner` lies inside part `outer`: exact.
bool encloses(const TriangleSurface& surface, const std::vector<Index>& of_triangle, Index outer,
              Index inner) {
  TriangleSurface both;
  both.vertices = surface.vertices;
  for (const Index part : {outer, inner})
    for (std::size_t t = 0; t < of_triangle.size(); ++t)
      if (of_triangle[t] == part) both.triangles.push_back(surface.triangles[t]);
  // The orientations may disagree on what is inside: a note of the judge, and no fault.
  const verify::SurfaceReport report = verify::judge_surface(without_unused_vertices(both));
  return report.components.at(1).depth == 1;
}

}  // namespace

Parts find_parts(const TriangleSurface& surface) {
  Parts parts;
  const verify::EdgeMatching edges = verify::match_edges(surface.triangles, surface.vertices.size());
  parts.of_triangle = verify::find_sheets(surface.triangles, edges.mate).of_triangle;
  const auto components = verify::judge_surface(surface).components;  // in the same order
  std::vector<Eigen::AlignedBox3d> boxes(components.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) boxes[parts.of_triangle[t]].extend(surface.vertices[v]);
  const auto n = static_cast<Index>(components.size());
  std::vector<std::vector<Index>> inside(components.size());  // the parts one deeper
  std::vector<Index> order;                                   // a solid is followed by what lies inside it
  for (Index inner = 0; inner < n; ++inner) {
    if (components[inner].depth == 0) order.push_back(inner);
    for (Index outer = 0; outer < n && components[inner].depth > 0; ++outer)
      if (components[outer].depth == components[inner].depth - 1 && boxes[outer].contains(boxes[inner]) &&
          encloses(surface, parts.of_triangle, outer, inner))
        inside[outer].push_back(inner);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<Index> children = inside[order[i]];
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(i) + 1, children.begin(), children.end());
  }
  for (const Index part : order) {
    std::vector<Index> set{part};
    set.insert(set.end(), inside[part].begin(), inside[part].end());
    (components[part].depth % 2 == 0 ? parts.solids : parts.cavities).push_back(std::move(set));
  }
  return parts;
}

TriangleSurface without_parts(const TriangleSurface& surface, const Parts& parts,
                              const std::vector<std::uint8_t>& removed) {
  TriangleSurface rest;
  rest.vertices = surface.vertices;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (!removed[parts.of_triangle[t]]) rest.triangles.push_back(surface.triangles[t]);
  return without_unused_vertices(rest);
}

}  // namespace tetproof::corpus
