// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/groups_of_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/model/block_of.hpp"
#include "io/model/tag_sets.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

// The tag that a number is. -0 is none: it would come back as 0.
std::optional<std::int64_t> tag_at(const Values& values, std::size_t i) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (!values.integers.empty()) {
    const std::int64_t tag = values.integers[i];
    return tag >= -most && tag <= most ? std::optional(tag) : std::nullopt;
  }
  const double tag = values.reals[i];
  if (!(tag >= 0 && tag <= static_cast<double>(most)) || std::signbit(tag) || tag != std::trunc(tag))
    return std::nullopt;
  return static_cast<std::int64_t>(tag);
}

// Adds elements `from` to `to` of a block.
void add(std::vector<ElementBlock>& blocks, ElementBlock block, std::size_t from, std::size_t to,
         std::int32_t groups) {
  if (from == to) return;
  block.nodes += (from - block.first) * static_cast<std::size_t>(block.nodes_each);
  block.first = from;
  block.count = to - from;
  block.groups = groups;
  blocks.push_back(block);
}

class Maker {
 public:
  explicit Maker(Document& document) : document_(document), sets_(document) {}

  // Returns what is left of the values, those of negative numbers.
  Values make(Values values) {
    values_ = &values;
    end_ = values.first + values.size();
    std::vector<ElementBlock> blocks;
    for (const ElementBlock& block : document_.blocks) {
      const std::size_t from = std::clamp(values.first, block.first, block.first + block.count),
                        to = std::clamp(end_, block.first, block.first + block.count);
      add(blocks, block, block.first, from, block.groups);
      for (std::size_t e = from; e < to;) {
        std::size_t behind = e + 1;
        while (behind < to && tag(behind) == tag(e)) ++behind;
        add(blocks, block, e, behind, tag(e) > 0 ? sets_({tag(e)}) : 0);
        e = behind;
      }
      add(blocks, block, to, block.first + block.count, block.groups);
    }
    document_.blocks = std::move(blocks);
    Values rest{.name = values.name};
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const std::int64_t negative = *tag_at(values, i); negative < 0) {
        rest.at.push_back(static_cast<Index>(values.first + i));
        rest.integers.push_back(negative);
      }
    return rest;
  }

 private:
  std::int64_t tag(std::size_t element) const {
    return std::max<std::int64_t>(*tag_at(*values_, element - values_->first), 0);
  }

  Document& document_;
  TagSets sets_;
  const Values* values_ = nullptr;
  std::size_t end_ = 0;
};

bool have_groups(const Document& document, std::size_t from, std::size_t to) {
  return std::any_of(document.blocks.begin(), document.blocks.end(), [&](const ElementBlock& block) {
    return block.groups != 0 && block.first < to && block.first + block.count > from;
  });
}

using NegativeTags = std::unordered_map<std::size_t, std::int64_t>;  // by element

// Adds the numbers below 0 that values have, if these are TetGen's and say nothing else.
bool add_negative_tags(const Document& document, const Values& values, NegativeTags& tags) {
  if ((values.name != "attributes" && values.name != "markers") || values.components != 1 ||
      values.integers.empty() || values.integers.size() != values.items() || has_step(values) ||
      !values.labels.empty() || !values.nodes.empty())
    return false;
  NegativeTags all = tags;
  for (std::size_t i = 0; i < values.integers.size(); ++i) {
    const std::optional<std::int64_t> tag = tag_at(values, i);
    if (tag == 0) continue;
    const std::int64_t element =
        values.at.empty() ? static_cast<std::int64_t>(values.first + i) : values.at[i];
    if (!tag || *tag > 0 || element < 0 || element >= static_cast<std::int64_t>(document.elements()) ||
        block_of(document.blocks, static_cast<std::size_t>(element)).groups != 0 ||
        !all.try_emplace(static_cast<std::size_t>(element), *tag).second)
      return false;
  }
  if (all.size() == tags.size()) return false;
  tags = std::move(all);
  return true;
}

}  // namespace

std::optional<Document> with_groups_below_zero(const Document& document) {
  NegativeTags tags;
  std::vector<bool> taken;
  for (const Values& values : document.element_values)
    taken.push_back(add_negative_tags(document, values, tags));
  if (tags.empty()) return std::nullopt;
  std::optional<Document> result = document;
  result->element_values.clear();
  for (std::size_t k = 0; k < taken.size(); ++k)
    if (!taken[k]) result->element_values.push_back(document.element_values[k]);
  TagSets sets(*result);
  const auto groups_of = [&](const ElementBlock& block, std::size_t element) {
    const auto tag = tags.find(element);
    return tag == tags.end() ? block.groups : sets({tag->second});
  };
  result->blocks.clear();
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = block.first, end = block.first + block.count; e < end;) {
      const std::int32_t groups = groups_of(block, e);
      std::size_t behind = e + 1;
      while (behind < end && groups_of(block, behind) == groups) ++behind;
      add(result->blocks, block, e, behind, groups);
      e = behind;
    }
  return result;
}

bool are_tags(const Values& values) {
  if (values.components != 1 || !values.at.empty() || !values.nodes.empty() || !values.labels.empty() ||
      values.of_view)
    return false;
  bool any = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto tag = tag_at(values, i);
    if (!tag) return false;
    any |= *tag > 0;
  }
  return any;
}

void make_groups_of_values(Document& document, const std::string& name) {
  std::vector<Values> all = std::exchange(document.element_values, {});
  for (Values& values : all) {
    if (values.name != name || !are_tags(values) || values.first + values.size() > document.elements() ||
        have_groups(document, values.first, values.first + values.size())) {
      document.element_values.push_back(std::move(values));
      continue;
    }
    Values rest = Maker(document).make(std::move(values));
    if (!rest.at.empty()) document.element_values.push_back(std::move(rest));
  }
}

}  // namespace tetproof::io
