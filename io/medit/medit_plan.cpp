// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/medit/medit_plan.hpp"

#include <algorithm>
#include <cmath>

#include "io/model/element_types.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

// Whether the text reader reads `body` back as it is.
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

// Whether the reader takes a keyword called `name` for a section, and for nothing else.
bool is_plain_name(const std::string& name) {
  return looks_like_medit_keyword(name) && name != "End" && name != "MeshVersionFormatted" &&
         name != "Dimension" && name != "Vertices" && !name.ends_with("Ordering") && !medit_mark(name);
}

// Whether no item of `all` before `one` is written under the same name. Of several with one name, only the
// first is written.
template <class Named, class IsWritten>
bool is_first_of_name(const std::vector<Named>& all, const Named& one, const IsWritten& is_written) {
  for (const Named& before : all) {
    if (&before == &one) break;
    if (before.name == one.name && is_written(before)) return false;
  }
  return true;
}

// The reader drops references that are all 0.
bool references_come_back(const Values& values, bool binary) {
  if (values.reals.empty())
    return std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t r) { return r != 0; });
  return !binary && are_real_medit_references(values);
}

bool mark_comes_back(const Document& document, bool numbers_stay, const Values& values, bool of_nodes) {
  if (!is_medit_mark(values, of_nodes) || values.integers.size() != values.at.size() ||
      std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t one) { return one != 1; }))
    return false;
  if (!numbers_stay && std::any_of(values.at.begin(), values.at.end(), [](Index at) { return at < 0; }))
    return false;
  if (of_nodes) return true;
  // All marked elements must be of the type that the keyword is for.
  return std::all_of(values.at.begin(), values.at.end(), [&](Index at) {
    for (const ElementBlock& block : document.blocks)
      if (at >= 0 && static_cast<std::size_t>(at) < block.first + block.count)
        return medit_place(block).keyword &&
               medit_place(block).keyword->element == medit_mark(values.name)->element;
    return false;
  });
}

bool do_numbers_stay(const Document& document) {
  return document.node_tags.empty() && document.first_node == 1;
}

const Values* references_of(const Document& document) {
  for (const Values& values : document.node_values)
    if (values.name == "references" && values.components == 1 && values.at.empty() && values.first == 0 &&
        values.size() == document.points.size())
      return &values;
  return nullptr;
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

std::int64_t medit_reference(const Document& document, const ElementBlock& block) {
  const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
  return set.empty() ? 0 : set[0];
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

MeditPlan medit_plan(const Document& document) {
  MeditPlan plan;
  plan.numbers_stay = do_numbers_stay(document);
  plan.references = references_of(document);
  for (const ElementBlock& block : document.blocks) {
    const MeditPlace place = medit_place(block);
    if (!place.keyword) continue;
    const auto at = std::find(medit_elements().begin(), medit_elements().end(), place.keyword);
    plan.lists[static_cast<std::size_t>(at - medit_elements().begin())].push_back(&block);
  }
  return plan;
}

Holds medit_holds(const Document& document, const MeditPlan& plan, bool binary) {
  Holds holds;
  holds.unknown_nodes = plan.numbers_stay;
  holds.groups = Holds::Groups::first;
  const auto is_none = [&document](const ElementBlock& block) {  // a group that is written as none
    const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return !set.empty() && set[0] == 0;
  };
  if (std::any_of(document.blocks.begin(), document.blocks.end(), is_none))
    holds.groups_of = [&document, is_none](const ElementBlock& block) {
      return document.tag_sets[static_cast<std::size_t>(block.groups)].size() < 2 && !is_none(block);
    };
  holds.nodes_each = [](const ElementBlock& block) { return medit_place(block).nodes; };
  holds.kind = [](const ElementBlock& block) {
    const auto& all = medit_elements();
    return static_cast<int>(std::find(all.begin(), all.end(), medit_place(block).keyword) - all.begin());
  };
  holds.values = [&document, binary, stay = plan.numbers_stay, references = plan.references](
                     const Values& values, Of of) {
    if (of == Of::element_node || !values.labels.empty() || !values.nodes.empty() || has_step(values))
      return false;
    const auto any = [](const Values&) { return true; };
    if (!is_first_of_name(of == Of::node ? document.node_values : document.element_values, values, any))
      return false;
    if (of == Of::node && references == &values) return references_come_back(values, binary);
    return mark_comes_back(document, stay, values, of == Of::node);
  };
  holds.section = [&document, binary](const Section& section) {
    if (!writes_medit_section(section, binary) || section.swapped || section.before_nodes) return false;
    const auto is_written = [binary](const Section& one) { return writes_medit_section(one, binary); };
    if (!is_first_of_name(document.sections, section, is_written)) return false;
    if (!binary) return true;
    const MeditKeyword& keyword = *medit_keyword(section.name);
    return medit_body(keyword, *medit_lines(keyword, section.body, 3), 3) == section.body;
  };
  return holds;
}

}  // namespace tetproof::io
