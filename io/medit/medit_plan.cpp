// SPDX-License-Identifier: GPL-3.0-or-later
// Places in Medit's files for blocks, values and sections.
#include "io/medit/medit_places.hpp"

#include <algorithm>
#include <cmath>

#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

// Whether the text reader takes `body` back as it is.
bool is_plain_body(const std::string& body) {
  constexpr const char* blanks = " \t\r\n\v\f";
  if (body.find('\0') != std::string::npos) return false;
  if (!body.empty() && (body.find_first_of(blanks) == 0 || body.find_last_of(blanks) + 1 == body.size()))
    return false;
  for (std::size_t line = body.find_first_of("\n\r"); line != std::string::npos;
       line = body.find_first_of("\n\r", line + 1)) {
    const std::size_t next = body.find_first_not_of(" \t", line + 1);
    if (next != std::string::npos && is_medit_letter(body[next])) return false;
  }
  return true;
}

// Whether the reader takes what stands under `name` for a section, and for nothing else.
bool is_plain_name(const std::string& name) {
  return looks_like_medit_keyword(name) && name != "End" && name != "MeshVersionFormatted" &&
         name != "Dimension" && name != "Vertices" && !name.ends_with("Ordering") && !medit_mark(name);
}

}  // namespace

MeditPlace medit_place(const ElementBlock& block) {
  const ElementType* type = element_type(block.type);
  if (!type || type->nodes != block.nodes_each) return {};
  for (const MeditKeyword* keyword : medit_elements())
    if (keyword->element == block.type) return {keyword, block.nodes_each};
  for (const MeditKeyword* keyword : medit_elements())  // the linear one of the same shape
    if (const ElementType* linear = element_type(keyword->element);
        linear->shape == type->shape && linear->nodes == linear->corners)
      return {keyword, linear->nodes};
  return {};
}

bool medit_numbers_stay(const Document& document) {
  return document.node_tags.empty() && document.first_node == 1;
}

std::int64_t medit_reference(const Document& document, const ElementBlock& block) {
  const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
  return set.empty() ? 0 : set[0];
}

const Values* medit_references(const Document& document) {
  for (const Values& values : document.node_values)
    if (values.name == "references" && values.components == 1 && values.at.empty() && values.first == 0 &&
        values.size() == document.points.size())
      return &values;
  return nullptr;
}

bool is_medit_mark(const Values& values, bool of_nodes) {
  const MeditMark* mark = medit_mark(values.name);
  return mark && (mark->element == 0) == of_nodes && !values.at.empty() && values.components == 1;
}

bool writes_medit_section(const Section& section, bool binary) {
  if (section.format != "medit" || section.binary || !is_plain_name(section.name)) return false;
  const MeditKeyword* keyword = medit_keyword(section.name);
  if (keyword && keyword->element != 0) return false;
  return binary ? keyword && medit_lines(*keyword, section.body, 3) : is_plain_body(section.body);
}

bool are_real_medit_references(const Values& values) {
  const auto is_read = [](double r) { return std::abs(r) < largest_medit_real_reference; };
  return std::all_of(values.reals.begin(), values.reals.end(), is_read) &&
         std::any_of(values.reals.begin(), values.reals.end(), [](double r) { return r != std::floor(r); });
}

}  // namespace tetproof::io
