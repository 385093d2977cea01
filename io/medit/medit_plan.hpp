// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which keyword of Medit's files stores which part of a document. The writer and the list of what is
// held share this plan.
#pragma once

#include <array>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/medit/medit_keywords.hpp"
#include "io/medit/medit_solution_write.hpp"

namespace tetproof::io {

/// The keyword under which the elements of a block are written, and how many of their nodes are written.
/// Null: they are left out.
struct MeditPlace {
  const MeditKeyword* keyword = nullptr;
  int nodes = 0;
};
MeditPlace medit_place(const ElementBlock& block);

/// Returns the reference of a block's elements: their first group; 0: they have none.
std::int64_t medit_reference(const Document& document, const ElementBlock& block);

/// Whether references are reals that the text form can have and that our reader reads back. Not so if all are
/// integers.
bool are_real_medit_references(const Values& values);
inline constexpr double largest_medit_real_reference = 9e15;

/// The nodes (or else elements) that values mark, where they do nothing else and the form of file has a
/// keyword for it: those that they list, or those of which an integer for each is 1 and not 0. None: they
/// are no marks.
std::vector<Index> medit_marked(const Document& document, const Values& values, bool of_nodes, bool binary);

/// Whether a section is written. This needs that the reader reads it back as it is.
bool writes_medit_section(const Section& section, bool binary);

struct MeditPlan {
  /// Whether the numbers in `Document::unknown` still name nothing when nodes and elements count up from 1.
  bool numbers_stay = false;
  const Values* references = nullptr;  ///< the values that nodes have as references; null: none
  MeditFields fields{};                ///< the values of vertices that go into a .sol
  /// Those of all elements of a kind: behind them in the .sol, or without any in the mesh.
  std::vector<MeditSolutionPart> element_fields{};
  /// The blocks under each keyword of `medit_elements()`.
  std::array<std::vector<const ElementBlock*>, 16> lists{};
  /// The positions in `lists` of the keywords that have blocks, in the order of the document: that of a file
  /// comes back.
  std::vector<std::size_t> order{};
};
MeditPlan medit_plan(const Document& document);
/// Returns the reference of a node, where it is an integer; 0: it has none, or a real.
std::int64_t medit_reference_of(const MeditPlan& plan, std::size_t node);
Holds medit_holds(const Document& document, const MeditPlan& plan, bool binary);

void write_medit(AtomicFile& file, const Document& document, const MeditPlan& plan, bool binary);

}  // namespace tetproof::io
