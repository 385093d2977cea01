// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_parts.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dice.hpp"

namespace tetproof::test {
namespace {

class Parts {
 public:
  Parts(const Recipe& recipe, Document& document) : recipe_(recipe), d_(document) {}

  void add() {
    entities();
    if (has(Feature::group_names)) group_names();
    if (has(Feature::ghosts)) ghosts();
    if (has(Feature::periodic)) periodic();
    const bool tetgen = has(Feature::tetgen_values);
    if (has(Feature::node_values)) values(Feature::node_values, d_.points.size(), d_.node_values);
    if (has(Feature::element_values)) values(Feature::element_values, d_.elements(), d_.element_values);
    if (has(Feature::element_node_values))
      values(Feature::element_node_values, d_.elements(), d_.element_node_values);
    if (tetgen) tetgen_values();
    if (has(Feature::regions)) regions();
    if (has(Feature::bounds) && !d_.points.empty()) bounds();
    if (has(Feature::voronoi) && !d_.points.empty()) voronoi();
    if (has(Feature::tables)) tables();
    if (has(Feature::sections)) sections();
    if (has(Feature::title)) d_.title = dice(Feature::title).name(0, has(Feature::odd_names));
  }

 private:
  bool has(Feature feature) const { return recipe_.has(feature); }
  Dice dice(Feature feature) const { return {recipe_.seed, 1000 + static_cast<int>(feature)}; }

  Index unknown_number(Dice& dice) {
    const std::int64_t number = (std::int64_t{1} << 30) + 100 + dice.below(5);
    const auto found = std::find(d_.unknown.begin(), d_.unknown.end(), number);
    const auto k = found - d_.unknown.begin();
    if (found == d_.unknown.end()) d_.unknown.push_back(number);
    return -1 - static_cast<Index>(k);
  }

  void entities() {
    Dice dice = this->dice(Feature::entities), parts = this->dice(Feature::partitioned_entities);
    std::set<std::pair<int, std::int64_t>> used;
    const auto random_entity = [&](int dim, std::int64_t tag, std::int32_t groups) {
      Entity entity{.dim = dim, .groups = groups, .tag = tag};
      for (double& x : entity.box) x = dice.chance(3) ? dice.wild() : static_cast<double>(dice.below(9));
      if (dim == 0) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
      for (std::int64_t k = dice.below(3); dim > 0 && k > 0; --k)
        entity.boundary.push_back(dice.chance(2) ? -k - 3 : k + 3);
      return entity;
    };
    if (has(Feature::entities)) {
      for (const ElementBlock& block : d_.blocks)
        if (block.entity != 0 && dice.chance(2) && used.insert({block.dim, block.entity}).second)
          d_.entities.push_back(random_entity(block.dim, block.entity, block.groups));
      for (std::int64_t k = dice.below(4); k > 0; --k) {
        const int dim = static_cast<int>(dice.below(4));
        const std::int64_t tag = 20 + dice.below(5);
        const auto groups = static_cast<std::int32_t>(dice.index(d_.tag_sets.size()));
        if (used.insert({dim, tag}).second) d_.entities.push_back(random_entity(dim, tag, groups));
      }
    }
    if (has(Feature::partitioned_entities)) {
      d_.partitions = 3;
      for (std::int64_t k = 1 + parts.below(3); k > 0; --k) {
        const int dim = static_cast<int>(parts.below(4));
        Entity entity{
            .dim = dim, .tag = 40 + k, .parent_dim = std::min(3, dim + 1), .parent = 1 + parts.below(3)};
        d_.tag_sets.push_back({k, k + 1});
        if (std::find(d_.tag_sets.begin(), d_.tag_sets.end() - 1, d_.tag_sets.back()) !=
            d_.tag_sets.end() - 1)
          d_.tag_sets.pop_back();
        entity.partitions = static_cast<std::int32_t>(
            std::find(d_.tag_sets.begin(), d_.tag_sets.end(), std::vector<std::int64_t>{k, k + 1}) -
            d_.tag_sets.begin());
        d_.entities.push_back(entity);
      }
    }
    std::stable_sort(d_.entities.begin(), d_.entities.end(),
                     [](const Entity& a, const Entity& b) { return a.dim < b.dim; });
  }

  void group_names() {
    Dice dice = this->dice(Feature::group_names);
    std::set<std::pair<int, std::int64_t>> used;
    int k = 0;
    for (const ElementBlock& block : d_.blocks)
      for (const std::int64_t group : d_.tag_sets[static_cast<std::size_t>(block.groups)])
        if (dice.chance(2) && used.insert({block.dim, std::abs(group)}).second)
          d_.group_names.push_back(
              {block.dim, std::abs(group), dice.name(k++ % 26, has(Feature::odd_names))});
    if (dice.chance(2)) d_.group_names.push_back({2, 99, dice.name(25, has(Feature::odd_names))});
  }

