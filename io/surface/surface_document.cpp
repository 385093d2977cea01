// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/surface_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "io/bytes/one_line.hpp"
#include "io/bytes/text_output.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {

int type_of_corners(std::size_t corners) {
  return corners == 1   ? point1
         : corners == 2 ? line2
         : corners == 3 ? triangle3
         : corners == 4 ? quadrangle4
                        : polygon;
}

namespace {

void add_of_type(Document& document, int type, std::span<const Index> nodes, std::int32_t groups) {
  const auto each = static_cast<std::int32_t>(nodes.size());
  if (document.blocks.empty() || document.blocks.back().type != type ||
      document.blocks.back().nodes_each != each || document.blocks.back().groups != groups)
    document.blocks.push_back({.type = type,
                               .dim = dimension_of_type(type),
                               .groups = groups,
                               .nodes_each = each,
                               .first = document.elements(),
                               .nodes = document.connectivity.size()});
  ++document.blocks.back().count;
  for (const Index node : nodes) document.connectivity.push_back(node);
}

}  // namespace

void add_element(Document& document, std::span<const Index> nodes, std::int32_t groups) {
  add_of_type(document, type_of_corners(nodes.size()), nodes, groups);
}

void add_line(Document& document, std::span<const Index> nodes, std::int32_t groups) {
  add_of_type(document, nodes.size() == 2 ? line2 : polyline, nodes, groups);
}

void check_countable(const std::string& path, std::size_t points) {
  if (points > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw InputError(fmt::format("{}: {} points, at most 2147483647 can be numbered", path, points));
}

std::string shown_name(std::string_view name) {
  return start_in_one_line(name, 40);
}

int corners_kept(const ElementBlock& block) {
  if (block.type == polyline) return block.nodes_each;
  if (block.type == polygon) return block.nodes_each >= 3 ? block.nodes_each : 0;
  const ElementType* type = element_type(block.type);
  const bool kept = type && (type->shape == Shape::point || type->shape == Shape::line ||
                             type->shape == Shape::triangle || type->shape == Shape::quadrangle);
  return kept ? type->corners : 0;
}

bool keeps_all_elements(const Document& document, const std::function<int(const ElementBlock&)>& nodes) {
  for (const ElementBlock& block : document.blocks) {
    if (block.count == 0) continue;
    if (nodes(block) != block.nodes_each) return false;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
      if (!nodes_exist(node, block.nodes_each)) return false;
  }
  return true;
}

char* put_decimal(char* to, double value) {
  char* const end = put(to, value);
  const bool looks_whole = std::all_of(to, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
  if (!looks_whole) return end;
  end[0] = '.', end[1] = '0';
  return end + 2;
}

void warn_of_colours(Document& document, const Values& colours, const char* of) {
  std::size_t bad = 0;
  for (const std::int64_t c : colours.integers) bad += c < 0 || c > 255;
  for (const double c : colours.reals) bad += !(c >= 0 && c <= 1);
  if (bad > 0 && colours.components > 1)
    document.warnings.push_back(fmt::format("{}: {} in colours of {} {} outside of {}", document.path,
                                            counted(bad, "numbers"), of, bad == 1 ? "is" : "are",
                                            colours.reals.empty() ? "0 to 255" : "0 to 1"));
}

}  // namespace tetproof::io
