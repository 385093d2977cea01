// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the plan of TetGen's mesh files and the plan of its .poly and .smesh: lists of elements, and the
// values that belong to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen_plan.hpp"

namespace tetproof::io {

bool has_shape(const ElementBlock& block, Shape shape);

/// Adds the elements of a block to a list.
void add_block(TetgenList& list, const ElementBlock& block);

/// Whether the elements of a list follow each other in the document from `first` on.
bool is_run(const TetgenList& list, std::size_t first);

/// Whether the numbers of the elements of these lists, one list after the other, count up from `base`.
bool counts_up(const Document& document, std::int64_t base, std::initializer_list<const TetgenList*> lists);

/// Returns the values that all elements of a list have, and no others; null: there are none. `components` 0:
/// any number of components.
const Values* values_of(const Document& document, const TetgenList& list, const char* name, bool reals,
                        int components);

/// What stands in the column `name` behind the elements of a list. `components` 0: any number of components.
TetgenTags tags_of(const Document& document, const TetgenList& list, const char* name, bool reals,
                   int components);

/// Whether a block's first group comes back from the column of its list.
bool groups_come_back(const Document& document, const ElementBlock& block, const TetgenTags& tags);

/// Plans the nodes and their values.
TetgenPlan plan_of_nodes(const Document& document);

/// Adds the values of `plan.edges`, after those of faces or facets.
void plan_edge_values(const Document& document, TetgenPlan& plan);

/// What both plans hold. Elements are not among it: the caller adds them.
Holds tetgen_holds_of_values(const Document& document, const TetgenPlan& plan);

}  // namespace tetproof::io
