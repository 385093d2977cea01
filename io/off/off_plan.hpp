// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which parts of a document an OFF file stores. The writer and the list of what is held share this
// plan.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

struct OffPlan {
  /// Whether faces of one and two corners and the title are written. Many programs take such a face for an
  /// error, and a comment too, so only a document that was read from an OFF is written with them.
  bool came_from_off = false;
  const Values *normal = nullptr, *color = nullptr, *texture = nullptr;  ///< of nodes; null: none
  RowsOf face_colors;
};
OffPlan off_plan(const Document& document);
Holds off_holds(const Document& document, const OffPlan& plan);

}  // namespace tetproof::io
