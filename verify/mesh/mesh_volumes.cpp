// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/mesh_volumes.hpp"

namespace tetproof::verify {

Shape shape_of(const Boundary& boundary, const MeshVolumes& volumes) {
  Shape shape;
  shape.boundary_faces = static_cast<std::int64_t>(boundary.faces.size());
  shape.volume = volumes.sets.weighted_sum(volumes.all);
  if (!boundary.closed || boundary.triangles.size() != boundary.faces.size()) return shape;
  const std::vector<Sheet>& sheets = boundary.sheets.sheets;
  shape.components = static_cast<std::int64_t>(sheets.size());
  shape.cavities = 0;
  shape.genus = 0;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    *shape.cavities += volumes.sets.sign(s) < 0;
    *shape.genus += sheets[s].genus();
    shape.genus_per_component.push_back(sheets[s].genus());
  }
  return shape;
}

}  // namespace tetproof::verify
