// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the grids of VTK's XML files, piece by piece.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_group_names.hpp"
#include "io/vtk/vtk_lattice.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"
#include "io/vtk/vtu.hpp"
#include "io/vtk/vtu_file.hpp"
#include "io/vtk/vtu_unread.hpp"

namespace tetproof::io {
namespace {

enum class Grid { unstructured, polygonal, image, rectilinear, structured };
constexpr std::pair<std::string_view, Grid> grids[] = {{"UnstructuredGrid", Grid::unstructured},
                                                       {"PolyData", Grid::polygonal},
                                                       {"ImageData", Grid::image},
                                                       {"RectilinearGrid", Grid::rectilinear},
                                                       {"StructuredGrid", Grid::structured}};

class Reader {
 public:
  explicit Reader(const InputFile& file) : file_(file), size_(file.bytes().size()) {
    document_.path = file.path();
    document_.format = "vtu";
    document_.first_node = document_.first_element = 0;
  }

  Document read() {
    const pugi::xml_node root = file_.root();
    const std::string type = root.attribute("type").value();
    const auto* known = std::find_if(std::begin(grids), std::end(grids),
                                     [&](const auto& grid) { return grid.first == type; });
    if (known == std::end(grids))
      file_.fail(root, fmt::format("expected VTK's type UnstructuredGrid, PolyData, ImageData, "
                                   "RectilinearGrid or StructuredGrid, found '{}'",
                                   type));
    kind_ = known->second;
    const pugi::xml_node grid = root.child(type.c_str());
    if (!grid) file_.fail(root, fmt::format("expected <{}>", type));
    each_array(grid, "FieldData", [&](const pugi::xml_node& array) {
      add_vtk_field(document_, file_.column(array, std::nullopt, document_.dropped));
    });
    pieces(grid);
    list_unread(
        root, [&](const pugi::xml_node& node) { return file_.line_of(node); }, document_.dropped);
    take_group_names(document_);
    return std::move(document_);
  }

 private:
  // The division into pieces is not kept. Empty pieces divide nothing.
  void pieces(const pugi::xml_node& grid) {
    std::size_t pieces = 0, filled = 0, number = 0;
    for ([[maybe_unused]] const pugi::xml_node one : grid.children("Piece")) ++pieces;
    if (pieces == 0) file_.fail(grid, "expected <Piece>");
    for (const pugi::xml_node one : grid.children("Piece")) {
      const std::size_t before = document_.points.size();
      piece(grid, one, pieces == 1 ? "" : fmt::format(" of piece {}", number++));
      filled += document_.points.size() != before;
    }
    if (filled > 1) add_loss(document_.dropped, "division into pieces", 1, fmt::format("{} pieces", filled));
  }

  void piece(const pugi::xml_node& grid, const pugi::xml_node& node, std::string which) {
    VtkPiece piece;
    piece.which = std::move(which);
    if (kind_ == Grid::unstructured || kind_ == Grid::polygonal) {
      const std::size_t points = file_.count(node, "NumberOfPoints");
      this->points(node, points, piece);
      kind_ == Grid::unstructured ? cells(node, piece) : polygons(node, piece);
      data(node, points, piece.types.size(), piece);
    } else {
      lattice(grid, node, piece);
    }
    const bool whole = piece.which.empty();
    add_vtk_piece(document_, std::move(piece), whole);
  }

  void data(const pugi::xml_node& node, std::size_t points, std::size_t cells, VtkPiece& piece) {
    data(node, "PointData", points, piece.point_data, piece.point_roles);
    data(node, "CellData", cells, piece.cell_data, piece.cell_roles);
  }

  void data(const pugi::xml_node& node, const char* name, std::size_t items, std::vector<Column>& to,
            std::vector<VtkRole>& roles) {
    each_array(node, name, [&](const pugi::xml_node& array) {
      to.push_back(file_.column(array, items, document_.dropped));
    });
    for (const pugi::xml_node of : node.children(name))
      for (const pugi::xml_attribute attribute : of.attributes())
        if (is_vtk_role(attribute.name()) && *attribute.value() != '\0')
          roles.push_back({attribute.value(), attribute.name()});
  }

