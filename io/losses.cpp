// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/element_types.hpp"
#include "io/holds.hpp"
#include "io/msh_entities.hpp"
#include "io/weld.hpp"
#include "io/written_part.hpp"

namespace tetproof {
namespace {

using io::ElementType;
using io::Holds;
using io::Of;
using io::Shape;
using Cut = io::WrittenPart::Cut;
using Written = io::WrittenPart::Block;

const char* name_of(int type) {
  if (type == io::polygon) return "polygons";
  const ElementType* known = io::element_type(type);
  switch (known ? known->shape : Shape::other) {
    case Shape::point:
      return "points";
    case Shape::line:
      return "lines";
    case Shape::triangle:
      return "triangles";
    case Shape::quadrangle:
      return "quadrangles";
    case Shape::tetrahedron:
      return "tetrahedra";
    case Shape::hexahedron:
      return "hexahedra";
    case Shape::prism:
      return "prisms";
    case Shape::pyramid:
      return "pyramids";
    case Shape::polygon:
      return "polygons";
    case Shape::other:
      break;
  }
  return "elements";
}

bool is_plain(std::int64_t first) {
  return first == 0 || first == 1;
}

class Lister {
 public:
  Lister(const Document& document, const Holds& holds)
      : document_(document), holds_(holds), written_(document, holds) {}

  std::vector<Loss> list() {
    elements();
    order();
    nodes();
    node_numbers();
    unknown_numbers();
    element_numbers();
    coordinates();
    entities_of_elements();
    entities_of_nodes();
    entities();
    groups();
    partitions();
    parameters();
    values(document_.node_values, Of::node, "nodes");
    values(document_.element_values, Of::element, "elements");
    values(document_.element_node_values, Of::element_node, "elements' nodes");
    boundary();
    rest();
    return std::move(losses_);
  }

 private:
  void add(const std::string& item, std::size_t count, const std::string& example) {
    if (count == 0) return;
    for (Loss& loss : losses_)
      if (loss.item == item) {
        loss.count += static_cast<std::int64_t>(count);
        return;
      }
    losses_.push_back({item, static_cast<std::int64_t>(count), example});
  }

  std::string element(const ElementBlock& block, std::size_t e = 0) const {
    return fmt::format("element {}", document_.element_tag(block.first + e));
  }

  // The blocks of what comes back, and then what comes back in triangles, one by one.
  template <class Each>
  void each_written(const Each& each) const {
    for (const Written& written : written_.blocks())
      each(*written.block, written.count, element(*written.block));
    for (const Cut& cut : written_.cut()) each(*cut.block, 1, element(*cut.block, cut.element));
  }

  // Elements that are not written, or without their nodes between the corners.
  void elements() {
    for (const ElementBlock& block : document_.blocks) {
      const std::string what =
          fmt::format("{} of {} nodes (type {})", name_of(block.type), block.nodes_each, block.type);
      const int each = holds_.nodes_each(block);
      if (each == 0) {
        not_written(block, what);
      } else if (!holds_.unknown_nodes && !document_.unknown.empty()) {
        unknown_nodes(block);
      }
    }
    for (const Written& written : written_.blocks())
      if (written.nodes_each < written.block->nodes_each)
        add(fmt::format("nodes between the corners of {} of {} nodes (type {})", name_of(written.block->type),
                        written.block->nodes_each, written.block->type),
            written.count, element(*written.block));
  }

  // Left out, or cut into triangles.
  void not_written(const ElementBlock& block, const std::string& what) {
    std::vector<bool> cut(block.count);
    for (const Cut& one : written_.cut())
      if (one.block == &block) {
        cut[one.element] = true;
        add(what + " cut into triangles", 1, element(block, one.element));
      }
    const auto first = static_cast<std::size_t>(std::find(cut.begin(), cut.end(), false) - cut.begin());
    add(what, static_cast<std::size_t>(std::count(cut.begin(), cut.end(), false)), element(block, first));
  }

  void unknown_nodes(const ElementBlock& block) {
    for (std::size_t e = 0; e < block.count; ++e) {
      if (!written_.names_unknown(block, e)) continue;
      const Index* node = written_.nodes_of(block, e);
      const Index bad = *std::find_if(node, node + block.nodes_each, [](Index i) { return i < 0; });
      add("elements that name nodes which do not exist", 1,
          fmt::format("{} names node {}", element(block, e), document_.named(bad)));
    }
  }

