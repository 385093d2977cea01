// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "io/element_types.hpp"
#include "io/msh.hpp"
#include "io/msh22_limits.hpp"
#include "io/msh_entities.hpp"
#include "io/msh_write.hpp"
#include "io/tetgen.hpp"
#include "io/vtu.hpp"

namespace tetproof {
namespace {

using io::ElementType;
using io::Shape;

enum class Groups { none, first, all };
enum class ValuesHeld { none, tetgen, all };

// What a family of formats holds in full; the rest is asked case by case.
struct Holds {
  bool tags = false;           // of nodes and elements, any numbers
  bool unknown_nodes = false;  // references to nodes that do not exist
  bool entity_of_element = false, entity_of_node = false, entities = false;
  Groups groups = Groups::none;
  bool group_names = false, partitions = false;
  ValuesHeld values = ValuesHeld::none;
};

Holds holds(const std::string& format) {
  if (format == "msh41")
    return {.tags = true,
            .unknown_nodes = true,
            .entity_of_element = true,
            .entity_of_node = true,
            .entities = true,
            .groups = Groups::all,
            .group_names = true,
            .partitions = false,
            .values = ValuesHeld::none};
  if (format == "msh22")
    return {.tags = true,
            .unknown_nodes = true,
            .entity_of_element = true,
            .entity_of_node = false,
            .entities = false,
            .groups = Groups::first,
            .group_names = true,
            .partitions = true,
            .values = ValuesHeld::none};
  if (format == "vtu")
    return {.tags = false,
            .unknown_nodes = false,
            .entity_of_element = true,
            .entity_of_node = false,
            .entities = false,
            .groups = Groups::first,
            .group_names = false,
            .partitions = false,
            .values = ValuesHeld::all};
  Holds least;
  if (format == "tetgen") least.unknown_nodes = true, least.values = ValuesHeld::tetgen;
  return least;
}

const char* name_of(Shape shape) {
  switch (shape) {
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

class Lister {
 public:
  Lister(const Document& document, std::string format, bool binary)
      : document_(document), format_(std::move(format)), binary_(binary), holds_(holds(format_)) {
    if (format_ == "tetgen") tetgen_ = io::tetgen_limits(document);
    for (const Entity& entity : document.entities)
      if (entity.parent_dim >= 0) partitioned_.insert({entity.dim, entity.tag, entity.partitions});
    surface_ = format_ != "msh41" && format_ != "msh22" && format_ != "vtu" && format_ != "tetgen";
  }

  std::vector<Loss> list() {
    elements();
    numbers();
    entities();
    groups();
    parameters();
    values();
    for (const Section& section : document_.sections)
      if (format_.rfind("msh", 0) != 0 || !io::keeps_section(section, format_, binary_) || drops_data_)
        add(fmt::format("section ${}", section.name), 1, fmt::format("{} bytes", section.body.size()));
    return std::move(losses_);
  }

 private:
  void add(const std::string& item, std::int64_t count, const std::string& example) {
    if (count <= 0) return;
    for (Loss& loss : losses_)
      if (loss.item == item) {
        loss.count += count;
        return;
      }
    losses_.push_back({item, count, example});
  }

  // Elements that are not written, or without their nodes between the corners.
  void elements() {
    for (const ElementBlock& block : document_.blocks) {
      const ElementType* type = io::element_type(block.type);
      const Shape shape = type ? type->shape : Shape::other;
      const std::string what =
          fmt::format("{} of {} nodes (type {})", name_of(shape), block.nodes_each, block.type);
      const auto count = static_cast<std::int64_t>(block.count);
      const std::string first = fmt::format("element {}", document_.element_tag(block.first));
      bool written = true;
      if (format_ == "vtu")
        written = io::vtk_cell_type(block.type) != 0;
      else if (format_ == "tetgen")
        written = shape == Shape::tetrahedron;
      else if (surface_)
        written = shape == Shape::triangle;
      else
        written = io::msh_holds(document_, block, format_, binary_);
      if (!written) {
        add(what, count, first);
        continue;
      }
      const bool corners_only = type && type->nodes > type->corners &&
                                (surface_ || (format_ == "tetgen" && tetgen_.nodes_each == type->corners));
      if (corners_only) add("nodes between the corners of " + what, count, first);
      if (!holds_.unknown_nodes) unknown_nodes(block);
    }
  }

  void unknown_nodes(const ElementBlock& block) {
    for (std::size_t e = 0; e < block.count; ++e) {
      const Index* node = document_.connectivity.data() + block.nodes + e * block.nodes_each;
      const Index* bad = std::find_if(node, node + block.nodes_each, [](Index i) { return i < 0; });
      if (bad != node + block.nodes_each)
        add("elements that name nodes which do not exist", 1,
            fmt::format("element {} names node {}", document_.element_tag(block.first + e),
                        document_.named(*bad)));
    }
  }

  void numbers() {
    const auto nodes = static_cast<std::int64_t>(document_.points.size());
    const auto count = static_cast<std::int64_t>(document_.elements());
    const auto plain = [](std::int64_t first) { return first == 0 || first == 1; };
    bool lost_nodes = !holds_.tags && (!document_.node_tags.empty() || !plain(document_.first_node));
    bool lost_elements = !holds_.tags && (!document_.element_tags.empty() || !plain(document_.first_element));
    if (format_ == "tetgen") lost_elements = tetgen_.renumber_elements;
    if (format_ == "msh22") {
      const io::Msh22Limits limits = io::msh22_limits(document_, binary_);
      lost_nodes = limits.renumber_nodes, lost_elements = limits.renumber_elements;
      drops_data_ = lost_nodes || lost_elements;
    }
    if (lost_nodes && nodes > 0)
      add("numbers of nodes", nodes, fmt::format("the first is {}", document_.node_tag(0)));
    if (lost_elements && count > 0)
      add("numbers of elements", count, fmt::format("the first is {}", document_.element_tag(0)));
    if (surface_) unused_vertices();
  }

  // Surfaces keep no vertices that belong to other elements, and STL none that no triangle uses.
  void unused_vertices() {
    const TriangleSurface surface = surface_of(document_);
    const std::vector<bool> used = used_vertices(surface);
    const auto kept = format_ == "stl" ? std::count(used.begin(), used.end(), true)
                                       : static_cast<std::ptrdiff_t>(surface.vertices.size());
    add("nodes that no triangle has as a corner", static_cast<std::int64_t>(document_.points.size()) - kept,
        fmt::format("of {} nodes", document_.points.size()));
    if (format_ == "stl" && binary_) rounding(surface, used);
  }

  static std::vector<bool> used_vertices(const TriangleSurface& surface) {
    std::vector<bool> used(surface.vertices.size());
    for (const auto& triangle : surface.triangles)
      for (Index i : triangle)
        if (i >= 0) used[i] = true;
    return used;
  }

  void rounding(const TriangleSurface& surface, const std::vector<bool>& used) {
    std::int64_t rounded = 0;
    std::string first;
    for (std::size_t i = 0; i < used.size(); ++i)
      for (double x : surface.vertices[i])
        if (used[i] && static_cast<double>(static_cast<float>(x)) != x && !std::isnan(x) && rounded++ == 0)
          first = fmt::format("{} becomes {}", x, static_cast<double>(static_cast<float>(x)));
    add("coordinates rounded to 32 bits", rounded, first);
  }

  void entities() {
    std::int64_t elements = 0, changed = 0;
    std::string first, first_changed;
    const io::EntityPlan plan = io::plan_entities(document_);
    for (std::size_t b = 0; b < document_.blocks.size(); ++b) {
      const ElementBlock& block = document_.blocks[b];
      const std::string name =
          fmt::format("element {} in entity {}", document_.element_tag(block.first), block.entity);
      if (!holds_.entity_of_element && block.entity != 0 && block.entity != 1) {
        if (elements == 0) first = name;
        elements += static_cast<std::int64_t>(block.count);
      }
      if (holds_.entities && block.entity != 0 && plan.block_tags[b] != block.entity) {
        if (changed == 0) first_changed = fmt::format("{} comes into entity {}", name, plan.block_tags[b]);
        changed += static_cast<std::int64_t>(block.count);
      }
      if (!holds_.partitions && block.partitions != 0 && !(holds_.entities && in_partitioned_entity(block)))
        add("partitions of elements", static_cast<std::int64_t>(block.count),
            fmt::format("element {} in partition {}", document_.element_tag(block.first),
                        fmt::join(document_.tag_sets[block.partitions], " ")));
    }
    add("entities of elements", elements, first);
    add("numbers of entities", changed, first_changed);
    if (!holds_.entity_of_node && document_.node_blocks.size() > 1 &&
        !(format_ == "msh22" && io::msh22_limits(document_, binary_).parametric))
      add("entities of nodes", static_cast<std::int64_t>(document_.points.size()),
          fmt::format("node {} on entity {} of dimension {}",
                      document_.node_tag(document_.node_blocks[0].first), document_.node_blocks[0].entity,
                      document_.node_blocks[0].dim));
    if (holds_.entities) return;
    std::set<std::pair<int, std::int64_t>> underived;
    for (const Entity& entity : io::underived_entities(document_)) underived.insert({entity.dim, entity.tag});
    for (const Entity& entity : document_.entities) {
      const bool told_by_elements = !underived.count({entity.dim, entity.tag});
      if (told_by_elements && (holds_.entity_of_element || entity.tag == 0 || entity.tag == 1)) continue;
      add("entities with their boxes and boundaries", 1,
          fmt::format("{} of dimension {}", entity.tag, entity.dim));
    }
  }

  bool in_partitioned_entity(const ElementBlock& block) const {
    return partitioned_.count({block.dim, block.entity, block.partitions}) > 0;
  }

  void groups() {
    for (const ElementBlock& block : document_.blocks) {
      const auto& tags = document_.tag_sets[block.groups];
      const std::string first =
          fmt::format("element {} in groups {}", document_.element_tag(block.first), fmt::join(tags, " "));
      const auto count = static_cast<std::int64_t>(block.count);
      if (holds_.groups == Groups::none && !tags.empty()) add("physical groups of elements", count, first);
      if (holds_.groups == Groups::first && tags.size() > 1)
        add("physical groups beyond an element's first", count, first);
    }
    if (!holds_.group_names && !document_.group_names.empty())
      add("names of physical groups", static_cast<std::int64_t>(document_.group_names.size()),
          document_.group_names[0].name);
  }

  void parameters() {
    if (document_.parameters.empty() || format_ == "msh41") return;
    const bool written = format_ == "msh22" && io::msh22_limits(document_, binary_).parametric;
    for (const NodeBlock& block : document_.node_blocks)
      if (block.parameters_each > 0 && !(written && block.dim < 3))
        add("nodes with parametric coordinates", static_cast<std::int64_t>(block.count),
            fmt::format("node {}", document_.node_tag(block.first)));
  }

  void values() {
    const auto check = [&](const std::vector<Values>& all, const char* of) {
      for (const Values& values : all) {
        const bool tetgens = values.name == "attributes" || values.name == "markers";
        if (holds_.values == ValuesHeld::none || (holds_.values == ValuesHeld::tetgen && !tetgens))
          add(fmt::format("values \"{}\" of {}", values.name, of),
              static_cast<std::int64_t>(std::max(values.reals.size(), values.integers.size())),
              values.reals.empty() ? values.integers.empty() ? "" : fmt::format("{}", values.integers[0])
                                   : fmt::format("{}", values.reals[0]));
      }
    };
    check(document_.node_values, "nodes");
    check(document_.element_values, "elements");
  }

  const Document& document_;
  const std::string format_;
  const bool binary_;
  const Holds holds_;
  bool surface_ = false, drops_data_ = false;
  io::TetgenLimits tetgen_;
  std::set<std::tuple<int, std::int64_t, std::int32_t>> partitioned_;  // entities
  std::vector<Loss> losses_;
};

}  // namespace

std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options) {
  const Encoding encoding = encoding_of(path, options);
  return Lister(document, encoding.format, encoding.binary).list();
}

}  // namespace tetproof
