// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of documents that the surface formats share: elements, names and colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "io/document.hpp"

namespace tetproof::io {

/// Gmsh's type of an element with this number of corners: a point, a line, a triangle, a quadrangle, a
/// polygon.
int type_of_corners(std::size_t corners);

/// Adds an element at the end: to the last block if that has the same type, number of nodes and groups.
void add_element(Document& document, std::span<const Index> nodes, std::int32_t groups = 0);

/// Adds a line, likewise: a polyline if it has more than two nodes.
void add_line(Document& document, std::span<const Index> nodes, std::int32_t groups = 0);

/// InputError if there are more points than an Index can number.
void check_countable(const std::string& path, std::size_t points);

/// A name as a message shows it: printable, and cut if it is long.
std::string shown_name(std::string_view name);

/// The number of nodes of each element of a block that a file of points and polygons keeps: the corners, and
/// all of a polyline; 0 if the elements are neither points, lines nor faces. Formats without polylines are
/// never given any.
int corners_kept(const ElementBlock& block);

/// Whether all of an element's first `nodes` nodes exist.
inline bool nodes_exist(const Index* node, int nodes) {
  for (int k = 0; k < nodes; ++k)
    if (node[k] < 0) return false;
  return true;
}

/// Whether every element of a document is written with all its nodes. `nodes`: as `Holds::nodes_each`.
bool keeps_all_elements(const Document& document, const std::function<int(const ElementBlock&)>& nodes);

/// Writes a number with a point or an exponent, so that a reader does not take it for an integer.
char* put_decimal(char* to, double value);
inline constexpr std::size_t longest_decimal = 26;

/// Warns of colours with integers outside 0 to 255, or reals outside 0 to 1.
void warn_of_colours(Document& document, const Values& colours, const char* of);

}  // namespace tetproof::io
