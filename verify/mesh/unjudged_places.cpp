// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/unjudged_places.hpp"

#include <CGAL/box_intersection_d.h>

#include "verify/triangles/box.hpp"

namespace tetproof::verify {

// Elements that were not read are part of the mesh also if only the tetrahedra are asked for: they may be
// tetrahedra.
UnjudgedPlaces::UnjudgedPlaces(const TetMesh& mesh, const Boundary& boundary, const Options& options)
    : any_(!options.unjudged.points_known || (!options.only_tets && !options.unjudged.elements.empty())),
      known_(options.only_tets ? options.unjudged.points_known : options.unjudged.places_known),
      boxes_(&options.unjudged.boxes) {
  if (!any_ || !known_) return;
  at_.assign(mesh.points.size(), 0);
  std::vector<Box> vertices, elements;
  for (const Triangle& face : boundary.triangles)
    for (const Index v : face) {
      if (at_[static_cast<std::size_t>(v)]++ > 0) continue;  // collects each vertex once
      const Eigen::Vector3d& p = mesh.points[static_cast<std::size_t>(v)];
      vertices.push_back({{p.x(), p.y(), p.z()}, {p.x(), p.y(), p.z()}, static_cast<std::size_t>(v)});
    }
  at_.assign(mesh.points.size(), 0);
  for (const auto& [low, high] : *boxes_)
    elements.push_back(
        {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}, mesh.points.size() + elements.size()});
  CGAL::box_intersection_d(vertices.begin(), vertices.end(), elements.begin(), elements.end(),
                           [this](const Box& vertex, const Box&) { at_[vertex.number] = 1; });
}

}  // namespace tetproof::verify
