// SPDX-License-Identifier: GPL-3.0-or-later
// Writes points and elements as lines of text, exactly.
#pragma once

#include <string_view>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/text_output.hpp"
#include "io/model/values.hpp"
#include "io/surface/rows.hpp"
#include "io/surface/surface_document.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {

inline char* put(char* to, std::string_view text) {
  return std::copy(text.begin(), text.end(), to);
}

/// Three coordinates without a line end.
inline char* put_point(char* to, const Eigen::Vector3d& point) {
  return put(put(put(put(put(to, point[0]), ' '), point[1]), ' '), point[2]);
}

/// A row of values, with a blank before each number.
inline char* put_row(char* to, const Values& values, std::size_t row) {
  const auto each = static_cast<std::size_t>(values.components);
  for (std::size_t k = row * each; k < (row + 1) * each; ++k)
    to = values.reals.empty() ? put(put(to, ' '), values.integers[k])
                              : put_decimal(put(to, ' '), values.reals[k]);
  return to;
}

/// Writes the lines of a title as comments, which begin with `start`.
inline void write_title(AtomicFile& file, std::string_view start, const std::string& title) {
  for (const std::string& line : title_lines(title)) {
    file.write(start);
    if (!line.empty()) file.write(" "), file.write(line);
    file.write("\n");
  }
}

/// An element that a file of points and polygons keeps: its position, the number of its corners, and these.
struct KeptElement {
  std::size_t element;
  int corners;
  const Index* nodes;
};
/// Calls `each` for all of them in the document's order.
template <class Each>
void for_each_kept(const Document& document, const Each& each) {
  for (const ElementBlock& block : document.blocks) {
    const int corners = corners_kept(block);
    if (corners == 0) continue;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
      if (nodes_exist(node, block.nodes_each)) each(KeptElement{block.first + e, corners, node});
  }
}

}  // namespace tetproof::io
