// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_document.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "dice.hpp"
#include "io/model/element_types.hpp"
#include "random_parts.hpp"

namespace tetproof::test {
namespace {

constexpr const char* names[] = {
    "surface",          "low_dimensions",   "quadrangles",   "second_order",   "all_types",
    "polygons",         "repeated",         "no_tetrahedra", "loose_nodes",    "unknown_nodes",
    "wild_coordinates", "nan_coordinates",  "from_zero",     "node_tags",      "element_tags",
    "long_tags",        "element_entities", "node_entities", "parameters",     "entities",
    "groups",           "several_groups",   "group_names",   "partitions",     "partitioned_entities",
    "ghosts",           "periodic",         "node_values",   "element_values", "element_node_values",
    "subsets",          "unknown_at",       "integers",      "labels",         "view_steps",
    "odd_names",        "tetgen_values",    "boundary",      "facets",         "regions",
    "bounds",           "voronoi",          "tables",        "sections",       "title"};
static_assert(std::size(names) == features);

class Maker {
 public:
  explicit Maker(const Recipe& recipe) : recipe_(recipe) {}

  Document make() {
    nodes();
    if (!d_.points.empty()) {
      if (has(Feature::boundary)) boundary();
      elements();
    }
    numbers();
    node_blocks();
    add_random_parts(recipe_, d_);
    return std::move(d_);
  }

 private:
  bool has(Feature feature) const { return recipe_.has(feature); }
  Dice dice(Feature feature) const { return {recipe_.seed, static_cast<int>(feature)}; }

  void nodes() {
    Dice wild = dice(Feature::wild_coordinates), nan = dice(Feature::nan_coordinates);
    for (int i = 0; i < recipe_.nodes; ++i) {
      Eigen::Vector3d p(i + 0.5, wild.below(9), wild.below(9) / 4.0);
      const Eigen::Vector3d other(i + 0.1 + 0.8 * wild.unit(), wild.wild(), wild.wild());
      if (has(Feature::wild_coordinates)) p = other;
      if (has(Feature::nan_coordinates) && nan.chance(3)) p.z() = std::numeric_limits<double>::quiet_NaN();
      d_.points.push_back(p);
    }
    used_ = d_.points.size() - (has(Feature::loose_nodes) ? d_.points.size() / 3 : 0);
  }

  // The element types from which blocks are drawn.
  std::vector<int> types() const {
    std::vector<int> types;
    const auto add = [&](Feature feature, std::initializer_list<int> more) {
      for (const int type : more)
        if (has(feature)) types.push_back(type);
    };
    if (!has(Feature::no_tetrahedra)) types.push_back(4);
    add(Feature::surface, {2, 2});
    add(Feature::low_dimensions, {1, 15});
    add(Feature::quadrangles, {3, 5, 6, 7});
    add(Feature::second_order, {11, 9, 8});
    add(Feature::polygons, {io::polygon, io::polygon});
    if (has(Feature::all_types))
      for (int type = 1; type <= 140; ++type)
        if (const io::ElementType* known = io::element_type(type); known && known->nodes <= 130)
          types.push_back(type);
    return types;
  }

  std::int32_t tag_set(const std::vector<std::int64_t>& tags) {
    const auto found = std::find(d_.tag_sets.begin(), d_.tag_sets.end(), tags);
    if (found != d_.tag_sets.end()) return static_cast<std::int32_t>(found - d_.tag_sets.begin());
    d_.tag_sets.push_back(tags);
    return static_cast<std::int32_t>(d_.tag_sets.size() - 1);
  }

  void add_block(ElementBlock block, Dice& dice, bool with_unknown) {
    block.first = d_.elements();
    block.nodes = d_.connectivity.size();
    Dice unknown = this->dice(Feature::unknown_nodes), repeated = this->dice(Feature::repeated);
    for (std::size_t e = 0; e < block.count; ++e) {
      std::vector<Index> element;
      for (int k = 0; k < block.nodes_each; ++k) {
        Index node = static_cast<Index>(dice.index(used_));
        // An element names no node twice, if there are enough nodes.
        const bool may_repeat = has(Feature::repeated) && repeated.chance(4);
        for (std::size_t tries = 0; tries < used_ && !may_repeat; ++tries) {
          if (std::find(element.begin(), element.end(), node) == element.end()) break;
          node = static_cast<Index>((static_cast<std::size_t>(node) + 1) % used_);
        }
        element.push_back(node);
      }
      // The first element of a block names no unknown node. So it shows whether the type is written at all.
      if (e > 0 && with_unknown && has(Feature::unknown_nodes) && unknown.chance(3))
        element[unknown.index(element.size())] = unknown_number(unknown);
      if (e > 0 && has(Feature::repeated) && repeated.chance(4))
        element.assign(d_.connectivity.end() - block.nodes_each, d_.connectivity.end());
      d_.connectivity.insert(d_.connectivity.end(), element.begin(), element.end());
    }
    d_.blocks.push_back(block);
  }

  // A number beyond those of all nodes.
  Index unknown_number(Dice& dice) {
    const std::int64_t number =
        (has(Feature::long_tags) ? std::int64_t{1} << 61 : std::int64_t{1} << 30) + dice.below(3);
    const auto found = std::find(d_.unknown.begin(), d_.unknown.end(), number);
    const auto k = found - d_.unknown.begin();
    if (found == d_.unknown.end()) d_.unknown.push_back(number);
    return -1 - static_cast<Index>(k);
  }