  void points(const pugi::xml_node& node, std::size_t points, VtkPiece& piece) {
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

  std::vector<std::int64_t> integers(const pugi::xml_node& parent, const char* name,
                                     std::optional<std::size_t> items) {
    const pugi::xml_node array = parent.find_child_by_attribute("Name", name);
    return array ? file_.integers(array, items, document_.dropped) : std::vector<std::int64_t>{};
  }

  void cells(const pugi::xml_node& node, VtkPiece& piece) {
    const std::size_t cells = file_.count(node, "NumberOfCells");
    const pugi::xml_node of_cells = node.child("Cells");
    piece.connectivity = integers(of_cells, "connectivity", std::nullopt);
    piece.ends = integers(of_cells, "offsets", cells);
    piece.types = integers(of_cells, "types", cells);
    if (piece.types.size() != cells)
      file_.fail(node, fmt::format("expected the types of {}", counted(cells, "cells")));
    if (piece.ends.size() != cells)
      file_.fail(node, fmt::format("expected the offsets of {}", counted(cells, "cells")));
    piece.faces = integers(of_cells, "faces", std::nullopt);
    piece.face_ends = integers(of_cells, "faceoffsets", std::nullopt);
    if (piece.face_ends.empty() && !piece.faces.empty())
      add_loss(document_.dropped, "faces of cells without \"faceoffsets\"", piece.faces.size(),
               fmt::format("line {}", file_.line_of(of_cells)));
    if (!piece.face_ends.empty() && piece.face_ends.size() != cells)
      file_.fail(of_cells, fmt::format("expected the offsets of faces of {}, found {}",
                                       counted(cells, "cells"), piece.face_ends.size()));
  }

  // The cells of the four lists come in this order, and so do their data.
  void polygons(const pugi::xml_node& node, VtkPiece& piece) {
    struct List {
      const char *element, *count;
      VtkCellType type;
    };
    constexpr List lists[] = {{"Verts", "NumberOfVerts", vtk_poly_vertex},
                              {"Lines", "NumberOfLines", vtk_poly_line},
                              {"Polys", "NumberOfPolys", vtk_polygon},
                              {"Strips", "NumberOfStrips", vtk_strip}};
    for (const List& list : lists) {
      const std::size_t cells = file_.count(node, list.count, "0");
      if (cells == 0) continue;
      const pugi::xml_node of_list = node.child(list.element);
      const std::vector<std::int64_t> connectivity = integers(of_list, "connectivity", std::nullopt),
                                      ends = integers(of_list, "offsets", cells);
      if (ends.size() != cells)
        file_.fail(node,
                   fmt::format("expected the offsets of {} in <{}>", counted(cells, "cells"), list.element));
      if (ends.back() != static_cast<std::int64_t>(connectivity.size()))
        file_.fail(of_list,
                   fmt::format("expected {} as the last offset, found {}", connectivity.size(), ends.back()));
      const auto start = static_cast<std::int64_t>(piece.connectivity.size());
      piece.connectivity.insert(piece.connectivity.end(), connectivity.begin(), connectivity.end());
      for (const std::int64_t end : ends) {
        if (end < 0 || end > static_cast<std::int64_t>(connectivity.size()))
          file_.fail(of_list,
                     fmt::format("expected an offset from 0 to {}, found {}", connectivity.size(), end));
        piece.ends.push_back(start + end);
      }
      piece.types.insert(piece.types.end(), cells, list.type);
    }
  }

  // A structured piece: from which to which index it goes, and its points.
  void lattice(const pugi::xml_node& grid, const pugi::xml_node& node, VtkPiece& piece) {
    std::array<std::int64_t, 6> extent{0, -1, 0, -1, 0, -1};
    file_.integers_in(grid, "WholeExtent", extent);
    file_.integers_in(node, "Extent", extent);
    constexpr std::int64_t most_index = std::numeric_limits<std::int32_t>::max();
    VtkImage image;
    VtkDimensions dimensions;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t first = extent[2 * k], last = extent[2 * k + 1];
      if (first < -most_index || last > most_index || last < first - 1)
        file_.fail(node, fmt::format("expected an Extent, found {} to {}", first, last));
      image.first[k] = first;
      dimensions[k] = last - first + 1;
    }
    const std::int64_t count = lattice_points(dimensions, std::numeric_limits<Index>::max());
    if (count >= 0)  // the data come first: they show that there can be so many points
      data(node, static_cast<std::size_t>(count), static_cast<std::size_t>(lattice_cells(dimensions)), piece);
    const bool has_data = !piece.point_data.empty() || !piece.cell_data.empty();
    if (count < 0 || (!has_data && static_cast<std::int64_t>(document_.points.size()) + count >
                                       most_lattice_points(size_)))
      file_.fail(node, fmt::format("{} points are more than a file of {} can have data for",
                                   fmt::join(dimensions, " x "), counted(size_, "bytes")));
    if (kind_ == Grid::structured) {
      points(node, static_cast<std::size_t>(count), piece);
    } else if (kind_ == Grid::image) {
      file_.reals_in(grid, "Origin", image.origin);
      file_.reals_in(grid, "Spacing", image.spacing);
      file_.reals_in(grid, "Direction", image.direction);
      add_image_points(dimensions, image, piece);
    } else {
      add_lattice_points(axes(node, dimensions), piece);
    }
    add_lattice_cells(dimensions, piece);
    document_.warnings.push_back(fmt::format("{}: {}{}", document_.path,
                                             lattice_in_words("a structured grid", dimensions), piece.which));
  }

  // The coordinates along the three axes. A piece may have those of the whole grid.
  std::array<std::vector<double>, 3> axes(const pugi::xml_node& node, const VtkDimensions& dimensions) {
    std::array<std::vector<double>, 3> found;
    std::size_t k = 0;
    each_array(node, "Coordinates", [&](const pugi::xml_node& array) {
      if (k == 3) file_.fail(array, "expected three arrays of coordinates, found a fourth");
      const auto items = static_cast<std::size_t>(dimensions[k]);
      const Column column = file_.column(array, items, document_.dropped);
      if (!column.texts.empty() || column.components != 1) file_.fail(array, "expected coordinates");
      for (std::size_t i = 0; i < items; ++i) found[k].push_back(number_at<double>(column, i));
      ++k;
    });
    if (k != 3) file_.fail(node, fmt::format("expected three arrays of <Coordinates>, found {}", k));
    return found;
  }

  VtuFile file_;
  const std::size_t size_;  // of the file
  Grid kind_ = Grid::unstructured;
  Document document_;
};

}  // namespace

Document read_vtu(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
