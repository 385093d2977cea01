// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the writers of TetGen's files: a set of files that appear together, and lines of numbers in them.
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/text_output.hpp"
#include "io/document.hpp"
#include "io/tetgen/tetgen_plan.hpp"
#include "io/tetgen/tetgen_set.hpp"

namespace tetproof::io {

/// The files of a set. The supplement goes into the first one added.
class TetgenFiles {
 public:
  TetgenFiles(const TetgenPath& set, const std::string& supplement) : set_(set), supplement_(supplement) {}
  AtomicFile& add(const std::string& ending);
  /// Makes all of them appear.
  void commit();

 private:
  const TetgenPath& set_;
  const std::string& supplement_;
  std::deque<AtomicFile> files_;
  std::vector<std::string> endings_;
};

/// Puts the numbers of an item, each after a blank; nothing if `values` is null.
inline char* put_values(char* to, const Values* values, std::size_t item) {
  if (!values) return to;
  const std::size_t each = static_cast<std::size_t>(values->components), from = item * each;
  for (std::size_t k = 0; k < each; ++k) {
    to = put(to, ' ');
    to = values->integers.empty() ? put(to, values->reals[from + k]) : put(to, values->integers[from + k]);
  }
  return to;
}
inline std::size_t columns(const Values* values) {
  return values ? static_cast<std::size_t>(values->components) : 0;
}
inline std::size_t columns(const TetgenTags& tags) {
  return tags.values ? columns(tags.values) : tags.groups ? 1 : 0;
}

/// Puts the tags of element i of a block, which is `item` in its list.
inline char* put_tags(char* to, const TetgenTags& tags, const Document& document, const ElementBlock& block,
                      std::size_t i, std::size_t item) {
  if (!tags.groups) return put_values(to, tags.values, item);
  return put(put(to, ' '), tags.group_of(document, block, block.first + i));
}

/// Writes "COUNT 3 ATTRIBUTES MARKERS" and a line for each node, as in .node and .poly.
void write_tetgen_nodes(AtomicFile&, const Document&, const TetgenPlan&);
/// Writes an .edge.
void write_tetgen_edges(AtomicFile&, const Document&, const TetgenPlan&);
/// Writes .mtr and .var if there is content for them.
void write_tetgen_fields(TetgenFiles&, const Document&, const TetgenPlan&);
/// Writes .v.node, .v.edge, .v.face and .v.cell.
void write_tetgen_voronoi(TetgenFiles&, const Voronoi&);

/// Returns a warning of old files that would be read together with the new ones: files of the set that exist,
/// are not among those `written`, and are among those that TetGen and our reader `read`. Empty: there are
/// none.
std::string tetgen_left_over(const TetgenPath& set, const std::vector<std::string>& written,
                             const std::vector<std::string>& read);

}  // namespace tetproof::io