  // The writer puts them together by kind.
  void order() {
    const std::vector<Written>& blocks = written_.blocks();
    for (std::size_t i = 1; i < blocks.size(); ++i)
      if (blocks[i].block < blocks[i - 1].block)
        return add("order of elements", 1,
                   fmt::format("{} comes before those above it", element(*blocks[i - 1].block)));
  }

  void nodes() {
    if (written_.all_nodes()) return;
    std::vector<bool> kept(document_.points.size());
    for (std::size_t i = 0; i < written_.nodes(); ++i) kept[written_.node(i)] = true;
    const auto lost = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    const auto first = static_cast<std::size_t>(std::find(kept.begin(), kept.end(), false) - kept.begin());
    if (lost > 0)
      add("nodes of no element that is written", lost, fmt::format("node {}", document_.node_tag(first)));
    if (holds_.nodes_by_place) nodes_by_place();
  }

  // One for each place, as elements name them.
  void nodes_by_place() {
    std::vector<Eigen::Vector3d> places;
    bool in_order = true;
    for (std::size_t i = 0; i < written_.nodes(); ++i) {
      places.push_back(document_.points[written_.node(i)]);
      if (holds_.single) places.back() = places.back().cast<float>().cast<double>().eval();
      in_order = in_order && (i == 0 || written_.node(i - 1) < written_.node(i));
    }
    if (!in_order)
      add("order of nodes", 1, fmt::format("the first is node {}", document_.node_tag(written_.node(0))));
    const std::size_t all = places.size();
    io::weld(places);
    add("nodes at the place of another one", all - places.size(), fmt::format("of {}", all));
    if (std::any_of(places.begin(), places.end(), [](const auto& p) { return p.hasNaN(); })) nodes_at_nan();
  }

  // They equal no place, not even their own, and come back once for each corner.
  void nodes_at_nan() {
    std::map<Index, std::size_t> corners;
    for (const Written& written : written_.blocks())
      for (std::size_t e = 0; e < written.block->count; ++e)
        if (written_.comes_back(written, e))
          for (int k = 0; k < written.nodes_each; ++k)
            if (const Index node = written_.nodes_of(*written.block, e)[k];
                document_.points[static_cast<std::size_t>(node)].hasNaN())
              ++corners[node];
    for (const auto& [node, count] : corners)
      if (count > 1)
        add("nodes at NaN, which become one for each corner", 1,
            fmt::format("node {}", document_.node_tag(static_cast<std::size_t>(node))));
  }

  // Those that come back count up from 0 or 1, or their numbers are lost.
  void node_numbers() {
    if (holds_.node_tags || written_.nodes() == 0) return;
    if (written_.all_nodes() && document_.node_tags.empty() && is_plain(document_.first_node)) return;
    const std::int64_t first = document_.node_tag(written_.node(0));
    std::int64_t next = first;
    bool plain = is_plain(first);
    for (std::size_t i = 0; i < written_.nodes() && plain; ++i)
      plain = document_.node_tag(written_.node(i)) == next++;
    if (!plain) add("numbers of nodes", written_.nodes(), fmt::format("the first is {}", first));
  }

  // Numbers that no node has, where they are written as others.
  void unknown_numbers() {
    if (!holds_.unknown_nodes || !holds_.unknown_number) return;
    for (std::size_t k = 0; k < document_.unknown.size(); ++k)
      if (const std::int64_t number = holds_.unknown_number(k); number != document_.unknown[k])
        add("numbers of nodes that do not exist", 1,
            fmt::format("{} becomes {}", document_.unknown[k], number));
  }

