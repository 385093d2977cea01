// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/c/document_view.hpp"

#include <algorithm>

#include "io/model/element_types.hpp"

namespace tetproof::c {

template <std::size_t Corners>
void DocumentView::Elements<Corners>::add(const Document& document, const ElementBlock& block) {
  const auto& of_block = document.tag_sets[static_cast<std::size_t>(block.groups)];
  groups.insert(groups.end(), block.count, of_block.empty() ? 0 : of_block[0]);
  entities.insert(entities.end(), block.count, block.entity);
  const Index* nodes = document.connectivity.data() + block.nodes;
  for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each) {
    std::copy_n(nodes, Corners, corners.emplace_back().begin());
    numbers.push_back(document.element_tag(block.first + e));
  }
}

DocumentView::DocumentView(const Document& document) {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  point_numbers_.reserve(document.points.size());
  for (std::size_t i = 0; i < document.points.size(); ++i) point_numbers_.push_back(document.node_tag(i));
  for (const ElementBlock& block : document.blocks) {
    const io::ElementType* type = io::element_type(block.type);
    if (type && type->shape == io::Shape::tetrahedron) tets_.add(document, block);
    if (type && type->shape == io::Shape::triangle) triangles_.add(document, block);
  }
  for (const GroupName& named : document.group_names)
    group_list_.push_back(&groups_.emplace_back(
        tetproof_group{.dimension = named.dim, .tag = named.group, .name = named.name.c_str()}));

  const auto count = [](const auto& items) { return static_cast<std::int64_t>(items.size()); };
  arrays_.format = document.format.c_str();
  arrays_.element_count = static_cast<std::int64_t>(document.elements());
  arrays_.point_count = count(document.points);
  arrays_.points = document.points.empty() ? nullptr : document.points[0].data();
  arrays_.point_numbers = point_numbers_.data();
  arrays_.tet_count = count(tets_.corners);
  arrays_.tets = tets_.corners.empty() ? nullptr : tets_.corners[0].data();
  arrays_.tet_numbers = tets_.numbers.data();
  arrays_.tet_groups = tets_.groups.data();
  arrays_.tet_entities = tets_.entities.data();
  arrays_.triangle_count = count(triangles_.corners);
  arrays_.triangles = triangles_.corners.empty() ? nullptr : triangles_.corners[0].data();
  arrays_.triangle_numbers = triangles_.numbers.data();
  arrays_.triangle_groups = triangles_.groups.data();
  arrays_.triangle_entities = triangles_.entities.data();
  arrays_.unknown_count = count(document.unknown);
  arrays_.unknown = document.unknown.data();
  arrays_.group_count = count(group_list_);
  arrays_.groups = group_list_.data();
}

}  // namespace tetproof::c
