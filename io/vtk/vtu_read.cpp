// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the grids of VTK's XML files, piece by piece.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_group_names.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_polyhedron.hpp"
#include "io/vtk/vtk_tags.hpp"
#include "io/vtk/vtu.hpp"
#include "io/vtk/vtu_file.hpp"
#include "io/vtk/vtu_lattice.hpp"
#include "io/vtk/vtu_parts.hpp"
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
  explicit Reader(const InputFile& file) : file_(file), size_(file.bytes().size()), parts_(file_, document_) {
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
    VtkPieces all(document_);
    if (kind_ != Grid::unstructured && kind_ != Grid::polygonal) {
      const VtuLattice kind = kind_ == Grid::image         ? VtuLattice::image
                              : kind_ == Grid::rectilinear ? VtuLattice::rectilinear
                                                           : VtuLattice::structured;
      all.add(read_vtu_lattice(file_, grid, kind, size_, document_, filled), true);
    } else {
      std::optional<VtkTagNames> tags;
      if (pieces > 1) tags = tag_names(grid);
      for (const pugi::xml_node one : grid.children("Piece")) {
        const std::size_t before = document_.points.size();
        VtkPiece piece;
        piece.tags = tags;
        if (pieces > 1) piece.which = fmt::format(" of piece {}", number++);
        read(one, piece);
        all.add(std::move(piece), pieces == 1);
        filled += document_.points.size() != before;
      }
    }
    if (filled > 1) add_loss(document_.dropped, "division into pieces", 1, fmt::format("{} pieces", filled));
  }

  // Reads the arrays of all pieces that may be tags, which they are in all or in none.
  VtkTagNames tag_names(const pugi::xml_node& grid) const {
    std::vector<std::vector<Column>> arrays;
    std::vector<Loss> again;  // listed when the piece is read
    for (const pugi::xml_node one : grid.children("Piece")) {
      std::vector<Column>& of_piece = arrays.emplace_back();
      each_array(one, "CellData", [&](const pugi::xml_node& array) {
        if (may_be_vtk_tag_name(array.attribute("Name").value()))
          of_piece.push_back(file_.column(array, std::nullopt, again));
      });
    }
    return vtk_tag_names(arrays);
  }

  void read(const pugi::xml_node& node, VtkPiece& piece) {
    const std::size_t points = file_.count(node, "NumberOfPoints");
    parts_.points(node, points, piece);
    kind_ == Grid::unstructured ? cells(node, piece) : polygons(node, piece);
    parts_.data(node, points, piece.types.size(), piece);
  }

  void cells(const pugi::xml_node& node, VtkPiece& piece) {
    const std::size_t cells = file_.count(node, "NumberOfCells");
    const pugi::xml_node of_cells = node.child("Cells");
    piece.connectivity = parts_.integers(of_cells, "connectivity", std::nullopt);
    piece.ends = parts_.integers(of_cells, "offsets", cells);
    piece.types = parts_.integers(of_cells, "types", cells);
    if (piece.types.size() != cells)
      file_.fail(node, fmt::format("expected the types of {}", counted(cells, "cells")));
    if (piece.ends.size() != cells)
      file_.fail(node, fmt::format("expected the offsets of {}", counted(cells, "cells")));
    faces(of_cells, cells, piece);
  }

  // Polyhedra: since VTK 9.4 by four arrays, before by two.
  void faces(const pugi::xml_node& of_cells, std::size_t cells, VtkPiece& piece) {
    const VtkFaces faces{parts_.integers(of_cells, "face_connectivity", std::nullopt),
                         parts_.integers(of_cells, "face_offsets", std::nullopt),
                         parts_.integers(of_cells, "polyhedron_to_faces", std::nullopt),
                         parts_.integers(of_cells, "polyhedron_offsets", std::nullopt)};
    piece.faces = parts_.integers(of_cells, "faces", std::nullopt);
    piece.face_ends = parts_.integers(of_cells, "faceoffsets", std::nullopt);
    std::size_t found = piece.face_ends.size();
    const char* other = "faceoffsets";
    if (!faces.empty()) {
      parts_.lose("\"faces\" of cells that have \"face_connectivity\"", piece.faces.size(), of_cells);
      piece.faces.clear(), piece.face_ends.clear();
      const std::string wrong = faces.lists(piece.faces, piece.face_ends);
      if (!wrong.empty()) file_.fail(of_cells, wrong + piece.which);
      found = faces.ends.size();
      other = "polyhedron_offsets";
    }
    if (found == 0 && !piece.faces.empty())
      parts_.lose("faces of cells without \"faceoffsets\"", piece.faces.size(), of_cells);
    if ((found != 0 || !faces.empty()) && found != cells)
      file_.fail(of_cells,
                 fmt::format("expected {} of \"{}\", found {}", counted(cells, "values"), other, found));
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
      const pugi::xml_node of_list = node.child(list.element);
      if (cells == 0) {
        if (!node.attribute(list.count))
          parts_.lose(fmt::format("cells of <{}> without {}", list.element, list.count),
                      parts_.integers(of_list, "offsets", std::nullopt).size(), of_list, true);
        continue;
      }
      const std::vector<std::int64_t> connectivity = parts_.integers(of_list, "connectivity", std::nullopt),
                                      ends = parts_.integers(of_list, "offsets", cells);
      if (ends.size() != cells)
        file_.fail(node,
                   fmt::format("expected the offsets of {} in <{}>", counted(cells, "cells"), list.element));
      for (const std::int64_t end : ends)
        if (end < 0 || end > static_cast<std::int64_t>(connectivity.size()))
          file_.fail(of_list,
                     fmt::format("expected an offset from 0 to {}, found {}", connectivity.size(), end));
      parts_.lose("numbers of points behind those of the last cell",
                  connectivity.size() - static_cast<std::size_t>(ends.back()), of_list);
      const auto start = static_cast<std::int64_t>(piece.connectivity.size());
      piece.connectivity.insert(piece.connectivity.end(), connectivity.begin(),
                                connectivity.begin() + ends.back());
      for (const std::int64_t end : ends) piece.ends.push_back(start + end);
      piece.types.insert(piece.types.end(), cells, list.type);
    }
  }

  VtuFile file_;
  const std::size_t size_;  // of the file
  Grid kind_ = Grid::unstructured;
  Document document_;
  VtuParts parts_;
};

}  // namespace

Document read_vtu(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
