// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/element_types.hpp"
#include "io/holds.hpp"
#include "io/msh_entities.hpp"
#include "io/weld.hpp"

namespace tetproof {
namespace {

using io::ElementType;
using io::Holds;
using io::Of;
using io::Shape;

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

// A block and how many of its elements come back.
struct Written {
  const ElementBlock* block;
  int nodes_each;
  std::size_t count;
};

class Lister {
 public:
  Lister(const Document& document, const Holds& holds) : document_(document), holds_(holds) {
    for (const ElementBlock& block : document.blocks) {
      const int each = holds.nodes_each(block);
      if (each == 0) continue;
      std::size_t count = block.count;
      if (!holds.unknown_nodes && !document.unknown.empty())
        for (std::size_t e = 0; e < block.count; ++e) count -= names_unknown(block, e);
      if (count > 0) written_.push_back({&block, each, count});
    }
    std::stable_sort(written_.begin(), written_.end(), [&](const Written& x, const Written& y) {
      return holds_.kind(*x.block) < holds_.kind(*y.block);
    });
  }

  std::vector<Loss> list() {
    elements();
    order();
    find_nodes();
    node_numbers();
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

  const Index* nodes_of(const ElementBlock& block, std::size_t e) const {
    return document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  }
  bool names_unknown(const ElementBlock& block, std::size_t e) const {
    const Index* node = nodes_of(block, e);
    return std::any_of(node, node + block.nodes_each, [](Index i) { return i < 0; });
  }
  bool comes_back(const Written& written, std::size_t e) const {
    return written.count == written.block->count || !names_unknown(*written.block, e);
  }

  // Elements that are not written, or without their nodes between the corners.
  void elements() {
    for (const ElementBlock& block : document_.blocks) {
      const std::string what =
          fmt::format("{} of {} nodes (type {})", name_of(block.type), block.nodes_each, block.type);
      const int each = holds_.nodes_each(block);
      if (each == 0) {
        add(what, block.count, element(block));
      } else if (!holds_.unknown_nodes && !document_.unknown.empty()) {
        unknown_nodes(block);
      }
    }
    for (const Written& written : written_)
      if (written.nodes_each < written.block->nodes_each)
        add(fmt::format("nodes between the corners of {} of {} nodes (type {})", name_of(written.block->type),
                        written.block->nodes_each, written.block->type),
            written.count, element(*written.block));
  }

  void unknown_nodes(const ElementBlock& block) {
    for (std::size_t e = 0; e < block.count; ++e) {
      if (!names_unknown(block, e)) continue;
      const Index* node = nodes_of(block, e);
      const Index bad = *std::find_if(node, node + block.nodes_each, [](Index i) { return i < 0; });
      add("elements that name nodes which do not exist", 1,
          fmt::format("{} names node {}", element(block, e), document_.named(bad)));
    }
  }

  // The writer puts them together by kind.
  void order() {
    for (std::size_t i = 1; i < written_.size(); ++i)
      if (written_[i].block < written_[i - 1].block)
        return add("order of elements", 1,
                   fmt::format("{} comes before those above it", element(*written_[i - 1].block)));
  }

  // The nodes that come back, in the order in which they do; empty: all as they are.
  void find_nodes() {
    if (holds_.which_nodes == Holds::Nodes::all && !holds_.nodes_by_place) return;
    std::vector<bool> seen(document_.points.size()), of_others(document_.points.size());
    std::vector<Index> by_elements;
    for (const Written& written : written_)
      for (std::size_t e = 0; e < written.block->count; ++e)
        for (int k = 0; k < written.nodes_each && comes_back(written, e); ++k) {
          const Index node = nodes_of(*written.block, e)[k];
          if (node < 0 || seen[static_cast<std::size_t>(node)]) continue;
          seen[static_cast<std::size_t>(node)] = true;
          by_elements.push_back(node);
        }
    if (holds_.nodes_by_place) {
      nodes_by_place(by_elements);
      nodes_ = std::move(by_elements);
    } else {
      if (holds_.which_nodes == Holds::Nodes::of_no_other_elements)
        for (const Index node : document_.connectivity)
          if (node >= 0) of_others[static_cast<std::size_t>(node)] = true;
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] || (holds_.which_nodes == Holds::Nodes::of_no_other_elements && !of_others[i]))
          nodes_.push_back(static_cast<Index>(i));
    }
    some_nodes_ = true;
    std::vector<bool> kept(document_.points.size());
    for (const Index node : nodes_) kept[static_cast<std::size_t>(node)] = true;
    const auto first = std::find(kept.begin(), kept.end(), false) - kept.begin();
    std::size_t lost = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    if (lost > 0)
      add("nodes of no element that is written", lost,
          fmt::format("node {}", document_.node_tag(static_cast<std::size_t>(first))));
  }

