// SPDX-License-Identifier: GPL-3.0-or-later
// Joins documents.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/joint_groups.hpp"
#include "io/edit/moved_values.hpp"
#include "io/edit/new_elements.hpp"
#include "io/error.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {
namespace {

template <class Item>
void append(std::vector<Item>& all, std::vector<Item>&& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// The step by which the numbers of `more` move up, so that they come behind those of `all`: 0 if none is in
// both.
std::int64_t step_between(const std::set<std::int64_t>& all, const std::set<std::int64_t>& more) {
  const bool meet = std::any_of(more.begin(), more.end(), [&](std::int64_t n) { return all.contains(n); });
  return meet ? *all.rbegin() - *more.begin() + 1 : 0;
}

// Whether a sum of such numbers might overflow.
bool too_large(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
  constexpr std::int64_t limit = std::int64_t{1} << 60;
  return std::min(a.front(), b.front()) < -limit || std::max(a.back(), b.back()) > limit;
}

// The numbers of nodes or elements of both. If their sums might overflow, all are numbered from 1; returns
// whether those of `other` had to move.
template <class TagOf>
bool join_numbers(std::size_t count, std::size_t more, const TagOf& tag, const TagOf& other_tag,
                  std::vector<std::int64_t>& tags, std::int64_t& first) {
  std::vector<std::int64_t> numbers, others;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(tag(i));
  for (std::size_t i = 0; i < more; ++i) others.push_back(other_tag(i));
  std::vector<std::int64_t> sorted = numbers, sorted_others = others, both;
  std::sort(sorted.begin(), sorted.end());
  std::sort(sorted_others.begin(), sorted_others.end());
  std::set_intersection(sorted.begin(), sorted.end(), sorted_others.begin(), sorted_others.end(),
                        std::back_inserter(both));
  if (!both.empty() && too_large(sorted, sorted_others)) {
    tags.clear();
    first = 1;
    return true;
  }
  const std::int64_t step = both.empty() ? 0 : sorted.back() - sorted_others.front() + 1;
  for (const std::int64_t number : others) numbers.push_back(number + step);
  if (count == 0) first = 1;
  set_numbers(std::move(numbers), tags, first);
  return step != 0;
}

class Joiner {
 public:
  Joiner(Document& document, Document& other)
      : document_(document),
        other_(other),
        points_(static_cast<Index>(document.points.size())),
        elements_(static_cast<Index>(document.elements())),
        unknown_(static_cast<Index>(document.unknown.size())) {}

  Edit join() {
    if (document_.points.size() + other_.points.size() > std::numeric_limits<Index>::max() ||
        document_.elements() + other_.elements() > std::numeric_limits<Index>::max())
      throw InputError(
          fmt::format("{}: more nodes or elements than can be counted once it is joined", other_.path));
    const std::string did = fmt::format("{} and {} of {} joined", counted(other_.points.size(), "nodes"),
                                        counted(other_.elements(), "elements"), other_.path);
    numbers();
    groups();
    entities();
    nodes();
    elements();
    values();
    rest();
    return {did + did_, std::move(lost_)};
  }

 private:
  void lose(const std::string& item, std::size_t count, std::string example) {
    if (count > 0)
      lost_.push_back(
          {.item = item, .count = static_cast<std::int64_t>(count), .example = std::move(example)});
  }
  Index moved(Index i, Index by) const { return i < 0 ? i - unknown_ : i + by; }
  void numbers() {
    for (Document* document : {&document_, &other_})
      for (Loss& loss : without_element_numbers(*document)) lost_.push_back(std::move(loss));
    const bool nodes_move = join_numbers(document_.points.size(), other_.points.size(),
                                         std::function([&](std::size_t i) { return document_.node_tag(i); }),
                                         std::function([&](std::size_t i) { return other_.node_tag(i); }),
                                         new_node_tags_, new_first_node_);
    const bool elements_move =
        join_numbers(document_.elements(), other_.elements(),
                     std::function([&](std::size_t i) { return document_.element_tag(i); }),
                     std::function([&](std::size_t i) { return other_.element_tag(i); }), new_element_tags_,
                     new_first_element_);
    numbers_move_ = nodes_move || elements_move;
    if (nodes_move && has_node_numbers(other_)) did_ += "; its node numbers moved up";
    if (elements_move && has_element_numbers(other_)) did_ += "; its element numbers moved up";
  }

  void groups() {
    std::size_t renumbered = 0;
    groups_ = join_groups(document_, other_, renumbered);
    if (renumbered > 0) did_ += fmt::format("; {} of it got another number", counted(renumbered, "groups"));
  }

  std::int32_t joint_groups(int dim, std::int32_t set, TagSets& sets) const {
    std::vector<std::int64_t> tags = other_.tag_sets[static_cast<std::size_t>(set)];
    for (std::int64_t& tag : tags) {
      const std::int64_t number = groups_.at({dim, std::abs(tag)});
      tag = tag < 0 ? -number : number;
    }
    return sets(tags);
  }

  void entities() {
    TagSets sets(document_);
    const auto collect = [](const Document& from) {
      std::set<std::int64_t> tags;
      for (const ElementBlock& block : from.blocks) tags.insert(block.entity);
      for (const NodeBlock& block : from.node_blocks) tags.insert(block.entity);
      for (const Entity& entity : from.entities) tags.insert(entity.tag);
      for (const GhostEntity& ghost : from.ghosts) tags.insert(ghost.tag);
      tags.erase(0);
      return tags;
    };
    const std::int64_t step = step_between(collect(document_), collect(other_));
    const auto move = [step](std::int64_t& tag) { tag += tag > 0 ? step : tag < 0 ? -step : 0; };
    for (Entity& entity : other_.entities) {
      entity.groups = joint_groups(entity.dim, entity.groups, sets);
      entity.partitions = sets(other_.tag_sets[static_cast<std::size_t>(entity.partitions)]);
      move(entity.tag);
      if (entity.parent_dim >= 0) move(entity.parent);
      for (std::int64_t& tag : entity.boundary) move(tag);
    }
    for (GhostEntity& ghost : other_.ghosts) move(ghost.tag);
    for (PeriodicLink& link : other_.periodic) move(link.entity), move(link.master);
    for (NodeBlock& block : other_.node_blocks) move(block.entity);
    for (ElementBlock& block : other_.blocks) {
      move(block.entity);
      block.groups = joint_groups(block.dim, block.groups, sets);
      block.partitions = sets(other_.tag_sets[static_cast<std::size_t>(block.partitions)]);
    }
    if (step != 0) did_ += fmt::format("; its entities' tags moved up by {}", step);
    append(document_.entities, std::move(other_.entities));
    append(document_.ghosts, std::move(other_.ghosts));
    document_.partitions = std::max(document_.partitions, other_.partitions);
  }

  void nodes() {
    append(document_.points, std::move(other_.points));
    for (NodeBlock& block : other_.node_blocks) {
      block.first += static_cast<std::size_t>(points_);
      block.parameters += document_.parameters.size();
    }
    append(document_.node_blocks, std::move(other_.node_blocks));
    append(document_.parameters, std::move(other_.parameters));
    append(document_.unknown, std::move(other_.unknown));
    document_.node_tags = std::move(new_node_tags_);
    document_.first_node = new_first_node_;
    for (PeriodicLink& link : other_.periodic)
      for (auto& pair : link.nodes)
        for (Index& node : pair) node = moved(node, points_);
    append(document_.periodic, std::move(other_.periodic));
    for (LengthBound& bound : other_.length_bounds)
      for (Index& node : bound.nodes) node = moved(node, points_);
    append(document_.length_bounds, std::move(other_.length_bounds));
  }

  void elements() {
    const std::size_t connectivity = document_.connectivity.size();
    for (ElementBlock& block : other_.blocks) {
      block.first += static_cast<std::size_t>(elements_);
      block.nodes += connectivity;
    }
    append(document_.blocks, std::move(other_.blocks));
    for (Index& node : other_.connectivity) node = moved(node, points_);
    append(document_.connectivity, std::move(other_.connectivity));
    document_.element_tags = std::move(new_element_tags_);
    document_.first_element = new_first_element_;
    for (GhostElement& ghost : other_.ghost_elements) ghost.element = moved(ghost.element, elements_);
    append(document_.ghost_elements, std::move(other_.ghost_elements));
    for (Facet& facet : other_.facets) facet.first += static_cast<std::size_t>(elements_);
    append(document_.facets, std::move(other_.facets));
  }

  static bool alike(const Values& a, const Values& b) {
    return a.name == b.name && a.components == b.components && a.reals.empty() == b.reals.empty() &&
           a.labels == b.labels && a.nodes.empty() == b.nodes.empty() && a.of_view == b.of_view &&
           a.time == b.time && a.step == b.step && a.partition == b.partition &&
           a.interpolation == b.interpolation;
  }

  // Values that both documents have become one; the rest stand for themselves.
  void join_values(std::vector<Values>& all, std::vector<Values>&& more, Index by) {
    for (Values& values : more) {
      const std::size_t items = values.items();
      if (values.at.empty())
        values.first += static_cast<std::size_t>(by);
      else
        for (Index& at : values.at) at = moved(at, by);
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const Values& one) { return alike(one, values); });
      if (found == all.end()) {
        all.push_back(std::move(values));
        continue;
      }
      const std::size_t before = found->items();
      if (before > 0 && items > 0 &&
          !(found->at.empty() && values.at.empty() && found->first + before == values.first)) {
        for (Values* one : {&*found, &values}) {
          std::vector<Index> at;
          for (std::size_t row = 0; row < one->items(); ++row) at.push_back(item_of(*one, row));
          one->at = std::move(at);
          one->first = 0;
        }
        append(found->at, std::move(values.at));
      } else if (before == 0) {
        found->first = values.first;
        found->at = std::move(values.at);
      }
      append(found->reals, std::move(values.reals));
      append(found->integers, std::move(values.integers));
      append(found->nodes, std::move(values.nodes));
    }
  }