  void element_numbers() {
    if (holds_.element_tags || written_.blocks().empty()) return;
    std::int64_t first = 0, first_in_file = 0, position = 0, before = 0;
    bool plain = true, begun = false;  // plain: they count up from 0 or 1 and so do those in the file
    bool same = true;                  // they are those in the file, which start from 1
    std::size_t count = 0;
    auto cut = written_.cut().begin();
    for (const Written& written : written_.blocks()) {
      count += written.count;
      for (; cut != written_.cut().end() && cut->block < written.block; ++cut) position += cut->corners - 2;
      for (std::size_t e = 0; e < written.block->count && (plain || same || !begun); ++e) {
        if (!written_.comes_back(written, e)) continue;
        const std::size_t place = written.block->first + e;
        const std::int64_t tag = document_.element_tag(place),
                           in_file = holds_.numbers_all_elements ? static_cast<std::int64_t>(place) + 1
                                                                 : ++position;
        if (!begun) first = tag, first_in_file = in_file, begun = true;
        plain = plain && is_plain(first) && tag == first + before && is_plain(first_in_file) &&
                in_file == first_in_file + before;
        same = same && tag == in_file;
        ++before;
      }
    }
    if (!plain && !same) add("numbers of elements", count, fmt::format("the first is {}", first));
  }

  void coordinates() {
    if (!holds_.single) return;
    std::size_t rounded = 0;
    std::string example;
    for (std::size_t i = 0; i < written_.nodes(); ++i)
      for (const double x : document_.points[written_.node(i)])
        if (!std::isnan(x) && static_cast<double>(static_cast<float>(x)) != x && rounded++ == 0)
          example = fmt::format("{} becomes {}", x, static_cast<double>(static_cast<float>(x)));
    add("coordinates rounded to 32 bits", rounded, example);
  }

  // An entity that is nothing but a number, the only one or none, is no loss.
  void entities_of_elements() {
    if (holds_.element_entities) {
      add("numbers of entities", static_cast<std::size_t>(holds_.changed_entities), holds_.changed_entity);
      return;
    }
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      if (block.entity != 0 && block.entity != 1)
        add("entities of elements", count, fmt::format("{} in entity {}", name, block.entity));
    });
  }

  void entities_of_nodes() {
    const auto& blocks = document_.node_blocks;
    if (holds_.node_entities || blocks.empty() ||
        (blocks.size() == 1 && blocks[0].count == document_.points.size()))
      return;
    const NodeBlock& block = blocks[0];
    add("entities of nodes", document_.points.size(),
        fmt::format("node {} on entity {} of dimension {}", document_.node_tag(block.first), block.entity,
                    block.dim));
  }

  void entities() {
    if (holds_.entities) return;
    std::set<std::pair<int, std::int64_t>> underived;
    for (const Entity& entity : io::underived_entities(document_)) underived.insert({entity.dim, entity.tag});
    for (const Entity& entity : document_.entities) {
      const bool told_by_elements = !underived.count({entity.dim, entity.tag});
      if (told_by_elements && (holds_.element_entities || entity.tag == 0 || entity.tag == 1)) continue;
      add("entities with their boxes and boundaries", 1,
          fmt::format("{} of dimension {}", entity.tag, entity.dim));
    }
  }

