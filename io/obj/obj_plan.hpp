// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which statements of an OBJ file store which values of a document. The writer and the list of what is
// held share this plan.
#pragma once

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/obj/obj_names.hpp"
#include "io/surface/rows.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

/// The values that OBJ has a place for; null: none. Those of elements and corners come back only if every
/// element is written.
struct ObjPlan {
  explicit ObjPlan(const Document& document);

  RowsOf behind;  ///< colours and weights, written after the coordinates of nodes
  const Values *texture = nullptr, *normal = nullptr;                         ///< of corners
  const Values *object = nullptr, *material = nullptr, *smoothing = nullptr;  ///< of elements
  GroupWords words;                                                           ///< the words for groups
};
Holds obj_holds(const Document& document, const ObjPlan& plan);

/// Whether a table is the list of material libraries, "mtllib".
bool is_libraries(const Table& table);

}  // namespace tetproof::io