  void values() {
    join_values(document_.node_values, std::move(other_.node_values), points_);
    join_values(document_.element_values, std::move(other_.element_values), elements_);
    join_values(document_.element_node_values, std::move(other_.element_node_values), elements_);
  }

  // What the document has once, or by name.
  void rest() {
    append(document_.holes, std::move(other_.holes));
    append(document_.regions, std::move(other_.regions));
    append(document_.area_bounds, std::move(other_.area_bounds));
    append(document_.warnings, std::move(other_.warnings));
    append(document_.dropped, std::move(other_.dropped));
    if (document_.title.empty())
      document_.title = std::move(other_.title);
    else if (!other_.title.empty() && other_.title != document_.title)
      lose("title", 1, other_.title);
    lose("cells of a Voronoi diagram", document_.voronoi.cells.size() + other_.voronoi.cells.size(),
         "a diagram is of all points");
    document_.voronoi = {};
    const auto taken = [](const auto& all, const std::string& name) {
      return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    };
    for (Table& table : other_.tables) {
      if (taken(document_.tables, table.name))
        lose("tables", 1, fmt::format("\"{}\" of {}", table.name, other_.path));
      else
        document_.tables.push_back(std::move(table));
    }
    for (Section& section : other_.sections) {
      if (numbers_move_ || taken(document_.sections, section.name))
        lose("sections", 1, fmt::format("${} of {}", section.name, other_.path));
      else
        document_.sections.push_back(std::move(section));
    }
    const bool both_msh = document_.format.starts_with("msh") && other_.format.starts_with("msh");
    if (document_.format != other_.format && !both_msh) document_.format.clear();
  }

  Document &document_, &other_;
  const Index points_, elements_, unknown_;
  std::vector<std::int64_t> new_node_tags_, new_element_tags_;
  std::int64_t new_first_node_ = 1, new_first_element_ = 1;
  bool numbers_move_ = false;
  JointGroups groups_;
  std::string did_;
  std::vector<Loss> lost_;
};

}  // namespace

Edit join(Document& document, Document&& other) {
  return Joiner(document, other).join();
}

}  // namespace tetproof::io
