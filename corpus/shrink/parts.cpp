// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/parts.hpp"

#include "corpus/shrink/editable_surface.hpp"
#include "verify/surface.hpp"
#include "verify/triangles/disjoint_sets.hpp"

namespace tetproof::corpus {
namespace {

struct Box {
  Eigen::Vector3d low, high;
  bool contains(const Box& b) const {
    return (low.array() < b.low.array()).all() && (b.high.array() < high.array()).all();
  }
};

// Whether part `inner` lies inside part `outer`: exact.
bool encloses(const TriangleSurface& surface, const std::vector<Index>& of_triangle, Index outer,
              Index inner) {
  TriangleSurface both;
  both.vertices = surface.vertices;
  for (const Index part : {outer, inner})
    for (std::size_t t = 0; t < of_triangle.size(); ++t)
      if (of_triangle[t] == part) both.triangles.push_back(surface.triangles[t]);
  // The orientations may disagree on what is inside, which is a fault, but the depths are then known as well.
  const verify::SurfaceReport report = verify::judge_surface(without_unused_vertices(both));
  return report.components.at(1).depth == 1;
}

}  // namespace

Parts find_parts(const TriangleSurface& surface) {
  Parts parts;
  verify::DisjointSets sets(surface.vertices.size());
  for (const auto& [a, b, c] : surface.triangles) sets.unite(a, b), sets.unite(b, c);
  std::vector<Index> part_of_set(surface.vertices.size(), -1);
  std::vector<Box> boxes;
  for (const auto& t : surface.triangles) {
    Index& part = part_of_set[sets.find(t[0])];
    if (part < 0) {
      part = static_cast<Index>(boxes.size());
      boxes.push_back({surface.vertices[t[0]], surface.vertices[t[0]]});
    }
    parts.of_triangle.push_back(part);
    for (const Index v : t) {
      boxes[part].low = boxes[part].low.cwiseMin(surface.vertices[v]);
      boxes[part].high = boxes[part].high.cwiseMax(surface.vertices[v]);
    }
  }
  // The judge lists the components in the same order: by their lowest triangle.
  const auto components = verify::judge_surface(surface).components;
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
