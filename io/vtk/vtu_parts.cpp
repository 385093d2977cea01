// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtu_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"
#include "io/vtk/vtu_unread.hpp"

namespace tetproof::io {

void VtuParts::data(const pugi::xml_node& node, std::size_t points, std::size_t cells, VtkPiece& piece) {
  data(node, "PointData", points, piece.point_data, piece.point_roles);
  data(node, "CellData", cells, piece.cell_data, piece.cell_roles);
}

void VtuParts::data(const pugi::xml_node& node, const char* name, std::size_t items, std::vector<Column>& to,
                    std::vector<VtkRole>& roles) {
  each_array(node, name, [&](const pugi::xml_node& array) {
    to.push_back(file_.column(array, items, document_.dropped));
  });
  for (const pugi::xml_node of : node.children(name))
    for (const pugi::xml_attribute attribute : of.attributes())
      if (is_vtk_role(attribute.name()) && *attribute.value() != '\0')
        roles.push_back({attribute.value(), attribute.name()});
}

void VtuParts::points(const pugi::xml_node& node, std::size_t points, VtkPiece& piece) {
  const pugi::xml_node place = node.child("Points").find_child(is_vtu_array);
  if (place) {
    Column coordinates = file_.column(place, points, document_.dropped);
    if (coordinates.components != 3)
      file_.fail(place, fmt::format("expected points of 3 coordinates, found {}", coordinates.components));
    if (coordinates.texts.empty()) {
      piece.points.resize(points);
      for (std::size_t i = 0; i < 3 * points; ++i)
        piece.points[i / 3][static_cast<Eigen::Index>(i % 3)] = number_at<double>(coordinates, i);
    }
  }
  if (piece.points.size() != points)
    file_.fail(node, fmt::format("expected the coordinates of {}", counted(points, "points")));
}

std::vector<std::int64_t> VtuParts::integers(const pugi::xml_node& parent, const char* name,
                                             std::optional<std::size_t> items) {
  const pugi::xml_node array = parent.find_child_by_attribute("Name", name);
  return array ? file_.integers(array, items, document_.dropped) : std::vector<std::int64_t>{};
}

void VtuParts::lose(const std::string& item, std::size_t count, const pugi::xml_node& node, bool elements) {
  if (count == 0) return;
  const bool listed = std::any_of(document_.dropped.begin(), document_.dropped.end(),
                                  [&](const Loss& loss) { return loss.item == item; });
  add_loss(document_.dropped, item, count, listed ? "" : fmt::format("line {}", file_.line_of(node)),
           elements);
}

}  // namespace tetproof::io
