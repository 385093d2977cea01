// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of TetGen's files share: a set of files that appear together, and lines of numbers in
// them.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/text_output.hpp"
#include "io/document.hpp"
#include "io/tetgen/tetgen_plan.hpp"
#include "io/tetgen/tetgen_set.hpp"

namespace tetproof::io {

/// The files of a set, of which the first one added keeps the supplement.
class TetgenFiles {
 public:
  TetgenFiles(const TetgenPath& set, const std::string& supplement) : set_(set), supplement_(supplement) {}
  AtomicFile& add(const std::string& ending);
  /// All of them appear.
  void commit();

 private:
  const TetgenPath& set_;
  const std::string& supplement_;
  std::deque<AtomicFile> files_;
  std::vector<std::string> endings_;
};

/// The numbers of an item behind a blank each; none for null.
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

/// "COUNT 3 ATTRIBUTES MARKERS" and a line each, as in .node and .poly.
void write_tetgen_nodes(AtomicFile&, const Document&, const TetgenPlan&);
/// An .edge.
void write_tetgen_edges(AtomicFile&, const Document&, const TetgenPlan&);
/// .mtr and .var, where there is something for them.
void write_tetgen_fields(TetgenFiles&, const Document&, const TetgenPlan&);
/// .v.node, .v.edge, .v.face and .v.cell.
void write_tetgen_voronoi(TetgenFiles&, const Voronoi&);

/// A warning of files of the set that are there already and are not among those `written`, but that our
/// reader and TetGen `read` together with them; empty: there are none.
std::string tetgen_left_over(const TetgenPath& set, const std::vector<std::string>& written,
                             const std::vector<std::string>& read);

}  // namespace tetproof::io
