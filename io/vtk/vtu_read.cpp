// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the XML of a .vtu file: its pieces, and the places where the numbers of their arrays stand.
#include <fmt/format.h>

#include <limits>
#include <pugixml.hpp>
#include <vector>

#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtu.hpp"
#include "io/vtk/vtu_data.hpp"
#include "io/vtk/vtu_skeleton.hpp"
#include "io/vtk/vtu_unread.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  explicit Reader(const InputFile& file)
      : file_(file), skeleton_(vtu_skeleton(file)), encoding_{.path = file.path(), .bytes = file.bytes()} {
    document_.path = file.path();
    document_.format = "vtu";
    document_.first_node = document_.first_element = 0;
  }

  Document read() {
    const pugi::xml_parse_result parsed =
        xml_.load_buffer_inplace(skeleton_.xml.data(), skeleton_.xml.size(),
                                 pugi::parse_minimal | pugi::parse_escapes, pugi::encoding_utf8);
    if (!parsed) fail_at(parsed.offset, fmt::format("expected XML: {}", parsed.description()));
    const pugi::xml_node root = xml_.child("VTKFile");
    if (!root) fail_at(0, "expected <VTKFile>");
    const std::string type = root.attribute("type").value();
    if (type != "UnstructuredGrid")
      fail(root, fmt::format("expected VTK's type UnstructuredGrid, found '{}'", type));
    header(root);
    const pugi::xml_node grid = root.child("UnstructuredGrid");
    if (!grid) fail(root, "expected <UnstructuredGrid>");
    each_array(grid, "FieldData",
               [&](const pugi::xml_node& array) { add_vtk_field(document_, column(array, std::nullopt)); });
    pieces(grid);
    list_unread(
        root,
        [&](const pugi::xml_node& node) {
          return Scanner(file_.path(), file_.bytes(), skeleton_.place(node.offset_debug())).line();
        },
        document_.dropped);
    return std::move(document_);
  }

 private:
  [[noreturn]] void fail_at(std::ptrdiff_t in_xml, std::string_view message) const {
    Scanner(file_.path(), file_.bytes(), std::min(skeleton_.place(in_xml), file_.bytes().size()))
        .fail_in_line(message);
  }
  [[noreturn]] void fail(const pugi::xml_node& node, std::string_view message) const {
    fail_at(node.offset_debug(), message);
  }

  // Arrays of all elements called `name`: a file may have several, if hardly ever.
  template <class Do>
  static void each_array(const pugi::xml_node& parent, const char* name, const Do& take) {
    for (const pugi::xml_node data : parent.children(name))
      for (const pugi::xml_node array : data.children())
        if (is_vtu_array(array)) take(array);
  }

  std::size_t count(const pugi::xml_node& node, const char* attribute) const {
    const char* text = node.attribute(attribute).value();
    std::int64_t value = 0;
    if (!parse_integer(text, value) || value < 0)
      fail(node, fmt::format("expected {}, found '{}'", attribute, text));
    if (value > std::numeric_limits<Index>::max())
      fail(node, fmt::format("{} of {} are more than the {} that can be numbered here", attribute, value,
                             std::numeric_limits<Index>::max()));
    return static_cast<std::size_t>(value);
  }

  void header(const pugi::xml_node& root) {
    const std::string order = root.attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian")
      fail(root, fmt::format("expected byte_order LittleEndian or BigEndian, found '{}'", order));
    encoding_.order = order == "BigEndian" ? std::endian::big : std::endian::little;
    const std::string header = root.attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64")
      fail(root, fmt::format("expected header_type UInt32 or UInt64, found '{}'", header));
    encoding_.header_size = header == "UInt64" ? 8 : 4;
    const std::string compressor = root.attribute("compressor").value();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail(root, fmt::format("data compressed by {}, expected vtkZLibDataCompressor or none", compressor));
    encoding_.compressed = !compressor.empty();
    if (skeleton_.appended == 0) return;
    const pugi::xml_node appended = root.child("AppendedData");
    const std::string encoding = appended.attribute("encoding").as_string("base64");
    if (encoding != "raw" && encoding != "base64")
      fail(appended, fmt::format("expected encoding raw or base64, found '{}'", encoding));
    appended_raw_ = encoding == "raw";
    const std::size_t end = file_.bytes().rfind("</AppendedData");
    appended_end_ = end == std::string_view::npos || end < skeleton_.appended ? file_.bytes().size() : end;
  }

  // The division into pieces is not kept. Empty pieces divide nothing.
  void pieces(const pugi::xml_node& grid) {
    std::size_t pieces = 0, filled = 0, number = 0;
    for ([[maybe_unused]] const pugi::xml_node one : grid.children("Piece")) ++pieces;
    if (pieces == 0) fail(grid, "expected <Piece>");
    for (const pugi::xml_node one : grid.children("Piece")) {
      const std::size_t before = document_.points.size();
      piece(one, pieces == 1 ? "" : fmt::format(" of piece {}", number++));
      filled += document_.points.size() != before;
    }
    if (filled > 1) add_loss(document_.dropped, "division into pieces", 1, fmt::format("{} pieces", filled));
  }

  void piece(const pugi::xml_node& node, std::string which) {
    const std::size_t points = count(node, "NumberOfPoints"), cells = count(node, "NumberOfCells");
    VtkPiece piece;
    piece.which = std::move(which);
    const pugi::xml_node place = node.child("Points").find_child(is_vtu_array);
    if (place) {
      Column coordinates = column(place, points);
      if (coordinates.components != 3)
        fail(place, fmt::format("expected points of 3 coordinates, found {}", coordinates.components));
      if (coordinates.texts.empty()) add_points(coordinates, points, piece);
    }
    if (piece.points.size() != points)
      fail(node, fmt::format("expected the coordinates of {}", counted(points, "points")));
    const pugi::xml_node of_cells = node.child("Cells");
    if (const auto array = of_cells.find_child_by_attribute("Name", "connectivity"))
      piece.connectivity = integers(array, std::nullopt);
    if (const auto array = of_cells.find_child_by_attribute("Name", "offsets"))
      piece.ends = integers(array, cells);
    if (const auto array = of_cells.find_child_by_attribute("Name", "types"))
      piece.types = integers(array, cells);
    if (piece.types.size() != cells)
      fail(node, fmt::format("expected the types of {}", counted(cells, "cells")));
    if (piece.ends.size() != cells)
      fail(node, fmt::format("expected the offsets of {}", counted(cells, "cells")));
    each_array(node, "PointData",
               [&](const pugi::xml_node& array) { piece.point_data.push_back(column(array, points)); });
    each_array(node, "CellData",
               [&](const pugi::xml_node& array) { piece.cell_data.push_back(column(array, cells)); });
    const bool whole = piece.which.empty();
    add_vtk_piece(document_, std::move(piece), whole);
  }

  static void add_points(const Column& coordinates, std::size_t points, VtkPiece& piece) {
    piece.points.resize(points);
    for (std::size_t i = 0; i < 3 * points; ++i)
      piece.points[i / 3][static_cast<Eigen::Index>(i % 3)] = number_at<double>(coordinates, i);
  }

  std::vector<std::int64_t> integers(const pugi::xml_node& node, std::optional<std::size_t> items) {
    Column values = column(node, items);
    if (!values.reals.empty() || !values.texts.empty()) fail(node, "expected integers");
    return std::move(values.integers);
  }

  Column column(const pugi::xml_node& node, std::optional<std::size_t> items) {
    Column column{.name = node.attribute("Name").value(), .type = node.attribute("type").value()};
    if (!is_vtk_type(column.type))
      fail(node, fmt::format("expected the type of an array, found '{}'", column.type));
    const char* components = node.attribute("NumberOfComponents").as_string("1");
    std::int64_t each = 0;
    // VTK wrote 0 for an array without values.
    if (!parse_integer(components, each) || each < 0 || each > std::numeric_limits<std::int32_t>::max())
      fail(node, fmt::format("expected NumberOfComponents, found '{}'", components));
    column.components = each == 0 ? 1 : static_cast<int>(each);
    std::optional<std::size_t> values;
    if (items) values = *items * static_cast<std::size_t>(column.components);
    const VtuPlace where = place(node);
    const std::size_t left = read_vtu_array(encoding_, where, values, column);
    if (!where.shared)
      add_loss(document_.dropped, "bytes behind the values of arrays", left,
               fmt::format("\"{}\"", column.name));
    if (column_size(column) % static_cast<std::size_t>(column.components) != 0)
      fail(node,
           fmt::format("expected a multiple of {} values, found {}", column.components, column_size(column)));
    return column;
  }

  VtuPlace place(const pugi::xml_node& node) const {
    const std::string format = node.attribute("format").as_string("ascii");
    if (format == "appended") {
      const char* text = node.attribute("offset").value();
      std::int64_t offset = 0;
      if (skeleton_.appended == 0) fail(node, "expected <AppendedData>");
      if (!parse_integer(text, offset) || offset < 0 ||
          static_cast<std::uint64_t>(offset) > appended_end_ - skeleton_.appended)
        fail(node, fmt::format("expected an offset into the {} of appended data, found '{}'",
                               counted(appended_end_ - skeleton_.appended, "bytes"), text));
      return {appended_raw_ ? VtuPlace::raw : VtuPlace::base64,
              skeleton_.appended + static_cast<std::size_t>(offset), appended_end_, true};
    }
    if (format != "ascii" && format != "binary")
      fail(node, fmt::format("expected format ascii, binary or appended, found '{}'", format));
    VtuPlace place{format == "ascii" ? VtuPlace::ascii : VtuPlace::base64, 0, 0};
    std::int64_t text = 0;
    if (*node.child_value() != '\0') {
      if (!parse_integer(node.child_value(), text) || text < 0 ||
          static_cast<std::size_t>(text) >= skeleton_.texts.size())
        fail(node, "expected an array's values in one piece");
      place.begin = skeleton_.texts[static_cast<std::size_t>(text)].begin;
      place.end = skeleton_.texts[static_cast<std::size_t>(text)].end;
    }
    return place;
  }

  const InputFile& file_;
  VtuSkeleton skeleton_;
  VtuEncoding encoding_;
  bool appended_raw_ = false;
  std::size_t appended_end_ = 0;
  pugi::xml_document xml_;
  Document document_;
};

}  // namespace

Document read_vtu(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
