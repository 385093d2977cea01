// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "io/supplement.hpp"
#include "io/tetgen.hpp"
#include "io/text_output.hpp"

namespace tetproof::io {
namespace {

bool is_tetrahedra(const ElementBlock& block) {
  const ElementType* type = element_type(block.type);
  return type && type->shape == Shape::tetrahedron;
}

std::int64_t tetgen_base(const Document& document) {
  return document.node_tags.empty() && document.first_node == 0 ? 0 : 1;
}

char* put_values(char* to, const Values* values, std::size_t item) {
  if (!values) return to;
  const std::size_t from = item * values->components;
  for (int k = 0; k < values->components; ++k) {
    to = put(to, ' ');
    to = values->integers.empty() ? put(to, values->reals[from + k]) : put(to, values->integers[from + k]);
  }
  return to;
}

}  // namespace

TetgenLimits tetgen_limits(const Document& document) {
  TetgenLimits limits;
  limits.renumber_nodes =
      !document.node_tags.empty() || (document.first_node != 0 && document.first_node != 1);
  const std::int64_t base = tetgen_base(document);
  bool any = false, second_order = true;
  std::int64_t number = base;
  for (const ElementBlock& block : document.blocks) {
    if (!is_tetrahedra(block)) continue;
    any = true;
    second_order = second_order && block.type == tetrahedron10;
    for (std::size_t e = 0; e < block.count && !limits.renumber_elements; ++e)
      limits.renumber_elements = document.element_tag(block.first + e) != number++;
  }
  limits.nodes_each = any && second_order ? 10 : 4;
  return limits;
}

namespace {

// A number that no node has must stay one that no node has.
std::int64_t written_unknown(const Document& document, std::size_t k) {
  const std::int64_t base = tetgen_base(document), number = document.unknown[k];
  const auto nodes = static_cast<std::int64_t>(document.points.size());
  return number >= base && number < base + nodes ? base + nodes + static_cast<std::int64_t>(k) : number;
}

}  // namespace

Holds tetgen_holds(const Document& document) {
  const TetgenLimits limits = tetgen_limits(document);
  Holds holds;
  holds.kept_in = "comments";
  holds.unknown_nodes = true;
  holds.unknown_number = [&document](std::size_t k) { return written_unknown(document, k); };
  holds.nodes_each = [limits](const ElementBlock& block) {
    return is_tetrahedra(block) ? limits.nodes_each : 0;
  };
  holds.values = [](const Values& values, Of of) {
    return of != Of::element_node && !values.of_view && values.at.empty() && values.first == 0 &&
           (values.name == "attributes" || values.name == "markers");
  };
  return holds;
}

void write_tetgen(const std::string& stem, const Document& document, const std::string& supplement) {
  const TetgenLimits limits = tetgen_limits(document);
  const std::int64_t base = tetgen_base(document);
  const std::int64_t nodes = static_cast<std::int64_t>(document.points.size());
  AtomicFile node_file(stem + ".node"), element_file(stem + ".ele");
  if (!supplement.empty()) node_file.keep_checksum(), element_file.keep_checksum();

  const Values* attributes = values_named(document.node_values, "attributes");
  const Values* markers = values_named(document.node_values, "markers");
  const std::size_t columns = (attributes ? attributes->components : 0) + (markers ? markers->components : 0);
  node_file.write(
      fmt::format("{} 3 {} {}\n", nodes, attributes ? attributes->components : 0, markers ? 1 : 0));
  write_items(node_file, document.points.size(), (4 + columns) * (longest_real + 1) + 1,
              [&](std::size_t i, char* to) {
                to = put(to, base + static_cast<std::int64_t>(i));
                for (double x : document.points[i]) to = put(put(to, ' '), x);
                return put(put_values(put_values(to, attributes, i), markers, i), '\n');
              });

  const auto named = [&](Index i) { return i >= 0 ? base + i : written_unknown(document, -1 - i); };
  const Values* element_attributes = values_named(document.element_values, "attributes");
  const int element_columns = element_attributes ? element_attributes->components : 0;
  std::size_t count = 0;
  for (const ElementBlock& block : document.blocks)
    if (is_tetrahedra(block)) count += block.count;
  element_file.write(fmt::format("{} {} {}\n", count, limits.nodes_each, element_columns));
  std::int64_t written = base;
  for (const ElementBlock& block : document.blocks) {
    if (!is_tetrahedra(block)) continue;
    const std::size_t longest = (1 + limits.nodes_each + element_columns) * (longest_real + 1) + 1;
    write_items(element_file, block.count, longest, [&](std::size_t i, char* to) {
      to = put(to, written + static_cast<std::int64_t>(i));
      const Index* node = document.connectivity.data() + block.nodes + i * block.nodes_each;
      for (int k = 0; k < limits.nodes_each; ++k) to = put(put(to, ' '), named(node[tetgen_order[k]]));
      return put(put_values(to, element_attributes, block.first + i), '\n');
    });
    written += static_cast<std::int64_t>(block.count);
  }
  if (!supplement.empty())
    node_file.write(as_comments(
        supplement_head({{"", node_file.checksum()}, {".ele", element_file.checksum()}}) + supplement));
  node_file.commit();
  element_file.commit();
}

}  // namespace tetproof::io
