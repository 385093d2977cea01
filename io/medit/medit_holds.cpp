// SPDX-License-Identifier: GPL-3.0-or-later
// What comes back of a document that is written in Medit's format and read again.
#include <algorithm>
#include <cmath>

#include "io/medit/medit.hpp"
#include "io/medit/medit_places.hpp"

namespace tetproof::io {
namespace {

// Whether no item of `all` in front of `one` has the same name, as the first of a name is written.
template <class Named, class IsWritten>
bool is_first_of_name(const std::vector<Named>& all, const Named& one, const IsWritten& is_written) {
  for (const Named& before : all) {
    if (&before == &one) break;
    if (before.name == one.name && is_written(before)) return false;
  }
  return true;
}

// They are dropped where all are 0.
bool references_come_back(const Values& values, bool binary) {
  if (values.reals.empty())
    return std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t r) { return r != 0; });
  return !binary && are_real_medit_references(values);
}

bool mark_comes_back(const Document& document, const Values& values, bool of_nodes) {
  if (!is_medit_mark(values, of_nodes) || values.integers.size() != values.at.size() ||
      std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t one) { return one != 1; }))
    return false;
  if (!medit_numbers_stay(document) &&
      std::any_of(values.at.begin(), values.at.end(), [](Index at) { return at < 0; }))
    return false;
  if (of_nodes) return true;
  // All of the type that the keyword is for.
  return std::all_of(values.at.begin(), values.at.end(), [&](Index at) {
    for (const ElementBlock& block : document.blocks)
      if (at >= 0 && static_cast<std::size_t>(at) < block.first + block.count)
        return medit_place(block).keyword &&
               medit_place(block).keyword->element == medit_mark(values.name)->element;
    return false;
  });
}

}  // namespace

Holds medit_holds(const Document& document, bool binary) {
  Holds holds;
  holds.unknown_nodes = medit_numbers_stay(document);
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
  holds.values = [&document, binary](const Values& values, Of of) {
    if (of == Of::element_node || !values.labels.empty() || !values.nodes.empty() || has_step(values))
      return false;
    const auto any = [](const Values&) { return true; };
    if (!is_first_of_name(of == Of::node ? document.node_values : document.element_values, values, any))
      return false;
    if (of == Of::node && medit_references(document) == &values) return references_come_back(values, binary);
    return mark_comes_back(document, values, of == Of::node);
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