  // Facets of a body to mesh. Some consist of several polygons, edges and vertices, some have holes.
  void boundary() {
    Dice dice = this->dice(Feature::boundary), several = this->dice(Feature::facets);
    constexpr int shapes[][3] = {{2, 2, 3}, {3, 2, 4}, {io::polygon, 2, 5}, {1, 1, 2}, {15, 0, 1}};
    for (std::int64_t n = 1 + dice.below(4); n > 0; --n) {
      const std::size_t first = d_.elements();
      const bool is_facet = has(Feature::facets) && several.chance(2);
      const std::size_t polygons = 1 + (is_facet ? several.index(3) : 0);
      for (std::size_t k = 0; k < polygons; ++k) {
        const auto& [type, dim, each] = shapes[k == 0 ? dice.index(3) : several.index(5)];
        add_block({.type = type, .dim = dim, .nodes_each = each, .count = 1, .of_boundary = true}, dice,
                  false);
      }
      if (!is_facet) continue;
      Facet facet{.first = first, .polygons = polygons};
      if (polygons == 1 || several.chance(2)) facet.holes.emplace_back(several.wild(), 0.25, several.unit());
      d_.facets.push_back(facet);
    }
  }

  void elements() {
    const std::vector<int> all = types();
    if (all.empty() || used_ == 0) return;
    Dice dice = this->dice(Feature::count), entity = this->dice(Feature::element_entities),
         groups = this->dice(Feature::groups), partitions = this->dice(Feature::partitions),
         several = this->dice(Feature::several_groups), corners = this->dice(Feature::polygons);
    for (std::int64_t n = 1 + dice.below(6); n > 0; --n) {
      ElementBlock block{.type = all[dice.index(all.size())],
                         .count = static_cast<std::size_t>(1 + dice.below(4))};
      const io::ElementType* type = io::element_type(block.type);
      block.dim = type ? type->dim : 2;
      block.nodes_each = type ? type->nodes : static_cast<int>(5 + corners.below(4));
      const std::int64_t in = 1 + entity.below(9);
      if (has(Feature::element_entities)) block.entity = in == 9 ? 77777 : in;
      if (has(Feature::groups) && groups.below(4) > 0) {
        std::vector<std::int64_t> tags{1 + groups.below(3)};
        if (has(Feature::several_groups))
          for (std::int64_t more = several.below(3); more > 0; --more)
            tags.push_back((several.chance(3) ? -1 : 1) * (10 + 5 * more + several.below(5)));
        block.groups = tag_set(tags);
      }
      if (has(Feature::partitions) && partitions.below(3) > 0) {
        std::vector<std::int64_t> tags{1 + partitions.below(2)};
        if (partitions.chance(3)) tags.push_back(3);
        block.partitions = tag_set(tags);
      }
      add_block(block, dice, true);
    }
    if (has(Feature::partitions)) d_.partitions = 3;
  }

  void numbers() {
    if (has(Feature::from_zero)) d_.first_node = d_.first_element = 0;
    const auto sparse = [&](Feature feature, std::size_t count, std::vector<std::int64_t>& tags) {
      Dice dice = this->dice(feature);
      const std::int64_t step = has(Feature::long_tags) ? std::int64_t{1} << 50 : 100;
      for (std::size_t i = 0; i < count; ++i)
        tags.push_back(1 + static_cast<std::int64_t>(i) * step + dice.below(step));
      for (std::size_t i = count; i > 1; --i) std::swap(tags[i - 1], tags[dice.index(i)]);
    };
    if (has(Feature::node_tags)) sparse(Feature::node_tags, d_.points.size(), d_.node_tags);
    if (has(Feature::element_tags)) sparse(Feature::element_tags, d_.elements(), d_.element_tags);
  }

  void node_blocks() {
    Dice dice = this->dice(Feature::node_entities), parameters = this->dice(Feature::parameters);
    if (!has(Feature::node_entities)) return;
    for (std::size_t at = 0; at < d_.points.size();) {
      NodeBlock block{.first = at, .count = std::min<std::size_t>(1 + dice.index(4), d_.points.size() - at)};
      at += block.count;
      const bool belongs = dice.below(6) > 0;
      block.dim = static_cast<int>(dice.below(4));
      block.entity = 1 + static_cast<std::int64_t>(d_.node_blocks.size());
      if (!belongs) continue;
      const bool parametric = has(Feature::parameters) && parameters.below(3) > 0;
      block.parameters_each = parametric ? block.dim : 0;
      block.parameters = d_.parameters.size();
      for (std::size_t k = 0; k < block.count * static_cast<std::size_t>(block.parameters_each); ++k)
        d_.parameters.push_back(parameters.any_real());
      d_.node_blocks.push_back(block);
    }
  }

  const Recipe& recipe_;
  Document d_;
  std::size_t used_ = 0;  // the nodes that elements may name
};

}  // namespace

std::ostream& operator<<(std::ostream& out, const Recipe& recipe) {
  out << "seed " << recipe.seed << ", " << recipe.nodes << " nodes, with";
  for (std::size_t i = 0; i < features; ++i)
    if (recipe.with[i]) out << ' ' << names[i];
  return out;
}

Document random_document(const Recipe& recipe) {
  return Maker(recipe).make();
}

}  // namespace tetproof::test
