// SPDX-License-Identifier: GPL-3.0-or-later
#include "entities_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "document_texts.hpp"

namespace tetproof::test {
namespace {

// The entity and parameters that a node block gives to one node.
struct NodePlace {
  bool any = false;
  int dim = 0;
  std::int64_t entity = 0;
  std::vector<std::string> parameters;
};

std::vector<NodePlace> places_of(const Document& document) {
  std::vector<NodePlace> places(document.points.size());
  for (const NodeBlock& block : document.node_blocks)
    for (std::size_t i = 0; i < block.count; ++i) {
      NodePlace& place = places.at(block.first + i);
      place.any = block.entity != 0, place.dim = block.dim, place.entity = block.entity;
      const std::size_t each = static_cast<std::size_t>(block.parameters_each);
      for (std::size_t k = 0; k < each; ++k)
        place.parameters.push_back(bits(document.parameters.at(block.parameters + i * each + k)));
    }
  return places;
}

using Id = std::pair<int, std::int64_t>;

// The box of an entity's nodes.
struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void take(const Eigen::Vector3d& p) {
    if (p.allFinite()) low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
};

// Whether the elements and nodes of an entity say everything that the entity says.
bool follows(const Document& document, const std::vector<Element>& elements, const Entity& entity) {
  if (!entity.boundary.empty() || entity.parent_dim >= 0) return false;
  const auto& groups = document.tag_sets.at(static_cast<std::size_t>(entity.groups));
  bool told = false;
  Box box;
  for (const Element& element : elements) {
    if (element.dim != entity.dim || element.entity != entity.tag) continue;
    told = told || element.groups == groups;
    for (const Index node : element.nodes)
      if (node >= 0) box.take(document.points[static_cast<std::size_t>(node)]);
  }
  const std::vector<NodePlace> places = places_of(document);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].any && places[i].dim == entity.dim && places[i].entity == entity.tag)
      box.take(document.points[i]);
  if (entity.dim == 0) box.high = box.low;  // a point has its coordinates in both halves
  for (int k = 0; k < 3; ++k) told = told && entity.box[k] == box.low[k] && entity.box[3 + k] == box.high[k];
  return told;
}

}  // namespace

std::vector<Difference> differences_of_entities(const Document& before, const Document& after,
                                                const Pairing& pairs) {
  std::vector<Difference> list;
  const auto add = [&](const std::string& item, std::int64_t count, const std::string& example,
                       bool unsure = false) {
    if (count > 0) list.push_back({item, count, example, {}, unsure});
  };
  const std::vector<Element> was = elements_of(before), is = elements_of(after);

  // Entities of elements. 0 means no entity, and the writer may give it one. If all entities are 0 or 1, the
  // file tells nothing.
  const bool told =
      std::any_of(is.begin(), is.end(), [](const Element& e) { return e.entity != 0 && e.entity != 1; });
  std::int64_t changed = 0;
  std::string example;
  for (std::size_t e = 0; e < is.size(); ++e) {
    const Index cut = pairs.cut_before[e];
    const bool first_of_cut =
        cut != none && pairs.cut_after[static_cast<std::size_t>(cut)] == static_cast<Index>(e);
    if (pairs.element_before[e] == none && !first_of_cut) continue;
    const Element& old = was[static_cast<std::size_t>(first_of_cut ? cut : pairs.element_before[e])];
    const bool same = old.entity == is[e].entity && old.dim == is[e].dim;
    if (same || old.entity == 0 || (old.entity == 1 && is[e].entity == 0)) continue;
    if (changed++ == 0)
      example = fmt::format("element {} in {}/{} came to {}/{}", old.tag, old.dim, old.entity, is[e].dim,
                            is[e].entity);
  }
  add(told ? "numbers of entities" : "entities of elements", changed, example);

  // Entities of nodes.
  const std::vector<NodePlace> nodes_were = places_of(before), nodes_are = places_of(after);
  bool moved = false, parameters_lost = false, went_with_node = false;
  std::int64_t with_parameters = 0, gained = 0;
  for (std::size_t i = 0; i < nodes_were.size(); ++i) {
    with_parameters += !nodes_were[i].parameters.empty();
    const Index a = pairs.node_after[i];
    went_with_node = went_with_node || (nodes_were[i].any && a == none);
    const NodePlace now = a == none ? NodePlace{} : nodes_are[static_cast<std::size_t>(a)];
    moved = moved || (nodes_were[i].any && a != none &&
                      (now.dim != nodes_were[i].dim || now.entity != nodes_were[i].entity));
    parameters_lost =
        parameters_lost || (!nodes_were[i].parameters.empty() && now.parameters != nodes_were[i].parameters);
    gained += nodes_were[i].parameters.empty() && !now.parameters.empty();
  }
  // An entity of all nodes is only a number.
  const bool one_for_all =
      before.node_blocks.size() == 1 && before.node_blocks[0].count == before.points.size();
  if (!one_for_all || !after.node_blocks.empty())
    add("entities of nodes", moved || went_with_node ? static_cast<std::int64_t>(before.points.size()) : 0,
        "", !moved);
  add("nodes with parametric coordinates", parameters_lost ? with_parameters : 0, "");
  add("gained parametric coordinates", gained, "");

  // The entities themselves.
  std::multiset<std::string> there;
  for (const Entity& entity : after.entities) there.insert(text_of_entity(after, entity));
  std::int64_t lost = 0;
  for (const Entity& entity : before.entities) {
    const std::string text = text_of_entity(before, entity);
    if (const auto found = there.find(text); found != there.end()) {
      there.erase(found);
      continue;
    }
    const bool plain = entity.tag == 0 || entity.tag == 1;
    if ((told || plain) && follows(before, was, entity)) continue;
    if (lost++ == 0) example = text;
  }
  add("entities with their boxes and boundaries", lost, example);
  // An entity that the writer added for elements or nodes is not gained.
  for (const Entity& entity : after.entities) {
    const auto in_it = [&](const auto& part) { return part.dim == entity.dim && part.entity == entity.tag; };
    if (there.count(text_of_entity(after, entity)) && std::none_of(is.begin(), is.end(), in_it) &&
        std::none_of(nodes_are.begin(), nodes_are.end(), in_it))
      add("gained entities", 1, text_of_entity(after, entity));
  }

  // If a file does not say the number of partitions, it is the largest partition.
  std::int64_t largest = 0;
  for (const Element& element : is)
    for (const std::int64_t partition : element.partitions) largest = std::max(largest, std::abs(partition));
  if (before.partitions != after.partitions && !(after.partitions == 0 && before.partitions == largest))
    add(before.partitions > 0 ? "number of partitions" : "gained partitions", 1,
        fmt::format("{} became {}", before.partitions, after.partitions));
  return list;
}

}  // namespace tetproof::test
