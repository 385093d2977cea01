// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "io/byte_order.hpp"
#include "io/vtk.hpp"
#include "io/vtk_mesh.hpp"

namespace tetproof::io {
namespace {

// The names of .vtu files for those of legacy files. An id is of 32 bits in files.
std::string vtu_type(std::string_view legacy) {
  static constexpr std::pair<std::string_view, const char*> types[] = {{"bit", "bit"},
                                                                       {"char", "Int8"},
                                                                       {"signed_char", "Int8"},
                                                                       {"unsigned_char", "UInt8"},
                                                                       {"short", "Int16"},
                                                                       {"unsigned_short", "UInt16"},
                                                                       {"int", "Int32"},
                                                                       {"unsigned_int", "UInt32"},
                                                                       {"long", "Int64"},
                                                                       {"unsigned_long", "UInt64"},
                                                                       {"long_long", "Int64"},
                                                                       {"unsigned_long_long", "UInt64"},
                                                                       {"vtktypeint64", "Int64"},
                                                                       {"vtktypeuint64", "UInt64"},
                                                                       {"vtkidtype", "Int32"},
                                                                       {"float", "Float32"},
                                                                       {"double", "Float64"},
                                                                       {"string", "String"},
                                                                       {"utf8_string", "String"}};
  for (const auto& [name, type] : types)
    if (name == legacy) return type;
  return {};
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

// %20 is a blank.
std::string decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      plain += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
      i += 2;
    } else {
      plain += text[i];
    }
  return plain;
}

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
    if (!lower(first).starts_with("# vtk datafile version")) in_.fail("# vtk DataFile Version", first);
    in_.next_line();
    document_.title = in_.rest_of_line();
    in_.next_line();
    const std::string_view kind = in_.word();
    const std::string name = lower(kind);
    if (name != "ascii" && name != "binary") in_.fail("ASCII or BINARY", kind);
    binary_ = name == "binary";
  }

  void section(std::string_view word) {
    const std::string name = lower(word);
    if (name == "dataset") return dataset();
    if (name == "field") return field();
    if (name == "metadata") return metadata();
    if (name == "point_data" || name == "cell_data") {
      items_ = in_.integer("a number of items");
      if (items_ < 0) in_.fail_in_line(fmt::format("expected a number of items, found {}", items_));
      data_ = name == "point_data" ? &piece_.point_data : &piece_.cell_data;
      return;
    }
    if (!has_dataset_) in_.fail("DATASET or FIELD", word);
    if (name == "points") return points();
    if (name == "cells") return cells(piece_.connectivity, piece_.ends);
    if (name == "cell_types") return cell_types();
    if (name == "vertices" || name == "lines" || name == "polygons" || name == "triangle_strips") {
      List list{.type = name == "vertices" ? 2 : name == "lines" ? 4 : name == "polygons" ? 7 : 6};
      cells(list.connectivity, list.ends);
      lists_.push_back(std::move(list));
      return;
    }
    if (!data_) in_.fail("POINTS, CELLS, CELL_TYPES, POINT_DATA or CELL_DATA", word);
    attribute(name, word);
  }

  void dataset() {
    const std::string_view word = in_.word();
    const std::string kind = lower(word);
    if (kind != "unstructured_grid" && kind != "polydata") in_.fail("UNSTRUCTURED_GRID or POLYDATA", word);
    has_dataset_ = true;
  }

  void points() {
    const std::int64_t count = in_.count("the number of points", binary_ ? 3 : 6);
    if (count > std::numeric_limits<Index>::max())
      in_.fail_in_line(fmt::format("{} points are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    Column coordinates{.type = type()};
    if (coordinates.type == "String" || coordinates.type == "bit") in_.fail_in_line("points are numbers");
    numbers(coordinates, 3 * static_cast<std::size_t>(count));
    has_points_ = true;
    piece_.points.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < 3 * piece_.points.size(); ++i)
      piece_.points[i / 3][static_cast<Eigen::Index>(i % 3)] = number_at<double>(coordinates, i);
  }

  // Either lists of so many numbers each or, since version 5.1, offsets and connectivity.
  void cells(std::vector<std::int64_t>& connectivity, std::vector<std::int64_t>& ends) {
    if (!ends.empty()) in_.fail_in_line("a second list of cells");
    const std::int64_t count = in_.count("the number of cells", 1);
    const std::int64_t size = in_.count("the size of the list of cells", 1);
    if (next_word() == "offsets") {
      in_.word();
      Column offsets{.type = type()}, numbers_of_points{};
      integers(offsets, static_cast<std::size_t>(count));
      const std::string_view word = in_.word();
      if (lower(word) != "connectivity") in_.fail("CONNECTIVITY", word);
      numbers_of_points.type = type();
      integers(numbers_of_points, static_cast<std::size_t>(size));
      if (!offsets.integers.empty() && offsets.integers[0] != 0)
        in_.fail_in_line(fmt::format("expected 0 as the first offset, found {}", offsets.integers[0]));
      if (!offsets.integers.empty()) ends.assign(offsets.integers.begin() + 1, offsets.integers.end());
      connectivity = std::move(numbers_of_points.integers);
      return;
    }
    Column list{.type = "Int32"};
    integers(list, static_cast<std::size_t>(size));
    std::size_t at = 0;
    for (std::int64_t c = 0; c < count; ++c) {
      const std::int64_t left = size - static_cast<std::int64_t>(at) - 1;
      if (left < 0)
        in_.fail_in_line(fmt::format("expected {} cells, found {} in {} numbers", count, c, size));
      const std::int64_t n = list.integers[at];
      if (n < 0 || n > left)
        in_.fail_in_line(
            fmt::format("cell {}: expected its number of points, up to {}, found {}", c, left, n));
      const auto start = list.integers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      connectivity.insert(connectivity.end(), start, start + n);
      ends.push_back(static_cast<std::int64_t>(connectivity.size()));
      at += static_cast<std::size_t>(n) + 1;
    }
    if (at != list.integers.size())
      in_.fail_in_line(fmt::format("expected {} numbers for {} cells, found {}", at, count, size));
  }

  void cell_types() {
    const std::int64_t count = in_.count("the number of cell types", 1);
    Column types{.type = "Int32"};
    integers(types, static_cast<std::size_t>(count));
    types_ = std::move(types.integers);
    if (types_.size() != piece_.ends.size())
      in_.fail_in_line(
          fmt::format("expected the types of {} cells, found {}", piece_.ends.size(), types_.size()));
  }

  // Vertices, lines, polygons and strips, which is the order that cell data go by.
  void polygons() {
    for (const int type : {2, 4, 7, 6})
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
    Column column{.name = decoded(in_.word())};
    column.components = kind->components;
    if (name == "color_scalars") return colors(column);
    if (kind->components == 0) column.components = components();
    column.type = type();
    if (name == "scalars") {
      if (!in_.at_line_end()) column.components = components();
      if (next_word() == "lookup_table") {
        in_.word();
        in_.word();
      }
    }
    values(std::move(column));
  }

  int components() {
    const std::int64_t value = in_.integer("the number of components");
    if (value < 1 || value > 1 << 20)
      in_.fail_in_line(fmt::format("expected the number of components, found {}", value));
    return static_cast<int>(value);
  }

  void values(Column column) {
    const auto each = static_cast<std::size_t>(column.components);
    const auto items = static_cast<std::size_t>(items_);
    check_items(items, each);
    numbers(column, items * each);
    data_->push_back(std::move(column));
  }

  // So many values need bytes, or bits.
  void check_items(std::size_t items, std::size_t each) const {
    if (items > 0 && each > (8 * in_.remaining() + 8) / items)
      in_.fail_in_line(fmt::format("expected {} times {} values, more than the {} bytes left can hold", items,
                                   each, in_.remaining()));
  }

  // Reals from 0 to 1 in text, bytes in binary: bytes in either case to VTK.
  void colors(Column& column) {
    column.components = components();
    column.type = "UInt8";
    const auto size = static_cast<std::size_t>(column.components) * static_cast<std::size_t>(items_);
    check_items(static_cast<std::size_t>(items_), static_cast<std::size_t>(column.components));
    color_values(column, size);
    data_->push_back(std::move(column));
  }

  void color_values(Column& column, std::size_t size) {
    if (binary_) return numbers(column, size);
    for (std::size_t i = 0; i < size; ++i) {
      const double value = in_.real("a colour from 0 to 1");
      if (!(value >= 0 && value <= 1))
        in_.fail_in_line(fmt::format("expected a colour from 0 to 1, found {}", value));
      column.integers.push_back(static_cast<std::int64_t>(value * 255 + 0.5));
    }
  }

  void lookup_table() {
    Column column{.name = decoded(in_.word()), .type = "UInt8", .components = 4};
    const std::int64_t size = in_.count("the size of a lookup table", 4);
    color_values(column, 4 * static_cast<std::size_t>(size));
    add_vtk_field(document_, std::move(column));
  }

  void field() {
    in_.word();  // the field's name, which no one uses
    const std::int64_t arrays = in_.count("the number of arrays", 4);
    for (std::int64_t a = 0; a < arrays; ++a) {
      std::string_view word = in_.word();
      while (lower(word) == "metadata") {
        metadata();
        word = in_.word();
      }
      if (word.empty()) in_.fail("the name of an array", word);
      if (word == "NULL_ARRAY") continue;
      Column column{.name = decoded(word)};
      const std::int64_t each = in_.integer("the number of components"),
                         items = in_.integer("the number of tuples");
      if (each < 0 || items < 0 || each > std::numeric_limits<std::int32_t>::max())
        in_.fail_in_line(
            fmt::format("expected numbers of components and tuples, found {} and {}", each, items));
      column.components = std::max(1, static_cast<int>(each));
      column.type = type();
      check_items(static_cast<std::size_t>(items), static_cast<std::size_t>(each));
      numbers(column, static_cast<std::size_t>(each * items));
      if (!data_)
        add_vtk_field(document_, std::move(column));
      else if (items == items_)
        data_->push_back(std::move(column));
      else
        in_.fail_in_line(
            fmt::format("array \"{}\": expected {} tuples, found {}", column.name, items_, items));
    }
  }

  // Up to an empty line.
  void metadata() {
    in_.next_line();
    while (in_.remaining() > 0 && !in_.ends_line()) in_.next_line();
  }

  // Without a step: binary data may begin with what would be skipped as blanks.
  std::string next_word() const {
    Scanner ahead = in_;
    return lower(ahead.word());
  }

  std::string type() {
    const std::string_view word = in_.word();
    std::string found = vtu_type(lower(word));
    if (found.empty()) in_.fail("the type of numbers", word);
    return found;
  }

  void integers(Column& column, std::size_t count) {
    if (is_real_type(column.type) || column.type == "String" || column.type == "bit")
      in_.fail_in_line("expected a type of integers");
    numbers(column, count);
  }

  // Numbers that begin in the next line.
  void numbers(Column& column, std::size_t count) {
    if (column.type == "String") return strings(column, count);
    const bool bits = column.type == "bit";
    if (bits) column.type = "UInt8";
    if (!binary_) {
      for (std::size_t i = 0; i < count; ++i)
        if (is_real_type(column.type))
          column.reals.push_back(in_.real("a number"));
        else
          column.integers.push_back(in_.integer("an integer"));
      return;
    }
    in_.next_line();
    if (bits) {
      const std::string_view bytes = in_.raw((count + 7) / 8, "bits");
      for (std::size_t i = 0; i < count; ++i)
        column.integers.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
      return;
    }
    const std::size_t size = vtk_type_size(column.type);
    if (count > in_.remaining() / size)
      in_.fail_at_byte(fmt::format("expected {} numbers of {} bytes, found {} bytes and the end of the file",
                                   count, size, in_.remaining()));
    append_numbers(in_.raw(count * size, "numbers").data(), count, std::endian::big, column);
  }

  // A line each, or in binary: the first two bits tell how many bits say the length, 6, 14, 30 or 62.
  void strings(Column& column, std::size_t count) {
    in_.next_line();
    for (std::size_t i = 0; i < count; ++i) {
      if (in_.remaining() == 0) in_.fail("a text", {});
      if (!binary_) {
        column.texts.push_back(decoded(in_.rest_of_line()));
        in_.next_line();
        continue;
      }
      const unsigned first = static_cast<unsigned char>(in_.raw(1, "a text's length")[0]);
      const std::size_t more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7;
      std::uint64_t length = first & 63;
      for (const char c : in_.raw(more, "a text's length"))
        length = length << 8 | static_cast<unsigned char>(c);
      column.texts.emplace_back(in_.raw(length, "a text"));
    }
  }

  void check_data(const std::vector<Column>& data, std::size_t items, const char* what) const {
    for (const Column& column : data)
      if (column_size(column) != items * static_cast<std::size_t>(column.components))
        in_.fail_in_line(fmt::format("array \"{}\": expected values of {} {}, found {}", column.name, items,
                                     what,
                                     column_size(column) / static_cast<std::size_t>(column.components)));
  }

  struct List {
    int type = 0;
    std::vector<std::int64_t> connectivity{}, ends{};
  };

  Scanner in_;
  Document document_;
  VtkPiece piece_;
  bool binary_ = false, has_dataset_ = false, has_points_ = false;
  std::vector<std::int64_t> types_;
  std::vector<List> lists_;
  std::vector<Column>* data_ = nullptr;
  std::int64_t items_ = 0;
};

}  // namespace

Document read_vtk(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
