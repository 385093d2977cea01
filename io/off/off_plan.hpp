// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which parts of a document an OFF file stores. The writer and the list of what is held share this
// plan.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/surface/rows.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

struct OffPlan {
  /// Whether the document was read from an OFF. Only then are faces of one and two corners and the title
  /// written: many programs refuse such faces, and refuse comments.
  bool came_from_off = false;
  const Values *normal = nullptr, *color = nullptr, *texture = nullptr;  ///< of nodes; null: none
  RowsOf face_colors;
};
OffPlan off_plan(const Document& document);
Holds off_holds(const Document& document, const OffPlan& plan);

}  // namespace tetproof::io