  // One for each place.
  void nodes_by_place(std::vector<Index>& nodes) {
    if (!std::is_sorted(nodes.begin(), nodes.end()))
      add("order of nodes", 1,
          fmt::format("the first is node {}", document_.node_tag(static_cast<std::size_t>(nodes[0]))));
    std::vector<Eigen::Vector3d> corners;
    for (const Index node : nodes) corners.push_back(document_.points[static_cast<std::size_t>(node)]);
    io::weld(corners);
    add("nodes at the place of another one", nodes.size() - corners.size(),
        fmt::format("of {}", nodes.size()));
  }

  std::size_t nodes() const { return some_nodes_ ? nodes_.size() : document_.points.size(); }
  std::size_t node(std::size_t i) const { return some_nodes_ ? static_cast<std::size_t>(nodes_[i]) : i; }

  // Those that come back count up from 0 or 1, or their numbers are lost.
  void node_numbers() {
    if (holds_.node_tags || nodes() == 0) return;
    if (!some_nodes_ && document_.node_tags.empty() && is_plain(document_.first_node)) return;
    std::int64_t next = document_.node_tag(node(0));
    bool plain = is_plain(next);
    for (std::size_t i = 0; i < nodes() && plain; ++i) plain = document_.node_tag(node(i)) == next++;
    if (!plain) add("numbers of nodes", nodes(), fmt::format("the first is {}", document_.node_tag(node(0))));
  }

  void element_numbers() {
    if (holds_.element_tags || written_.empty()) return;
    std::int64_t first = 0, next = 0;
    bool plain = true, begun = false;
    std::size_t count = 0;
    for (const Written& written : written_) {
      count += written.count;
      for (std::size_t e = 0; e < written.block->count && (plain || !begun); ++e) {
        if (!comes_back(written, e)) continue;
        const std::int64_t tag = document_.element_tag(written.block->first + e);
        if (!begun) first = next = tag, plain = is_plain(tag), begun = true;
        plain = plain && tag == next++;
      }
    }
    if (!plain) add("numbers of elements", count, fmt::format("the first is {}", first));
  }

  void coordinates() {
    if (!holds_.single) return;
    std::size_t rounded = 0;
    std::string example;
    for (std::size_t i = 0; i < nodes(); ++i)
      for (const double x : document_.points[node(i)])
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
    for (const Written& written : written_)
      if (written.block->entity != 0 && written.block->entity != 1)
        add("entities of elements", written.count,
            fmt::format("{} in entity {}", element(*written.block), written.block->entity));
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
    for (const Written& written : written_) {
      const ElementBlock& block = *written.block;
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(block.groups)];
      const std::string first = fmt::format("{} in groups {}", element(block), fmt::join(tags, " "));
      if (holds_.groups_of) {
        if (!holds_.groups_of(block)) add("physical groups of elements", written.count, first);
        continue;
      }
      if (holds_.groups == Holds::Groups::none && !tags.empty())
        add("physical groups of elements", written.count, first);
      if (holds_.groups == Holds::Groups::first && tags.size() > 1)
        add("physical groups beyond an element's first", written.count, first);
    }
    for (const GroupName& name : document_.group_names)
      if (holds_.name ? !holds_.name(name) : !holds_.group_names)
        add("names of physical groups", 1, name.name);
  }

  void partitions() {
    std::int64_t largest = 0;
    for (const Written& written : written_) {
      if (written.block->partitions == 0) continue;
      const auto& tags = document_.tag_sets[static_cast<std::size_t>(written.block->partitions)];
      if (!holds_.partitions)
        add("partitions of elements", written.count,
            fmt::format("{} in partition {}", element(*written.block), fmt::join(tags, " ")));
      for (const std::int64_t tag : tags) largest = std::max(largest, tag < 0 ? -tag : tag);
    }
    if (!holds_.partition_count && document_.partitions != (holds_.partitions ? largest : 0))
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
      for (const Written& written : written_)
        if (written.block->of_boundary)
          add("elements as polygons of the boundary to mesh", written.count, element(*written.block));
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
    if (!holds_.tables)
      for (const Table& table : document_.tables)
        add(fmt::format("table \"{}\"", table.name), 1, fmt::format("{} rows", table.rows));
    if (!holds_.title && !document_.title.empty()) add("title", 1, document_.title);
    for (const Section& section : document_.sections)
      if (!holds_.section(section))
        add(fmt::format("section ${}", section.name), 1, fmt::format("{} bytes", section.body.size()));
  }

  const Document& document_;
  const Holds& holds_;
  std::vector<Written> written_;  // by kind
  std::vector<Index> nodes_;      // that come back, if not all do as they are
  bool some_nodes_ = false;
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