  void ghosts() {
    Dice dice = this->dice(Feature::ghosts);
    d_.partitions = 3;
    for (std::int64_t k = dice.below(3); k > 0; --k) d_.ghosts.push_back({60 + k, k});
    for (std::size_t e = 0; e < d_.elements(); ++e)
      if (dice.chance(4)) d_.ghost_elements.push_back({static_cast<Index>(e), 1 + dice.below(3), {2, 3}});
    if (has(Feature::unknown_at)) d_.ghost_elements.push_back({unknown_number(dice), 1, {}});
  }

  void periodic() {
    Dice dice = this->dice(Feature::periodic);
    for (std::int64_t k = 1 + dice.below(3); k > 0; --k) {
      PeriodicLink link{.dim = static_cast<int>(dice.below(3)), .entity = k, .master = k + 4};
      if (dice.chance(2))
        for (int i = 0; i < 16; ++i) link.affine.push_back(dice.wild());
      for (std::int64_t n = dice.below(4); n > 0 && !d_.points.empty(); --n)
        link.nodes.push_back({static_cast<Index>(dice.index(d_.points.size())),
                              has(Feature::unknown_at) && dice.chance(3)
                                  ? unknown_number(dice)
                                  : static_cast<Index>(dice.index(d_.points.size()))});
      d_.periodic.push_back(link);
    }
  }

  int nodes_of(Index element) const {
    for (const ElementBlock& block : d_.blocks)
      if (element >= 0 && static_cast<std::size_t>(element) < block.first + block.count)
        return block.nodes_each;
    return 2;
  }

  void values(Feature feature, std::size_t count, std::vector<Values>& all) {
    Dice dice = this->dice(feature), part = this->dice(Feature::subsets),
         view = this->dice(Feature::view_steps), integer = this->dice(Feature::integers),
         label = this->dice(Feature::labels), lost = this->dice(Feature::unknown_at);
    if (count == 0) return;
    for (int k = static_cast<int>(1 + dice.below(3)); k > 0; --k) {
      Values values{.name = dice.name(k, has(Feature::odd_names)),
                    .components = static_cast<int>(1 + dice.below(4))};
      std::size_t items = count;
      if (has(Feature::subsets) && part.below(3) > 0) {
        if (part.chance(2)) {
          values.first = part.index(count);
          items = 1 + part.index(count - values.first);
        } else {
          for (std::size_t i = 0; i < count; ++i)
            if (part.chance(2)) values.at.push_back(static_cast<Index>(count - 1 - i));
          if (has(Feature::unknown_at) && lost.chance(2)) values.at.push_back(unknown_number(lost));
          if (values.at.size() == count) values.at.pop_back();  // a subset is never all of them
          if (values.at.empty()) values.at.push_back(0);
          items = values.at.size();
        }
      }
      std::size_t size = items;
      if (feature == Feature::element_node_values) {
        size = 0;
        for (std::size_t i = 0; i < items; ++i) {
          values.nodes.push_back(
              nodes_of(values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i]));
          size += static_cast<std::size_t>(values.nodes.back());
        }
      }
      const bool integers = has(Feature::integers) && integer.chance(2);
      const bool labels = integers && has(Feature::labels) && label.chance(2);
      for (std::size_t i = 0; i < size * static_cast<std::size_t>(values.components); ++i) {
        const double real = dice.any_real();
        if (labels)
          values.integers.push_back(label.below(3));
        else if (integers)
          values.integers.push_back(integer.chance(5) ? integer.below(std::int64_t{1} << 62)
                                                      : integer.below(256) - 99);
        else
          values.reals.push_back(real);
      }
      if (labels) values.labels = {"x", label.name(1, has(Feature::odd_names)), label.name(2, false)};
      if (has(Feature::view_steps) && view.chance(2)) {
        values.of_view = true;
        values.time = view.any_real(), values.step = view.below(9), values.partition = view.below(3);
        if (view.chance(4)) values.interpolation = "scheme";
      }
      all.push_back(values);
    }
  }

