// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/kept_part.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "io/model/block_of.hpp"

namespace tetproof::io {
namespace {

// How many numbers come before those of each item, and all of them at the end; empty: the sizes do not agree.
std::vector<std::size_t> starts_of(const Values& values, bool of_corners) {
  const auto each = static_cast<std::size_t>(std::max(values.components, 0));
  const std::size_t items = values.items();
  if (of_corners != !values.nodes.empty() || (!values.at.empty() && values.at.size() != items)) return {};
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < items; ++i) {
    const std::int32_t nodes = of_corners ? values.nodes[i] : 1;
    if (nodes < 0) return {};
    starts.push_back(starts.back() + each * static_cast<std::size_t>(nodes));
  }
  if (values.reals.empty() == values.integers.empty() || starts.back() != values.size()) return {};
  return starts;
}

// Labels in the order of their first use, without those that are not used.
void renumber_labels(Values& values) {
  std::vector<std::string> used;
  std::unordered_map<std::int64_t, std::int64_t> numbers;
  for (std::int64_t& label : values.integers) {
    if (label < 0 || label >= static_cast<std::int64_t>(values.labels.size())) return;
    const auto [place, is_new] = numbers.try_emplace(label, static_cast<std::int64_t>(used.size()));
    if (is_new) used.push_back(values.labels[static_cast<std::size_t>(label)]);
  }
  for (std::int64_t& label : values.integers) label = numbers.at(label);
  values.labels = std::move(used);
}

// The values of these elements, in their order.
Values values_of(const Values& all, const std::vector<std::size_t>& elements, std::size_t count,
                 bool of_corners, KeptPart::Form form) {
  const std::vector<std::size_t> starts = starts_of(all, of_corners);
  if (starts.empty()) return all;
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> row_of(count, none);
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    const std::int64_t element = all.at.empty() ? static_cast<std::int64_t>(all.first + i) : all.at[i];
    if (element < 0) return all;  // of a number that no element has: not to be lost in silence
    if (static_cast<std::size_t>(element) >= count) continue;
    if (row_of[static_cast<std::size_t>(element)] != none) return all;  // several of one element
    row_of[static_cast<std::size_t>(element)] = i;
  }
  Values kept = all;
  kept.first = 0, kept.at.clear(), kept.nodes.clear(), kept.reals.clear(), kept.integers.clear();
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::size_t row = row_of[elements[k]];
    if (row == none) continue;
    kept.at.push_back(static_cast<Index>(k));
    if (of_corners) kept.nodes.push_back(all.nodes[row]);
    for (std::size_t n = starts[row]; n < starts[row + 1]; ++n)
      all.reals.empty() ? kept.integers.push_back(all.integers[n]) : kept.reals.push_back(all.reals[n]);
  }
  const bool is_run =
      !kept.at.empty() && static_cast<std::size_t>(kept.at.back() - kept.at.front()) + 1 == kept.at.size();
  if (kept.at.size() == elements.size() || (is_run && form == KeptPart::Form::runs)) {
    kept.first = kept.at.empty() ? 0 : static_cast<std::size_t>(kept.at.front());
    kept.at.clear();
  }
  if (!kept.labels.empty()) renumber_labels(kept);
  return kept;
}

bool has_form(const Values& values, std::size_t elements, KeptPart::Form form) {
  if (form == KeptPart::Form::runs) return values.at.empty();
  return !values.at.empty() || (values.first == 0 && values.items() == elements);
}

// Puts the elements in this order, each with its corners. Facets, which name elements by position, are left
// out: no format that is written from such a part holds them.
void arrange(const std::vector<std::size_t>& elements, const Document& from, Document& to) {
  to.blocks.clear(), to.connectivity.clear(), to.element_tags.clear(), to.facets.clear();
  auto block = from.blocks.begin();
  for (const std::size_t e : elements) {
    if (e < block->first) block = from.blocks.begin();
    while (e >= block->first + block->count) ++block;
    ElementBlock one = *block;
    if (const int corners = corners_kept(*block); corners > 0 && corners < block->nodes_each)
      one.type = type_of_corners(static_cast<std::size_t>(corners)), one.nodes_each = corners;
    one.first = to.element_tags.size(), one.nodes = to.connectivity.size(), one.count = 0;
    if (to.blocks.empty() || !are_alike(to.blocks.back(), one)) to.blocks.push_back(one);
    ++to.blocks.back().count;
    to.element_tags.push_back(from.element_tag(e));
    const Index* nodes = from.connectivity.data() + block->nodes +
                         (e - block->first) * static_cast<std::size_t>(block->nodes_each);
    to.connectivity.insert(to.connectivity.end(), nodes, nodes + one.nodes_each);
  }
}

template <class Item>
const Item& counterpart(const Item& item, const std::vector<Item>& all, const std::vector<Item>& others) {
  const Item* const first = all.data();
  if (std::less<>()(&item, first) || !std::less<>()(&item, first + all.size())) return item;
  return others[static_cast<std::size_t>(&item - first)];
}

}  // namespace

KeptPart::KeptPart(const Document& document,
                   const std::function<std::optional<std::vector<std::size_t>>(const Document&)>& elements_of,
                   Form form)
    : document_(document) {
  const auto& of_elements = document.element_values;
  const auto& of_corners = document.element_node_values;
  if (of_elements.empty() && of_corners.empty()) return;
  const std::optional<std::vector<std::size_t>> chosen = elements_of(document);
  if (!chosen) return;
  const std::vector<std::size_t>& elements = *chosen;
  const std::size_t count = document.elements();
  const auto fits = [&](const Values& values) { return has_form(values, count, form); };
  bool same = elements.size() == count && std::all_of(of_elements.begin(), of_elements.end(), fits) &&
              std::all_of(of_corners.begin(), of_corners.end(), fits);
  for (std::size_t k = 0; k < elements.size() && same; ++k) same = elements[k] == k;
  for (const ElementBlock& block : document.blocks)
    same = same && (corners_kept(block) == 0 || corners_kept(block) == block.nodes_each);
  if (same) return;
  made_ = std::make_unique<Document>(document);
  arrange(elements, document, *made_);
  for (Values& values : made_->element_values) values = values_of(values, elements, count, false, form);
  for (Values& values : made_->element_node_values) values = values_of(values, elements, count, true, form);
}

Holds KeptPart::holds(Holds of_part) const {
  if (!made_) return of_part;
  of_part.values = [this, of_values = std::move(of_part.values)](const Values& values, Of of) {
    const auto& [all, others] = of == Of::node ? std::tie(document_.node_values, made_->node_values)
                                : of == Of::element
                                    ? std::tie(document_.element_values, made_->element_values)
                                    : std::tie(document_.element_node_values, made_->element_node_values);
    return of_values(counterpart(values, all, others), of);
  };
  of_part.table = [this, of_table = std::move(of_part.table)](const Table& table) {
    return of_table(counterpart(table, document_.tables, made_->tables));
  };
  return of_part;
}

std::vector<std::size_t> kept_elements(const Document& document,
                                       const std::function<bool(const KeptElement&)>& is_kept) {
  std::vector<std::size_t> elements;
  for_each_kept(document, [&](const KeptElement& element) {
    if (is_kept(element)) elements.push_back(element.element);
  });
  return elements;
}

}  // namespace tetproof::io
