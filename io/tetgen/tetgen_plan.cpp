// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tetgen/tetgen_plan.hpp"

#include <algorithm>

#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_order.hpp"

namespace tetproof::io {
namespace {

bool has_shape(const ElementBlock& block, Shape shape) {
  const ElementType* type = element_type(block.type);
  return type && type->shape == shape;
}

void add(TetgenList& list, const ElementBlock& block) {
  if (block.count == 0) return;
  list.blocks.push_back(&block);
  list.count += block.count;
}

bool all_of_type(const TetgenList& list, int type) {
  return list.count > 0 && std::all_of(list.blocks.begin(), list.blocks.end(),
                                       [&](const ElementBlock* block) { return block->type == type; });
}

std::vector<TetgenRun> runs_of(const Document& document, const TetgenList& list) {
  std::vector<TetgenRun> runs;
  for (const ElementBlock* block : list.blocks)
    runs.push_back({document.connectivity.data() + block->nodes, block->count});
  return runs;
}

// The elements of a list stand one after the other from `first` on.
bool is_run(const TetgenList& list, std::size_t first) {
  for (const ElementBlock* block : list.blocks) {
    if (block->first != first) return false;
    first += block->count;
  }
  return true;
}

bool is_plain(const Values& values, const char* name) {
  return values.name == name && values.at.empty() && values.nodes.empty() && values.labels.empty() &&
         !values.of_view && values.reals.empty() != values.integers.empty();
}
bool has_columns(const Values& values, std::size_t items, bool reals, int components) {
  return values.components >= 1 && (components == 0 || values.components == components) &&
         values.reals.empty() != reals &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

// Values of all elements of a list and of no others; `components` 0: any number.
const Values* values_of(const Document& document, const TetgenList& list, const char* name, bool reals,
                        int components) {
  if (list.count == 0 || !is_run(list, list.blocks[0]->first)) return nullptr;
  for (const Values& values : document.element_values)
    if (is_plain(values, name) && values.first == list.blocks[0]->first &&
        has_columns(values, list.count, reals, components))
      return &values;
  return nullptr;
}

const Values* node_values(const Document& document, const char* name, bool reals, int components) {
  if (document.points.empty()) return nullptr;
  for (const Values& values : document.node_values)
    if (is_plain(values, name) && values.first == 0 &&
        has_columns(values, document.points.size(), reals, components))
      return &values;
  return nullptr;
}

// Whether the groups of a list can stand in the place of values that no element has.
bool tells_groups(const Document& document, const TetgenList& list, const char* name) {
  return std::none_of(document.element_values.begin(), document.element_values.end(),
                      [&](const Values& values) { return values.name == name; }) &&
         std::any_of(list.blocks.begin(), list.blocks.end(), [&](const ElementBlock* block) {
           return !document.tag_sets[static_cast<std::size_t>(block->groups)].empty();
         });
}

TetgenPlan plan_nodes(const Document& document) {
  TetgenPlan plan;
  plan.renumber_nodes = !document.node_tags.empty() || (document.first_node != 0 && document.first_node != 1);
  plan.base = plan.renumber_nodes ? 1 : document.first_node;
  plan.attributes = node_values(document, "attributes", true, 0);
  plan.markers = node_values(document, "markers", false, 1);
  plan.sizes = node_values(document, "sizes", true, 0);
  if (plan.sizes && plan.sizes->components != 1 && plan.sizes->components != 3 && plan.sizes->components != 6)
    plan.sizes = nullptr;
  plan.bounds = !document.area_bounds.empty() || !document.length_bounds.empty();
  return plan;
}

void plan_edges(const Document& document, TetgenPlan& plan) {
  plan.edge_markers = values_of(document, plan.edges, "markers", false, 1);
  plan.edge_tets = values_of(document, plan.edges, "neighbours", false, 1);
  plan.edge_groups = tells_groups(document, plan.edges, "markers");
  // Values of one name are told apart by their order, and those of edges are read last.
  const Values* const before = plan.plc ? plan.facet_markers : plan.face_markers;
  if (plan.edge_markers < before) plan.edge_markers = nullptr;
}

enum class PlcPart { facets, edges, none };

bool says_boundary(const Document& document) {
  return std::any_of(document.blocks.begin(), document.blocks.end(),
                     [](const ElementBlock& block) { return block.of_boundary && block.count > 0; });
}

// `said`: the document says which elements are of the boundary.
PlcPart part_of(const ElementBlock& block, bool said) {
  const ElementType* type = element_type(block.type);
  const bool has_corners = type ? type->dim <= 2 && type->shape != Shape::other : block.type == polygon;
  if (!has_corners || block.nodes_each < 1) return PlcPart::none;
  if (said ? block.of_boundary : !type || type->dim == 2) return PlcPart::facets;
  return !block.of_boundary && has_shape(block, Shape::line) ? PlcPart::edges : PlcPart::none;
}

// Of the lists in this order, numbers that count up from the base.
bool counts_up(const Document& document, std::int64_t base, std::initializer_list<const TetgenList*> lists) {
  for (const TetgenList* list : lists)
    for (const ElementBlock* block : list->blocks)
      for (std::size_t e = 0; e < block->count; ++e)
        if (document.element_tag(block->first + e) != base++) return false;
  return true;
}

bool list_is_valid(const std::vector<Index>& items, std::size_t most) {
  for (std::size_t k = 0; k < items.size(); ++k)
    if (items[k] >= static_cast<std::int64_t>(most) || items[k] < (k + 1 == items.size() ? -1 : 0))
      return false;
  return true;
}

// What the files of a Voronoi diagram can say and their reader takes.
bool voronoi_is_valid(const Document& document, std::int64_t base) {
  const Voronoi& v = document.voronoi;
  if (v.points.empty() && v.edges.empty() && v.faces.empty() && v.cells.empty()) return false;
  if ((v.first != 0 && v.first != 1) || (v.points.empty() && v.first != base)) return false;
  const auto points = static_cast<std::int64_t>(v.points.size()),
             nodes = static_cast<std::int64_t>(document.points.size());
  for (const Voronoi::Edge& edge : v.edges)
    if (edge.points[0] < 0 || edge.points[0] >= points || edge.points[1] < -1 || edge.points[1] >= points ||
        (edge.points[1] >= 0 && edge.direction != Eigen::Vector3d::Zero()))
      return false;
  for (const Voronoi::Face& face : v.faces) {
    for (const Index cell : face.cells)
      if (cell < 0 || cell >= nodes) return false;
    if (!list_is_valid(face.edges, v.edges.size())) return false;
  }
  return std::all_of(v.cells.begin(), v.cells.end(),
                     [&](const std::vector<Index>& cell) { return list_is_valid(cell, v.faces.size()); });
}

}  // namespace

// A number that no node has must stay one that no node has.
std::int64_t tetgen_unknown(const Document& document, std::int64_t base, std::size_t k) {
  const std::int64_t number = document.unknown[k],
                     behind = base + static_cast<std::int64_t>(document.points.size());
  return number >= base && number < behind ? behind + static_cast<std::int64_t>(k) : number;
}

std::int64_t TetgenPlan::number(const Document& document, Index node) const {
  return node >= 0 ? base + node : tetgen_unknown(document, base, static_cast<std::size_t>(-1 - node));
}

std::int64_t first_group(const Document& document, const ElementBlock& block) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  return groups.empty() ? 0 : groups[0];
}

TetgenPlan tetgen_mesh_plan(const Document& document) {
  TetgenPlan plan = plan_nodes(document);
  for (const ElementBlock& block : document.blocks) {
    if (block.of_boundary) continue;
    if (has_shape(block, Shape::tetrahedron)) add(plan.tets, block);
    if (has_shape(block, Shape::triangle)) add(plan.faces, block);
    if (has_shape(block, Shape::line)) add(plan.edges, block);
  }
  // TetGen expects faces and edges to be of second order where the tetrahedra are, and nowhere else. Nodes
  // between corners that a reader would take for those of another order are not written.
  const std::vector<TetgenRun> tets = runs_of(document, plan.tets), faces = runs_of(document, plan.faces);
  plan.tets.nodes_each = all_of_type(plan.tets, tetrahedron10) && !are_turned(document, tets) ? 10 : 4;
  const bool second_order = plan.tets.nodes_each == 10;
  plan.faces.nodes_each = second_order && all_of_type(plan.faces, triangle6) &&
                                  !have_nodes_opposite_corners(document, faces, tets)
                              ? 6
                              : 3;
  plan.edges.nodes_each = second_order && all_of_type(plan.edges, line3) ? 3 : 2;
  plan.renumber_elements = !counts_up(document, plan.base, {&plan.tets, &plan.faces, &plan.edges});

  plan.tet_attributes = values_of(document, plan.tets, "attributes", true, 0);
  plan.volume_bounds = values_of(document, plan.tets, "volume bounds", true, 1);
  plan.neighbours = values_of(document, plan.tets, "neighbours", false, 4);
  plan.tet_faces = values_of(document, plan.tets, "faces", false, 4);
  plan.tet_edges = values_of(document, plan.tets, "edges", false, 6);
  plan.face_markers = values_of(document, plan.faces, "markers", false, 1);
  plan.face_tets = values_of(document, plan.faces, "neighbours", false, 2);
  plan.face_edges = values_of(document, plan.faces, "edges", false, 3);
  plan.tet_groups = tells_groups(document, plan.tets, "attributes");
  plan.face_groups = tells_groups(document, plan.faces, "markers");
  plan_edges(document, plan);
  // Behind corners alone these columns would be taken for nodes between corners.
  if (second_order && plan.faces.nodes_each == 3) plan.face_tets = nullptr;
  if (second_order && plan.edges.nodes_each == 2) plan.edge_tets = nullptr;
  plan.voronoi = voronoi_is_valid(document, plan.base);
  return plan;
}

TetgenPlan tetgen_plc_plan(const Document& document) {
  TetgenPlan plan = plan_nodes(document);
  plan.plc = true;
  const bool said = says_boundary(document);
  for (const ElementBlock& block : document.blocks)
    if (const PlcPart part = part_of(block, said); part != PlcPart::none)
      add(part == PlcPart::facets ? plan.polygons : plan.edges, block);
  plan.edges.nodes_each = 2;
  plan.renumber_elements = !counts_up(document, plan.base, {&plan.polygons, &plan.edges});
  plan.facet_markers = values_of(document, plan.polygons, "markers", false, 1);
  plan_edges(document, plan);

  const bool run = plan.polygons.count > 0 && is_run(plan.polygons, plan.polygons.blocks[0]->first);
  std::size_t next = run ? plan.polygons.blocks[0]->first : 0;
  const std::size_t end = run ? next + plan.polygons.count : 0;
  for (std::size_t f = 0; f < document.facets.size(); ++f) {
    const Facet& facet = document.facets[f];
    if (facet.first < next || facet.first >= end || facet.polygons < 1 ||
        facet.polygons > end - facet.first || (facet.polygons == 1 && facet.holes.empty())) {
      plan.facets_as_said = false;
      continue;
    }
    plan.facets.push_back(f);
    next = facet.first + facet.polygons;
    if (!plan.facet_markers) continue;
    const std::int64_t* marker =
        plan.facet_markers->integers.data() + (facet.first - plan.facet_markers->first);
    if (std::any_of(marker, marker + facet.polygons, [&](std::int64_t m) { return m != *marker; }))
      plan.facet_markers = nullptr;  // a facet has one marker
  }
  plan.polygon_groups = plan.facets.empty() && tells_groups(document, plan.polygons, "markers");
  return plan;
}

namespace {

Holds holds_of(const Document& document, const TetgenPlan& plan) {
  Holds holds;
  holds.element_tags = !plan.renumber_elements;
  holds.node_tags = !plan.renumber_nodes;
  holds.unknown_nodes = true;
  holds.unknown_number = [&document, base = plan.base](std::size_t k) {
    return tetgen_unknown(document, base, k);
  };
  holds.kept_in = "comments";
  holds.bounds = true;
  std::vector<const Values*> held{plan.attributes,    plan.markers,      plan.sizes,      plan.tet_attributes,
                                  plan.volume_bounds, plan.neighbours,   plan.tet_faces,  plan.tet_edges,
                                  plan.face_markers,  plan.face_tets,    plan.face_edges, plan.edge_markers,
                                  plan.edge_tets,     plan.facet_markers};
  held.erase(std::remove(held.begin(), held.end(), nullptr), held.end());
  holds.values = [held](const Values& values, Of of) {
    return of != Of::element_node && std::find(held.begin(), held.end(), &values) != held.end();
  };
  return holds;
}

Holds plc_holds(const Document& document, bool smesh) {
  const TetgenPlan plan = tetgen_plc_plan(document);
  Holds holds = holds_of(document, plan);
  holds.facets = plan.facets_as_said && !smesh;
  holds.holes = holds.regions = holds.boundary = true;
  holds.makes_boundary = !says_boundary(document);
  const bool said = says_boundary(document);
  holds.nodes_each = [said](const ElementBlock& block) {
    const PlcPart part = part_of(block, said);
    const ElementType* type = element_type(block.type);
    return part == PlcPart::none ? 0 : type ? type->corners : block.nodes_each;
  };
  holds.kind = [said](const ElementBlock& block) { return part_of(block, said) == PlcPart::edges ? 1 : 0; };
  return holds;
}

}  // namespace

Holds tetgen_holds(const Document& document) {
  const TetgenPlan plan = tetgen_mesh_plan(document);
  Holds holds = holds_of(document, plan);
  holds.voronoi = plan.voronoi;
  const int tets = plan.tets.nodes_each, faces = plan.faces.nodes_each, edges = plan.edges.nodes_each;
  holds.nodes_each = [=](const ElementBlock& block) {
    if (block.of_boundary) return 0;
    return has_shape(block, Shape::tetrahedron) ? tets
           : has_shape(block, Shape::triangle)  ? faces
           : has_shape(block, Shape::line)      ? edges
                                                : 0;
  };
  holds.kind = [](const ElementBlock& block) {
    return has_shape(block, Shape::tetrahedron) ? 0 : has_shape(block, Shape::triangle) ? 1 : 2;
  };
  return holds;
}

Holds poly_holds(const Document& document) {
  return plc_holds(document, false);
}
Holds smesh_holds(const Document& document) {
  return plc_holds(document, true);
}

}  // namespace tetproof::io