  void tetgen_values() {
    Dice dice = this->dice(Feature::tetgen_values);
    const auto add = [&](const char* name, int components, bool integers, std::size_t first,
                         std::size_t count, std::vector<Values>& all) {
      if (count == 0 || dice.chance(3)) return;
      Values values{.name = name, .components = components, .first = first};
      for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i) {
        const double real = dice.wild();
        if (integers)
          values.integers.push_back(dice.below(9) - 2);
        else
          values.reals.push_back(real);
      }
      all.push_back(values);
    };
    add("attributes", 2, false, 0, d_.points.size(), d_.node_values);
    add("markers", 1, true, 0, d_.points.size(), d_.node_values);
    // For each run of elements of one dimension.
    for (std::size_t b = 0; b < d_.blocks.size();) {
      const ElementBlock& block = d_.blocks[b];
      std::size_t count = 0;
      for (; b < d_.blocks.size() && d_.blocks[b].dim == block.dim &&
             d_.blocks[b].of_boundary == block.of_boundary;
           ++b)
        count += d_.blocks[b].count;
      if (block.dim == 3)
        add("attributes", 1, false, block.first, count, d_.element_values);
      else
        add("markers", 1, true, block.first, count, d_.element_values);
    }
  }

  void regions() {
    Dice dice = this->dice(Feature::regions);
    for (std::int64_t k = 1 + dice.below(2); k > 0; --k) d_.holes.emplace_back(dice.wild(), dice.unit(), 1);
    for (std::int64_t k = 1 + dice.below(2); k > 0; --k)
      d_.regions.push_back({{dice.unit(), 2, dice.wild()}, dice.wild(), dice.chance(2) ? dice.unit() : -1});
  }

  void bounds() {
    Dice dice = this->dice(Feature::bounds);
    d_.area_bounds.push_back({dice.below(9) - 4, dice.unit()});
    d_.length_bounds.push_back(
        {{static_cast<Index>(dice.index(d_.points.size())), static_cast<Index>(dice.index(d_.points.size()))},
         dice.unit()});
  }

  void voronoi() {
    Dice dice = this->dice(Feature::voronoi);
    Voronoi& v = d_.voronoi;
    v.first = dice.below(2);
    const auto points = static_cast<std::size_t>(1 + dice.below(3));
    for (std::size_t i = 0; i < points; ++i) v.points.emplace_back(dice.unit(), dice.wild(), 3);
    v.edges.push_back({{0, static_cast<Index>(dice.index(points))}});
    v.edges.push_back({{0, -1}, {dice.unit(), -1, dice.wild()}});
    v.faces.push_back({{0, static_cast<Index>(dice.index(d_.points.size()))}, {0, 1}});
    v.faces.push_back({{0, 0}, {1, -1}});
    v.cells.resize(d_.points.size());
    for (auto& cell : v.cells) {
      cell = {static_cast<Index>(dice.below(2))};
      if (dice.chance(3)) cell.push_back(-1);
    }
  }

  void tables() {
    Dice dice = this->dice(Feature::tables);
    Table table{.name = dice.name(0, false), .rows = static_cast<std::size_t>(1 + dice.below(3))};
    Column reals{.name = "r", .type = "double", .components = 1};
    Column lists{.name = "l", .type = "int", .components = 1};
    for (std::size_t i = 0; i < table.rows; ++i) {
      reals.reals.push_back(dice.any_real());
      lists.lengths.push_back(static_cast<std::int32_t>(1 + dice.below(2)));
      for (std::int32_t k = 0; k < lists.lengths.back(); ++k) lists.integers.push_back(dice.below(99) - 9);
    }
    table.columns = {reals, lists};
    if (dice.chance(3)) {
      Column texts{.name = "t", .type = "String", .components = 1};
      for (std::size_t i = 0; i < table.rows; ++i)
        texts.texts.push_back(dice.name(static_cast<int>(i), has(Feature::odd_names)));
      table.columns.push_back(texts);
    }
    d_.tables.push_back(table);
  }

  void sections() {
    Dice dice = this->dice(Feature::sections);
    static const char* const formats[] = {"msh22", "msh41", "msh40"};
    for (std::int64_t k = 1 + dice.below(2); k > 0; --k)
      d_.sections.push_back({.name = k == 1           ? "Mine"
                                     : dice.chance(2) ? "Yours"
                                                      : "InterpolationScheme",
                             .body = dice.chance(2) ? "1 2 3\n# not a comment \"\n" : "x\n\n",
                             .format = formats[dice.index(3)],
                             .binary = dice.chance(4),
                             .before_nodes = dice.chance(2)});
  }

  const Recipe& recipe_;
  Document& d_;
};

}  // namespace

void add_random_parts(const Recipe& recipe, Document& document) {
  Parts(recipe, document).add();
}

}  // namespace tetproof::test
