// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which solids of an STL file store which elements of a document. The writer and the list of what is
// held share this plan.
#pragma once

#include <cstddef>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/stl/stl_solids.hpp"

namespace tetproof::io {

/// A solid of the text form. The binary form has no solids; for it only the order of the facets matters.
struct StlSolid {
  StlGroup group;
  std::vector<const ElementBlock*> blocks;
};

struct StlPlan {
  std::vector<StlSolid> solids;
  /// Values "attribute" of every element, from 0 to 65535 and not all 0, for the binary form; null: none.
  const Values* attributes = nullptr;
};
StlPlan stl_plan(const Document& document);
Holds stl_holds(const Document& document, const StlPlan& plan, bool binary);

/// Returns the corner where the fan of triangles of a polygon of `corners` nodes starts; -1: the polygon is
/// not planar and convex, and is not written.
std::ptrdiff_t start_of_fan(const std::vector<Eigen::Vector3d>& points, const Index* nodes,
                            std::size_t corners);

}  // namespace tetproof::io
