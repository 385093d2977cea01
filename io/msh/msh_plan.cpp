// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string_view>

#include "io/model/element_types.hpp"
#include "io/model/values.hpp"
#include "io/msh/msh_write.hpp"

namespace tetproof::io {
namespace {

// Sections whose meaning depends on the version.
constexpr std::array<std::string_view, 16> versioned{
    "MeshFormat",      "PhysicalNames", "Nodes",         "Elements",
    "ParametricNodes", "NOD",           "NOE",           "ELM",
    "Entities",        "Periodic",      "PeriodicNodes", "PartitionedEntities",
    "ElementCuts",     "BoundaryLayer", "GhostElements", "Parametrizations"};
// Sections that name nodes or elements, in the same way in all versions.
constexpr std::array<std::string_view, 3> data{"NodeData", "ElementData", "ElementNodeData"};

bool contains(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool fits_int(std::int64_t tag) {
  return tag >= -largest_int - 1 && tag <= largest_int;
}

bool all_differ(const std::vector<std::int64_t>& tags) {
  if (std::is_sorted(tags.begin(), tags.end(), std::less_equal<>())) return true;  // strictly ascending
  std::vector<std::int64_t> sorted = tags;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

// Whether a text can be written in double quotes. It ends with the last quote of its line.
bool is_quotable(const std::string& text) {
  return text.find_first_of("\r\n") == text.npos;
}

// Runs of nodes as a reader makes them. `merged`: it joins neighbouring runs of one entity.
std::vector<NodeBlock> runs_of(const std::vector<NodeBlock>& blocks, bool merged) {
  std::vector<NodeBlock> runs;
  for (const NodeBlock& block : blocks) {
    if (block.count == 0) continue;
    if (merged && !runs.empty() && runs.back().dim == block.dim && runs.back().entity == block.entity)
      runs.back().count += block.count;
    else
      runs.push_back(block);
  }
  return runs;
}

bool same_runs(const std::vector<NodeBlock>& a, const std::vector<NodeBlock>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const NodeBlock& x, const NodeBlock& y) {
    return x.dim == y.dim && x.entity == y.entity && x.first == y.first && x.count == y.count;
  });
}

// Whether a section that was kept as it stood means the same in a file of this kind.
bool keeps_section(const Section& section, const std::string& format, bool binary) {
  if (section.name == "InterpolationScheme") return true;  // always text
  const bool same_bytes = section.binary == binary && !(section.binary && section.swapped);
  if (contains(data, section.name)) return same_bytes;
  if (contains(versioned, section.name)) return same_bytes && section.format == format;
  return true;  // no version gives it a meaning
}

// Whether elements of a block can be written. Where Gmsh's list does not tell how many nodes a type has, only
// text can, and, polygons and polyhedra apart, only in the version that the elements came in.
bool has_place_for(const Document& document, const ElementBlock& block, const std::string& format,
                   bool binary) {
  // Gmsh's own polyhedra are lists of tetrahedra, not of faces.
  if (!is_of_gmsh(block.type) || !block.faces.empty()) return false;
  if (const ElementType* type = element_type(block.type)) return type->nodes == block.nodes_each;
  return !binary && (has_counted_nodes(block.type) || document.format == format) && block.nodes_each > 0;
}

// What is held in the same way by all versions.
Holds names_and_elements(const Document& document, const std::string& format, bool binary) {
  Holds holds;
  holds.kept_in = "$TetproofSupplement";
  holds.name = [](const GroupName& name) { return is_quotable(name.name); };
  holds.nodes_each = [&document, format, binary](const ElementBlock& block) {
    return has_place_for(document, block, format, binary) ? block.nodes_each : 0;
  };
  return holds;
}

void hold_data(const Document& document, const MshTags& tags, const std::string& format, bool binary,
               Holds& holds) {
  const bool any = !document.node_values.empty() || !document.element_values.empty() ||
                   !document.element_node_values.empty() || !document.ghost_elements.empty() ||
                   !document.periodic.empty();
  const bool nodes_differ = any && (tags.renumber || all_differ(document.node_tags));
  const bool elements_differ = any && (tags.renumber || all_differ(document.element_tags));
  const bool short_numbers = binary && format != "msh22";
  holds.periodic =
      nodes_differ &&
      std::all_of(document.periodic.begin(), document.periodic.end(), [&](const PeriodicLink& link) {
        return link.dim >= 0 && link.dim <= 3 &&
               (format == "msh41" || link.affine.empty() || link.affine.size() == 16) &&
               (!short_numbers || (fits_int(link.entity) && fits_int(link.master)));
      });
  holds.ghosts = elements_differ || document.ghost_elements.empty();
  for (const GhostElement& ghost : document.ghost_elements)
    if (short_numbers &&
        !(fits_int(ghost.partition) && std::all_of(ghost.ghosts.begin(), ghost.ghosts.end(), fits_int)))
      holds.ghosts = false;
  holds.ghost_entities = format != "msh22" || document.ghosts.empty();
  if (document.periodic.empty()) holds.periodic = true;
  const auto stores = [tags, binary, nodes_differ, elements_differ](const Values& values, Of of) {
    if (!values.labels.empty() || values.components < 1) return false;
    if (!is_quotable(values.name) || !is_quotable(values.interpolation)) return false;
    if (!values.of_view && has_step(values)) return false;
    if (!(of == Of::node ? nodes_differ : elements_differ)) return false;
    if ((of == Of::element_node) == values.nodes.empty() && values.size() > 0) return false;
    std::size_t size = of == Of::element_node ? 0 : values.items();
    for (const std::int32_t nodes : values.nodes) size += static_cast<std::size_t>(nodes);
    if (size * static_cast<std::size_t>(values.components) != values.size()) return false;
    for (std::size_t i = 0; binary && i < values.items(); ++i) {
      const Index at = values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i];
      if (!fits_int(of == Of::node ? tags.node(at) : tags.element(at))) return false;
    }
    return true;
  };
  holds.values = [stores](const Values& values, Of of) {
    return values.integers.empty() && stores(values, of);
  };
  // Gmsh shows them as any data.
  holds.as_reals = [stores](const Values& values, Of of) {
    constexpr std::int64_t most = std::int64_t{1} << 53;
    return !values.integers.empty() && stores(values, of) &&
           std::all_of(values.integers.begin(), values.integers.end(),
                       [](std::int64_t i) { return i >= -most && i <= most; });
  };
  holds.section = [format, binary, tags](const Section& section) {
    return section.body.ends_with('\n') && keeps_section(section, format, binary) &&
           !(tags.renumber && contains(data, section.name));
  };
}

// Whether all ghost elements are of a type that is written.
bool ghosts_are_written(const Document& document, const Holds& holds) {
  if (document.ghost_elements.empty()) return true;
  std::vector<bool> written(document.elements(), true);
  for (const ElementBlock& block : document.blocks)
    if (holds.nodes_each(block) == 0)
      std::fill_n(written.begin() + static_cast<std::ptrdiff_t>(block.first), block.count, false);
  return std::all_of(document.ghost_elements.begin(), document.ghost_elements.end(), [&](const auto& ghost) {
    return ghost.element >= 0 && static_cast<std::size_t>(ghost.element) < written.size() &&
           written[static_cast<std::size_t>(ghost.element)];
  });
}

}  // namespace

