// SPDX-License-Identifier: GPL-3.0-or-later
// Points and elements as lines of text, exact, for the formats that list them so.
#pragma once

#include <string_view>

#include "io/bytes/text_output.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

inline char* put(char* to, std::string_view text) {
  return std::copy(text.begin(), text.end(), to);
}

/// Three coordinates without a line end.
inline char* put_point(char* to, const Eigen::Vector3d& point) {
  return put(put(put(put(put(to, point[0]), ' '), point[1]), ' '), point[2]);
}

/// A row of values, a blank before each number.
inline char* put_row(char* to, const Values& values, std::size_t row) {
  const auto each = static_cast<std::size_t>(values.components);
  for (std::size_t k = row * each; k < (row + 1) * each; ++k)
    to = values.reals.empty() ? put(put(to, ' '), values.integers[k])
                              : put_decimal(put(to, ' '), values.reals[k]);
  return to;
}

/// Lines of a title as comments.
inline void write_title(AtomicFile& file, std::string_view start, const std::string& title) {
  for (const std::string& line : title_lines(title)) {
    file.write(start);
    if (!line.empty()) file.write(" "), file.write(line);
    file.write("\n");
  }
}

/// The elements that a file of points and polygons keeps, in order: their number, the number of their
/// corners, and these.
struct KeptElement {
  std::size_t element;
  int corners;
  const Index* nodes;
};
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
