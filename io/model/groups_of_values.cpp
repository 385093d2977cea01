// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/groups_of_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "io/model/tag_sets.hpp"

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

  // Adds elements `from` to `to` of a block.
  static void add(std::vector<ElementBlock>& blocks, ElementBlock block, std::size_t from, std::size_t to,
                  std::int32_t groups) {
    if (from == to) return;
    block.nodes += (from - block.first) * static_cast<std::size_t>(block.nodes_each);
    block.first = from;
    block.count = to - from;
    block.groups = groups;
    blocks.push_back(block);
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

}  // namespace

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