Holds msh22_holds(const Document& document, const Msh22Limits& limits, bool ghosts, bool binary) {
  Holds holds = names_and_elements(document, "msh22", binary);
  holds.node_tags = holds.element_tags = !limits.renumber;
  holds.numbers_all_elements = true;
  if (limits.renumber)
    holds.unknown_number = [first = limits.first_unknown](std::size_t k) {
      return first + static_cast<std::int64_t>(k);
    };
  holds.unknown_nodes = true;
  holds.entities = document.entities.empty();
  // A negative partition beside a positive one comes back as a ghost element.
  holds.partitions = std::all_of(document.blocks.begin(), document.blocks.end(), [&](const ElementBlock& b) {
    const auto& tags = document.tag_sets[static_cast<std::size_t>(b.partitions)];
    return std::none_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag < 0; }) ||
           std::none_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag > 0; });
  });
  holds.element_entities = true;
  holds.groups = Holds::Groups::all;
  for (const ElementBlock& block : document.blocks) {
    if (block.entity != 0 && block.dim != dimension22(block.type)) holds.element_entities = false;
  }
  holds.groups_of = [&document](const ElementBlock& block) {
    const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return groups.empty() || (groups[0] != 0 && groups == groups22(document, block));
  };
  holds.node_entities =
      limits.parametric ? same_runs(runs_of(document.node_blocks, true), runs_of(limits.node_blocks, true))
                        : document.node_blocks.empty();
  holds.parameters =
      std::all_of(document.node_blocks.begin(), document.node_blocks.end(), [&](const NodeBlock& block) {
        return block.parameters_each == 0 || (limits.parametric && (block.dim == 1 || block.dim == 2) &&
                                              block.parameters_each == block.dim);
      });
  hold_data(document, {&document, limits.renumber, limits.first_unknown}, "msh22", binary, holds);
  holds.ghosts = ghosts && ghosts_are_written(document, holds);
  return holds;
}

