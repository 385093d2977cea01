// SPDX-License-Identifier: GPL-3.0-or-later
// Joins documents.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/free_numbers.hpp"
#include "io/edit/joint_groups.hpp"
#include "io/edit/joint_numbers.hpp"
#include "io/edit/joint_values.hpp"
#include "io/edit/new_elements.hpp"
#include "io/edit/origin.hpp"
#include "io/edit/unknown_numbers.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/tag_sets.hpp"
#include "io/model/tag_words.hpp"

namespace tetproof::io {
namespace {

template <class Item>
void append(std::vector<Item>& all, std::vector<Item>&& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// The tags of entities of one document once those of another one are there: all move up by one step if any
// is in both.
class MovedTags {
 public:
  MovedTags(const std::set<std::int64_t>& all, const std::set<std::int64_t>& more) {
    if (std::none_of(more.begin(), more.end(), [&](std::int64_t tag) { return all.contains(tag); })) return;
    if (std::min(*all.begin(), *more.begin()) > -limit && std::max(*all.rbegin(), *more.rbegin()) < limit) {
      step_ = *all.rbegin() - *more.begin() + 1;
      return;
    }
    std::vector<std::int64_t> taken(all.begin(), all.end());
    taken.insert(taken.end(), more.begin(), more.end());
    FreeNumbers free(std::move(taken));
    for (const std::int64_t tag : more)
      if (all.contains(tag)) anew_[tag] = free.next();
  }

  /// `tag`: 0 is none; a negative one is turned.
  void move(std::int64_t& tag) const {
    if (step_ != 0 && tag != 0) tag += tag > 0 ? step_ : -step_;
    if (anew_.empty()) return;
    if (const auto same = anew_.find(tag); same != anew_.end())
      tag = same->second;
    else if (const auto turned = tag < 0 && tag > -Limits::max() ? anew_.find(-tag) : anew_.end();
             turned != anew_.end())
      tag = -turned->second;
  }

  std::string text() const {
    if (step_ != 0) return fmt::format("; its entities' tags moved up by {}", step_);
    return anew_.empty() ? "" : fmt::format("; {} of it got another tag", counted(anew_.size(), "entities"));
  }

 private:
  using Limits = std::numeric_limits<std::int64_t>;
  static constexpr std::int64_t limit = std::int64_t{1} << 60;  // sums of such numbers do not overflow
  std::int64_t step_ = 0;
  std::map<std::int64_t, std::int64_t> anew_;
};

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
    return {did + did_ + freed_unknown_numbers(document_), std::move(lost_)};
  }

 private:
  Index moved(Index i, Index by) const { return moved_behind(i, by, unknown_); }

  void numbers() {
    for (Document* document : {&document_, &other_})
      for (Loss& loss : without_element_numbers(*document)) lost_.push_back(std::move(loss));
    node_numbers_ = join_numbers(NumbersOf::nodes(document_), NumbersOf::nodes(other_));
    element_numbers_ = join_numbers(NumbersOf::elements(document_), NumbersOf::elements(other_));
    if (node_numbers_.more_move && has_node_numbers(other_)) did_ += "; its node numbers moved up";
    if (element_numbers_.more_move && has_element_numbers(other_)) did_ += "; its element numbers moved up";
    if (node_numbers_.all_move || element_numbers_.all_move) leave_out_sections(document_, lost_);
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
    const MovedTags moved(collect(document_), collect(other_));
    const auto move = [&](std::int64_t& tag) { moved.move(tag); };
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
    did_ += moved.text();
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
    document_.node_tags = std::move(node_numbers_.tags);
    document_.first_node = node_numbers_.first;
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
    document_.element_tags = std::move(element_numbers_.tags);
    document_.first_element = element_numbers_.first;
    for (GhostElement& ghost : other_.ghost_elements) ghost.element = moved(ghost.element, elements_);
    append(document_.ghost_elements, std::move(other_.ghost_elements));
    for (Facet& facet : other_.facets) facet.first += static_cast<std::size_t>(elements_);
    append(document_.facets, std::move(other_.facets));
  }

  // Tools have different words for the tags of nodes. They become one, so that none is lost in a format that
  // has one such tag.
  void share_word() {
    const auto tags_in = [](std::vector<Values>& all) -> Values* {
      for (const std::string_view word : node_tag_words)
        for (Values& values : all)
          if (values.name == word && values.components == 1 && !values.integers.empty()) return &values;
      return nullptr;
    };
    const auto has = [](const std::vector<Values>& all, const std::string& name) {
      return std::any_of(all.begin(), all.end(), [&](const Values& values) { return values.name == name; });
    };
    const Values* mine = tags_in(document_.node_values);
    Values* theirs = tags_in(other_.node_values);
    if (mine && theirs && !has(document_.node_values, theirs->name) && !has(other_.node_values, mine->name))
      theirs->name = mine->name;
  }

  void values() {
    mark_lengths(document_), mark_lengths(other_);
    share_word();
    join_values(document_.node_values, std::move(other_.node_values), points_, unknown_);
    join_values(document_.element_values, std::move(other_.element_values), elements_, unknown_);
    join_values(document_.element_node_values, std::move(other_.element_node_values), elements_, unknown_);
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
      add_loss(lost_, "title", 1, other_.title);
    add_loss(lost_, "cells of a Voronoi diagram",
             document_.voronoi.cells.size() + other_.voronoi.cells.size(), "a diagram is of all points");
    document_.voronoi = {};
    const auto taken = [](const auto& all, const std::string& name) {
      return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    };
    for (Table& table : other_.tables) {
      if (taken(document_.tables, table.name))
        add_loss(lost_, "tables", 1, fmt::format("\"{}\" of {}", table.name, other_.path));
      else
        document_.tables.push_back(std::move(table));
    }
    for (Section& section : other_.sections) {
      if (node_numbers_.more_move || element_numbers_.more_move || taken(document_.sections, section.name))
        add_loss(lost_, "sections", 1, fmt::format("${} of {}", section.name, other_.path));
      else
        document_.sections.push_back(std::move(section));
    }
    const bool both_msh = document_.format.starts_with("msh") && other_.format.starts_with("msh");
    document_.numbers_nodes = node_numbers_.of_files;
    document_.numbers_elements = element_numbers_.of_files;
    if (document_.format != other_.format && !both_msh) document_.format.clear();
  }

  Document &document_, &other_;
  const Index points_, elements_, unknown_;
  JointNumbers node_numbers_, element_numbers_;
  JointGroups groups_;
  std::string did_;
  std::vector<Loss> lost_;
};

}  // namespace

Edit join(Document& document, Document&& other) {
  return Joiner(document, other).join();
}

}  // namespace tetproof::io
