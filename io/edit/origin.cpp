// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/origin.hpp"

namespace tetproof::io {
namespace {

bool is_of_tetgen(const Document& document) {
  return document.format == "tetgen" || document.format == "poly" || document.format == "smesh";
}

}  // namespace

bool has_node_numbers(const Document& document) {
  return document.numbers_nodes || !document.node_tags.empty() || document.format.starts_with("msh") ||
         is_of_tetgen(document);
}

bool has_element_numbers(const Document& document) {
  return document.numbers_elements || !document.element_tags.empty() || document.format.starts_with("msh");
}

void mark_lengths(Document& document) {
  if (!is_of_tetgen(document)) return;
  for (Values& values : document.node_values)
    if (values.name == "sizes") values.length_power = values.components == 1 ? 1 : -2;
  for (Values& values : document.element_values)
    if (values.name == "volume bounds") values.length_power = 3;
}

}  // namespace tetproof::io
