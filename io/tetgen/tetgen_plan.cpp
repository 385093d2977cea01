// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tetgen/tetgen_plan.hpp"

#include <algorithm>
#include <limits>

#include "io/model/element_types.hpp"
#include "io/model/group_signs.hpp"
#include "io/tetgen/tetgen_node_order.hpp"
#include "io/tetgen/tetgen_plan_parts.hpp"

namespace tetproof::io {
namespace {

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

bool list_is_valid(const std::vector<Index>& items, std::size_t most) {
  for (std::size_t k = 0; k < items.size(); ++k)
    if (items[k] >= static_cast<std::int64_t>(most) || items[k] < (k + 1 == items.size() ? -1 : 0))
      return false;
  return true;
}

// Whether there is a Voronoi diagram, its files can store it, and our reader accepts it.
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

// A number that names no node must not come to name one.
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
  return groups.empty() ? 0 : unsigned_group(document, groups[0]);
}

std::int64_t TetgenTags::group_of(const Document& document, const ElementBlock& block,
                                  std::size_t element) const {
  const std::pair least{static_cast<Index>(element), std::numeric_limits<std::int64_t>::min()};
  const auto place = others.empty() ? others.end() : std::lower_bound(others.begin(), others.end(), least);
  return place != others.end() && place->first == least.first ? place->second : first_group(document, block);
}

TetgenPlan tetgen_mesh_plan(const Document& document) {
  TetgenPlan plan = plan_of_nodes(document);
  for (const ElementBlock& block : document.blocks) {
    if (block.of_boundary) continue;
    if (has_shape(block, Shape::tetrahedron)) add_block(plan.tets, block);
    if (has_shape(block, Shape::triangle)) add_block(plan.faces, block);
    if (has_shape(block, Shape::line)) add_block(plan.edges, block);
  }
  // TetGen expects faces and edges of second order if the tetrahedra are of second order, and only then.
  // Nodes between corners are not written where a reader would take them in another order.
  const std::vector<TetgenRun> tets = runs_of(document, plan.tets), faces = runs_of(document, plan.faces);
  plan.tets.nodes_each = all_of_type(plan.tets, tetrahedron10) && !are_turned(document, tets) ? 10 : 4;
  const bool second_order = plan.tets.nodes_each == 10;
  plan.faces.nodes_each = second_order && all_of_type(plan.faces, triangle6) &&
                                  !have_nodes_opposite_corners(document, faces, tets)
                              ? 6
                              : 3;
  plan.edges.nodes_each = second_order && all_of_type(plan.edges, line3) ? 3 : 2;
  plan.renumber_elements = !counts_up(document, plan.base, {&plan.tets, &plan.faces, &plan.edges});

  plan.tet_tags = tags_of(document, plan.tets, "attributes", true, 0);
  plan.volume_bounds = values_of(document, plan.tets, "volume bounds", true, 1);
  plan.neighbours = values_of(document, plan.tets, "neighbours", false, 4);
  plan.tet_faces = values_of(document, plan.tets, "faces", false, 4);
  plan.tet_edges = values_of(document, plan.tets, "edges", false, 6);
  plan.face_tags = tags_of(document, plan.faces, "markers", false, 1);
  plan.face_tets = values_of(document, plan.faces, "neighbours", false, 2);
  plan.face_edges = values_of(document, plan.faces, "edges", false, 3);
  plan_edge_values(document, plan);
  // After corners alone a reader would take these columns for nodes between the corners.
  if (second_order && plan.faces.nodes_each == 3) plan.face_tets = nullptr;
  if (second_order && plan.edges.nodes_each == 2) plan.edge_tets = nullptr;
  plan.voronoi = voronoi_is_valid(document, plan.base);
  return plan;
}

Holds tetgen_mesh_holds(const Document& document, const TetgenPlan& plan) {
  Holds holds = tetgen_holds_of_values(document, plan);
  holds.voronoi = plan.voronoi;
  const int tets = plan.tets.nodes_each, faces = plan.faces.nodes_each, edges = plan.edges.nodes_each;
  holds.nodes_each = [=](const ElementBlock& block) {
    if (block.of_boundary) return 0;
    return has_shape(block, Shape::tetrahedron) ? tets
           : has_shape(block, Shape::triangle)  ? faces
           : has_shape(block, Shape::line)      ? edges
                                                : 0;
  };
  holds.groups = Holds::Groups::first;
  holds.groups_of = [&document, tet_tags = plan.tet_tags, face_tags = plan.face_tags,
                     edge_tags = plan.edge_tags](const ElementBlock& block) {
    return groups_come_back(document, block,
                            has_shape(block, Shape::tetrahedron) ? tet_tags
                            : has_shape(block, Shape::triangle)  ? face_tags
                                                                 : edge_tags);
  };
  holds.kind = [](const ElementBlock& block) {
    return has_shape(block, Shape::tetrahedron) ? 0 : has_shape(block, Shape::triangle) ? 1 : 2;
  };
  return holds;
}

}  // namespace tetproof::io
