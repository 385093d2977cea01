// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which solids of an STL file store which elements of a document. The writer and the list of what is
// held share this plan.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/stl/stl_solids.hpp"
#include "io/surface/cutting.hpp"

namespace tetproof::io {

/// A solid of the text form. The binary form has no solids; for it only the order of the facets matters.
struct StlSolid {
  StlGroup group;
  std::vector<const ElementBlock*> blocks;
};

struct StlPlan {
  std::vector<StlSolid> solids;
  /// Values "attribute" of every element, from 0 to 65535 and not all 0, if the file is binary and every
  /// element is a triangle in it; null: none.
  const Values* attributes = nullptr;
};
StlPlan stl_plan(const Document& document, bool binary);
Holds stl_holds(const Document& document, const StlPlan& plan, bool binary);

/// Cuts polygons into the triangles that are written, by the rules of io/surface/cutting.hpp. Elements come
/// in the document's order.
class StlCutter {
 public:
  explicit StlCutter(const Document& document) : document_(document), facets_(document) {}

  /// Appends the triangles of element `e` of a block; false: it is not written, because it is no face, names
  /// a node that does not exist, or crosses itself. All triangles of a facet of several polygons come with
  /// its first face.
  bool cut(const ElementBlock& block, std::size_t e, std::vector<std::array<Index, 3>>& triangles);
  const Bends& bends() const { return bends_; }

 private:
  bool cut_facet(const Facet& facet, std::size_t element, std::vector<std::array<Index, 3>>& triangles);

  const Document& document_;
  const Facets facets_;
  const Facet* last_facet_ = nullptr;  // cut with its first face, an element
  std::size_t first_face_ = 0;
  bool last_is_cut_ = false;
  Cut cut_;
  Bends bends_;
};

}  // namespace tetproof::io
