// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sections of VTK's legacy files: points, cells, and their data.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_information.hpp"
#include "io/vtk/vtk_legacy.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  explicit Reader(const InputFile& file) : in_(file) {
    document_.path = file.path();
    document_.format = "vtk";
    document_.first_node = document_.first_element = 0;
  }

  Document read() {
    header();
    while (!in_.at_end()) section(in_.word());
    list_roles();
    if (!has_points_ && (!piece_.ends.empty() || !lists_.empty())) in_.fail("POINTS", {});
    polygons();
    if (types_.empty() && !piece_.ends.empty() && lists_.empty()) in_.fail("CELL_TYPES", {});
    piece_.types.insert(piece_.types.end(), types_.begin(), types_.end());
    check_data(piece_.cell_data, piece_.types.size(), "cells");
    check_data(piece_.point_data, piece_.points.size(), "points");
    add_vtk_piece(document_, std::move(piece_), true);
    return std::move(document_);
  }

 private:
  void header() {
    const std::string_view first = in_.rest_of_line();
    if (!lower_case(first).starts_with("# vtk datafile version")) in_.fail("# vtk DataFile Version", first);
    in_.next_line();
    document_.title = in_.rest_of_line();
    in_.next_line();
    const std::string_view kind = in_.word();
    const std::string name = lower_case(kind);
    if (name != "ascii" && name != "binary") in_.fail("ASCII or BINARY", kind);
    if (name == "binary") in_.set_binary();
  }

  void section(std::string_view word) {
    const std::string name = lower_case(word);
    if (name == "dataset") return dataset();
    if (name == "field") return field();
    if (name == "metadata") return read_vtk_metadata(in_, last_array_, document_.dropped);
    if (name == "point_data" || name == "cell_data") {
      items_ = in_.integer("a number of items");
      if (items_ < 0) in_.fail_in_line(fmt::format("expected a number of items, found {}", items_));
      list_roles();
      data_ = name == "point_data" ? &piece_.point_data : &piece_.cell_data;
      return;
    }
    if (!has_dataset_) in_.fail("DATASET or FIELD", word);
    if (name == "points") return points();
    if (name == "cells") return in_.cells(piece_.connectivity, piece_.ends);
    if (name == "cell_types") return cell_types();
    if (name == "vertices" || name == "lines" || name == "polygons" || name == "triangle_strips") {
      List list{.type = name == "vertices"   ? vtk_poly_vertex
                        : name == "lines"    ? vtk_poly_line
                        : name == "polygons" ? vtk_polygon
                                             : vtk_strip};
      in_.cells(list.connectivity, list.ends);
      lists_.push_back(std::move(list));
      return;
    }
    if (!data_) in_.fail("POINTS, CELLS, CELL_TYPES, POINT_DATA or CELL_DATA", word);
    attribute(name, word);
  }

  void dataset() {
    if (has_dataset_) in_.fail_in_line("a second DATASET");
    const std::string_view word = in_.word();
    const std::string kind = lower_case(word);
    if (kind != "unstructured_grid" && kind != "polydata") in_.fail("UNSTRUCTURED_GRID or POLYDATA", word);
    has_dataset_ = true;
  }

  void points() {
    if (has_points_) in_.fail_in_line("a second POINTS");
    const std::int64_t count = in_.count("the number of points", in_.binary() ? 3 : 6);
    if (count > std::numeric_limits<Index>::max())
      in_.fail_in_line(fmt::format("{} points are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    Column coordinates{.type = in_.type()};
    if (coordinates.type == "String" || coordinates.type == "bit") in_.fail_in_line("points are numbers");
    in_.numbers(coordinates, 3 * static_cast<std::size_t>(count));
    has_points_ = true;
    last_array_ = "POINTS";
    piece_.points.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < 3 * piece_.points.size(); ++i)
      piece_.points[i / 3][static_cast<Eigen::Index>(i % 3)] = number_at<double>(coordinates, i);
  }

  void cell_types() {
    if (!types_.empty()) in_.fail_in_line("a second CELL_TYPES");
    const std::int64_t count = in_.count("the number of cell types", 1);
    Column types{.type = "Int32"};
    in_.integers(types, static_cast<std::size_t>(count));
    types_ = std::move(types.integers);
    if (types_.size() != piece_.ends.size())
      in_.fail_in_line(fmt::format("expected the types of {}, found {}", counted(piece_.ends.size(), "cells"),
                                   types_.size()));
  }

  // Appends vertices, lines, polygons and strips: the cell data come in this order.
  void polygons() {
    for (const VtkCellType type : {vtk_poly_vertex, vtk_poly_line, vtk_polygon, vtk_strip})
      for (const List& list : lists_) {
        if (list.type != type) continue;
        const auto start = static_cast<std::int64_t>(piece_.connectivity.size());
        piece_.connectivity.insert(piece_.connectivity.end(), list.connectivity.begin(),
                                   list.connectivity.end());
        for (const std::int64_t end : list.ends) piece_.ends.push_back(start + end);
        piece_.types.insert(piece_.types.end(), list.ends.size(), type);
      }
  }

  void attribute(const std::string& name, std::string_view word) {
    if (name == "lookup_table") return lookup_table();
    struct Kind {
      std::string_view name;
      int components;  // 0: a number in the line says it
    };
    static constexpr Kind kinds[] = {{"scalars", 1},      {"vectors", 3},      {"normals", 3},
                                     {"tensors", 9},      {"tensors6", 6},     {"texture_coordinates", 0},
                                     {"global_ids", 1},   {"pedigree_ids", 1}, {"edge_flags", 1},
                                     {"color_scalars", 0}};
    const auto kind =
        std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.name == name; });
    if (kind == std::end(kinds)) in_.fail("an attribute of points or cells", word);
    Column column{.name = vtk_decoded(in_.word())};
    column.components = kind->components;
    if (name == "color_scalars") {
      add_role(column.name, word);
      return colors(column);
    }
    if (kind->components == 0) column.components = in_.components();
    column.type = in_.type();
    if (name == "scalars") {
      if (!in_.at_line_end()) column.components = in_.components();
      if (in_.next_word() == "lookup_table") {
        in_.word();
        table_of(column.name, in_.word());
      }
    }
    in_.numbers(column, size_of_data(column));
    add_role(column.name, word);
    take(std::move(column));
  }

  // Arrays of entities and groups become what they say, and have no use for a role.
  void add_role(const std::string& array, std::string_view word) {
    if (data_ == &piece_.cell_data && is_array_of_tags(array)) return;
    roles_.push_back({array, std::string(word)});
  }

  // Lists the roles of the arrays of POINT_DATA or CELL_DATA, behind their last array. SCALARS, VECTORS and
  // TENSORS are also just how an array of 1, 3 or 9 numbers each is written. They are a choice only beside a
  // FIELD, whose arrays have no role; and VTK then chooses the first of a kind.
  void list_roles() {
    std::set<std::string> chosen;
    for (const Role& role : roles_) {
      const std::string word = lower_case(role.word);
      const bool is_form = word == "scalars" || word == "vectors" || word == "tensors" || word == "tensors6";
      if (!is_form || (has_field_ && chosen.insert(word).second))
        add_vtk_role(document_.dropped, role.array, role.word);
    }
    roles_.clear();
    has_field_ = false;
  }

  void table_of(const std::string& array, std::string_view table) {
    if (lower_case(table) != "default")
      add_loss(document_.dropped, "lookup tables of values", 1,
               fmt::format("\"{}\" of \"{}\"", vtk_decoded(table), array));
  }

  void take(Column&& column) {
    last_array_ = column.name;
    data_->push_back(std::move(column));
  }

  void colors(Column& column) {
    column.components = in_.components();
    column.type = "UInt8";
    add_rounded(column.name, in_.colors(column, size_of_data(column)));
    take(std::move(column));
  }

  void add_rounded(const std::string& array, std::size_t colors) {
    add_loss(document_.dropped, "colours, rounded to bytes", colors, fmt::format("\"{}\"", array));
  }

  // The number of values that the points or cells have in a column. The rest of the file can hold them.
  std::size_t size_of_data(const Column& column) const {
    const auto each = static_cast<std::size_t>(column.components), items = static_cast<std::size_t>(items_);
    in_.check_room(items, each);
    return items * each;
  }

  void lookup_table() {
    Column column{.name = vtk_decoded(in_.word()), .type = "UInt8", .components = 4};
    const std::int64_t size = in_.count("the size of a lookup table", 4);
    add_rounded(column.name, in_.colors(column, 4 * static_cast<std::size_t>(size)));
    last_array_ = column.name;
    add_vtk_field(document_, std::move(column));
  }

  void field() {
    const std::string name = vtk_decoded(in_.word());  // "FieldData" is what VTK writes
    if (lower_case(name) != "fielddata")
      add_loss(document_.dropped, "names of fields", 1, fmt::format("\"{}\"", name));
    const std::int64_t arrays = in_.count("the number of arrays", 4);
    has_field_ = has_field_ || (data_ && arrays > 0);
    for (std::int64_t a = 0; a < arrays; ++a) {
      std::string_view word = in_.word();
      while (lower_case(word) == "metadata") {
        read_vtk_metadata(in_, last_array_, document_.dropped);
        word = in_.word();
      }
      if (word.empty()) in_.fail("the name of an array", word);
      if (word == "NULL_ARRAY") continue;
      Column column{.name = vtk_decoded(word)};
      const std::int64_t each = in_.integer("the number of components"),
                         items = in_.integer("the number of tuples");
      if (each < 0 || items < 0 || each > std::numeric_limits<std::int32_t>::max())
        in_.fail_in_line(
            fmt::format("expected numbers of components and tuples, found {} and {}", each, items));
      column.components = std::max(1, static_cast<int>(each));
      column.type = in_.type();
      in_.check_room(static_cast<std::size_t>(items), static_cast<std::size_t>(each));
      in_.numbers(column, static_cast<std::size_t>(each * items));
      last_array_ = column.name;
      if (!data_)
        add_vtk_field(document_, std::move(column));
      else if (items == items_)
        take(std::move(column));
      else
        in_.fail_in_line(fmt::format("array \"{}\": expected {}, found {}", column.name,
                                     counted(items_, "tuples"), items));
    }
  }

  void check_data(const std::vector<Column>& data, std::size_t items, const char* what) const {
    for (const Column& column : data)
      if (column_size(column) != items * static_cast<std::size_t>(column.components))
        in_.fail_in_line(fmt::format("array \"{}\": expected values of {} {}, found {}", column.name, items,
                                     what,
                                     column_size(column) / static_cast<std::size_t>(column.components)));
  }

  struct Role {
    std::string array, word;
  };
  struct List {
    VtkCellType type;
    std::vector<std::int64_t> connectivity{}, ends{};
  };

  VtkLegacyScanner in_;
  Document document_;
  VtkPiece piece_;
  bool has_dataset_ = false, has_points_ = false;
  std::vector<std::int64_t> types_;
  std::vector<List> lists_;
  std::vector<Column>* data_ = nullptr;
  std::int64_t items_ = 0;
  std::string last_array_;   // METADATA are about this one
  std::vector<Role> roles_;  // of the arrays of these data
  bool has_field_ = false;   // whether these data have arrays in a FIELD
};

}  // namespace

Document read_vtk(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