  void groups() {
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(block.groups)];
      const std::string first = fmt::format("{} in groups {}", name, fmt::join(tags, " "));
      if (holds_.groups_of) {
        if (!holds_.groups_of(block)) add("physical groups of elements", count, first);
        return;
      }
      if (holds_.groups == Holds::Groups::none && !tags.empty())
        add("physical groups of elements", count, first);
      if (holds_.groups == Holds::Groups::first && tags.size() > 1)
        add("physical groups beyond an element's first", count, first);
    });
    for (const GroupName& name : document_.group_names)
      if (holds_.name ? !holds_.name(name) : !holds_.group_names)
        add("names of physical groups", 1, name.name);
  }

  void partitions() {
    std::int64_t largest = 0;
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      if (block.partitions == 0) return;
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(block.partitions)];
      if (!holds_.partitions)
        add("partitions of elements", count, fmt::format("{} in partition {}", name, fmt::join(tags, " ")));
      for (const std::int64_t tag : tags) largest = std::max(largest, tag < 0 ? -tag : tag);
    });
    if (!holds_.partition_count && document_.partitions != 0 &&
        document_.partitions != (holds_.partitions ? largest : 0))
      add("number of partitions", 1, fmt::format("{}", document_.partitions));
    if (holds_.ghosts) return;
    if (!document_.ghosts.empty())
      add("entities of ghost elements", document_.ghosts.size(),
          fmt::format("entity {} of partition {}", document_.ghosts[0].tag, document_.ghosts[0].partition));
    if (!document_.ghost_elements.empty()) {
      const GhostElement& ghost = document_.ghost_elements[0];
      add("ghost elements", document_.ghost_elements.size(),
          ghost.element >= 0
              ? fmt::format("element {} of partition {}",
                            document_.element_tag(static_cast<std::size_t>(ghost.element)), ghost.partition)
              : fmt::format("of partition {}", ghost.partition));
    }
  }

  void parameters() {
    if (!holds_.parameters)
      for (const NodeBlock& block : document_.node_blocks)
        if (block.parameters_each > 0)
          add("nodes with parametric coordinates", block.count,
              fmt::format("node {}", document_.node_tag(block.first)));
    if (!holds_.periodic && !document_.periodic.empty())
      add("periodic links", document_.periodic.size(),
          fmt::format("entity {} of dimension {} to {}", document_.periodic[0].entity,
                      document_.periodic[0].dim, document_.periodic[0].master));
  }

  void values(const std::vector<Values>& all, Of of, const char* whose) {
    for (const Values& values : all)
      if (!holds_.values(values, of))
        add(fmt::format("values \"{}\" of {}", values.name, whose), std::max<std::size_t>(values.size(), 1),
            !values.reals.empty()      ? fmt::format("{}", values.reals[0])
            : !values.integers.empty() ? fmt::format("{}", values.integers[0])
                                       : "");
  }

  // What TetGen's .poly says of the body to mesh.
  void boundary() {
    if (!holds_.boundary)
      each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
        if (block.of_boundary) add("elements as polygons of the boundary to mesh", count, name);
      });
    if (holds_.makes_boundary)
      for (const Written& written : written_.blocks())
        if (!written.block->of_boundary && written.block->dim == 2)
          add("elements as faces of a mesh, not polygons of a boundary to mesh", written.count,
              element(*written.block));
    if (!holds_.facets && !document_.facets.empty())
      add("facets of several polygons or with holes", document_.facets.size(),
          fmt::format("element {}", document_.element_tag(document_.facets[0].first)));
    const auto point = [](const Eigen::Vector3d& p) {
      return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
    };
    if (!holds_.holes && !document_.holes.empty())
      add("holes", document_.holes.size(), point(document_.holes[0]));
    if (!holds_.regions && !document_.regions.empty())
      add("regions", document_.regions.size(), point(document_.regions[0].point));
    if (holds_.bounds) return;
    if (!document_.area_bounds.empty())
      add("bounds of areas", document_.area_bounds.size(),
          fmt::format("{} for marker {}", document_.area_bounds[0].area, document_.area_bounds[0].marker));
    if (!document_.length_bounds.empty())
      add("bounds of lengths", document_.length_bounds.size(),
          fmt::format("{}", document_.length_bounds[0].length));
  }

  void rest() {
    const Voronoi& voronoi = document_.voronoi;
    if (!holds_.voronoi)
      add("parts of a Voronoi diagram",
          voronoi.points.size() + voronoi.edges.size() + voronoi.faces.size() + voronoi.cells.size(),
          fmt::format("{} points", voronoi.points.size()));
    for (const Table& table : document_.tables)
      if (holds_.table ? !holds_.table(table) : !holds_.tables)
        add(fmt::format("table \"{}\"", table.name), 1, fmt::format("{} rows", table.rows));
    if (!holds_.title && !document_.title.empty()) add("title", 1, document_.title);
    for (const Section& section : document_.sections)
      if (!holds_.section(section))
        add(fmt::format("section ${}", section.name), 1, fmt::format("{} bytes", section.body.size()));
  }

  const Document& document_;
  const Holds& holds_;
  const io::WrittenPart written_;
  std::vector<Loss> losses_;
};

}  // namespace

std::vector<Loss> io::unheld(const Document& document, const Holds& holds) {
  return Lister(document, holds).list();
}

std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options) {
  const Holds holds = io::holds_of(path, document, options);
  return holds.kept_in.empty() ? io::unheld(document, holds) : std::vector<Loss>{};
}

KeptAside kept_aside(const std::string& path, const Document& document, const WriteOptions& options) {
  const Holds holds = io::holds_of(path, document, options);
  if (holds.kept_in.empty()) return {};
  return {holds.kept_in, io::unheld(document, holds)};
}

}  // namespace tetproof