namespace {

bool same(const Entity& a, const Entity& b) {
  return a.dim == b.dim && a.groups == b.groups && a.tag == b.tag && a.boundary == b.boundary &&
         a.parent_dim == b.parent_dim && a.parent == b.parent && a.partitions == b.partitions;
}

// Whether the document's entities come back in their order. Others may come between them.
bool holds_entities(const Document& document, const std::vector<Entity>& written, const std::string& format) {
  auto next = written.begin();
  for (const Entity& entity : document.entities) {
    next = std::find_if(next, written.end(), [&](const Entity& other) { return same(entity, other); });
    if (next++ == written.end()) return false;
    const bool has_box = format == "msh40" || entity.dim > 0 ||
                         std::equal(entity.box.begin(), entity.box.begin() + 3, entity.box.begin() + 3);
    if (!has_box || (entity.dim == 0 && !entity.boundary.empty()) ||
        (entity.parent_dim < 0 && (entity.partitions != 0 || entity.parent != 0)))
      return false;
  }
  return true;
}

}  // namespace

bool counts_from_zero(const Document& document) {
  return document.node_tags.empty() && document.element_tags.empty() &&
         ((document.first_node == 0 && !document.points.empty()) ||
          (document.first_element == 0 && document.elements() > 0));
}

MshTags msh4_tags(const Document& document) {
  if (!counts_from_zero(document)) return {&document};
  return {&document, true,
          static_cast<std::int64_t>(std::max(document.points.size(), document.elements())) + 1};
}

Holds msh4_holds(const Document& document, const EntityPlan& plan, const std::string& format, bool binary) {
  Holds holds = names_and_elements(document, format, binary);
  const MshTags tags = msh4_tags(document);
  holds.unknown_nodes = true;
  holds.node_tags = holds.element_tags = !tags.renumber;
  holds.numbers_all_elements = true;
  if (tags.renumber)
    holds.unknown_number = [first = tags.first_unknown](std::size_t k) {
      return first + static_cast<std::int64_t>(k);
    };
  holds.entities = holds_entities(document, plan.entities, format);
  holds.element_entities = true;
  std::map<std::pair<int, std::int64_t>, const Entity*> entities;
  for (const Entity& entity : plan.entities) entities.try_emplace({entity.dim, entity.tag}, &entity);
  holds.groups = Holds::Groups::all;
  holds.partitions = holds.partition_count = true;
  for (std::size_t b = 0; b < document.blocks.size(); ++b) {
    const ElementBlock& block = document.blocks[b];
    const Entity& entity = *entities.at({block.dim, plan.block_tags[b]});
    if (block.entity != 0 && plan.block_tags[b] != block.entity) {
      if (holds.changed_entities == 0)
        holds.changed_entity =
            fmt::format("element {} in entity {} comes into entity {}", document.element_tag(block.first),
                        block.entity, plan.block_tags[b]);
      holds.changed_entities += static_cast<std::int64_t>(block.count);
    }
    if (entity.groups != block.groups) holds.groups = Holds::Groups::none;
    if (entity.partitions != block.partitions) holds.partitions = false;
  }
  holds.node_entities = same_runs(runs_of(document.node_blocks, false), runs_of(plan.node_blocks, false));
  holds.parameters =
      std::all_of(document.node_blocks.begin(), document.node_blocks.end(), [](const NodeBlock& block) {
        return block.parameters_each == 0 || block.parameters_each == block.dim;
      });
  hold_data(document, tags, format, binary, holds);
  return holds;
}

}  // namespace tetproof::io
