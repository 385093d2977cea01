// SPDX-License-Identifier: GPL-3.0-or-later
// Reads what pieces of all kinds of grids have in VTK's XML files: points, arrays, and lists of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtu_file.hpp"

namespace tetproof::io {

class VtuParts {
 public:
  VtuParts(const VtuFile& file, Document& document) : file_(file), document_(document) {}

  /// The arrays of points and cells, and their roles.
  void data(const pugi::xml_node& node, std::size_t points, std::size_t cells, VtkPiece& piece);
  /// The coordinates of so many points.
  void points(const pugi::xml_node& node, std::size_t points, VtkPiece& piece);
  /// The integers of the array with this name; none if there is no such array.
  std::vector<std::int64_t> integers(const pugi::xml_node& parent, const char* name,
                                     std::optional<std::size_t> items);
  /// Adds what is dropped, with the line of the first of its kind: finding a line takes long in a large file.
  void lose(const std::string& item, std::size_t count, const pugi::xml_node& node, bool elements = false);

 private:
  void data(const pugi::xml_node& node, const char* name, std::size_t items, std::vector<Column>& to,
            std::vector<VtkRole>& roles);

  const VtuFile& file_;
  Document& document_;
};

}  // namespace tetproof::io
