// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_information.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {

void VtkDataReader::start(bool of_points) {
  items_ = in_.integer("a number of items");
  if (items_ < 0) in_.fail_in_line(fmt::format("expected a number of items, found {}", items_));
  take_roles();
  data_ = of_points ? &piece_.point_data : &piece_.cell_data;
}

void VtkDataReader::metadata() {
  read_vtk_metadata(in_, last_array_, document_.dropped);
}

void VtkDataReader::finish(std::size_t points, std::size_t cells) {
  take_roles();
  check_data(piece_.cell_data, cells, "cells");
  check_data(piece_.point_data, points, "points");
}

void VtkDataReader::attribute(const std::string& name, std::string_view word) {
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
    add_role(column, word);
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
  add_role(column, word);
  take(std::move(column));
}

// Arrays of tags become what they say, and have no use for a role.
void VtkDataReader::add_role(const Column& column, std::string_view word) {
  if (data_ == &piece_.cell_data && column.components == 1 && column.texts.empty() &&
      may_be_vtk_tag_name(column.name) && may_be_tags(column.name, column.integers, column.reals))
    return;
  roles_.push_back({column.name, std::string(word)});
}

// SCALARS, VECTORS and TENSORS are also just how an array of 1, 3 or 9 numbers each is written. They are a
// choice only beside a FIELD, whose arrays have no role; and VTK then chooses the first of a kind.
void VtkDataReader::take_roles() {
  std::set<std::string> chosen;
  for (const Role& role : roles_) {
    const std::string word = lower_case(role.word);
    const bool is_form = word == "scalars" || word == "vectors" || word == "tensors" || word == "tensors6";
    const std::string name(role_of_vtk_word(word));
    const bool first = chosen.insert(name).second;
    if (is_form && (!has_field_ || !first)) continue;
    if (!name.empty() && first)
      (data_ == &piece_.point_data ? piece_.point_roles : piece_.cell_roles).push_back({role.array, name});
    else
      add_vtk_role(document_.dropped, role.array, role.word);
  }
  roles_.clear();
  has_field_ = false;
}

void VtkDataReader::table_of(const std::string& array, std::string_view table) {
  if (lower_case(table) != "default")
    add_loss(document_.dropped, "lookup tables of values", 1,
             fmt::format("\"{}\" of \"{}\"", vtk_decoded(table), array));
}

void VtkDataReader::take(Column&& column) {
  last_array_ = column.name;
  data_->push_back(std::move(column));
}

void VtkDataReader::colors(Column& column) {
  column.components = in_.components();
  column.type = "UInt8";
  add_rounded(column.name, in_.colors(column, size_of_data(column)));
  take(std::move(column));
}

void VtkDataReader::add_rounded(const std::string& array, std::size_t colors) {
  add_loss(document_.dropped, "colours, rounded to bytes", colors, fmt::format("\"{}\"", array));
}

// The number of values that the points or cells have in a column. The rest of the file can hold them.
std::size_t VtkDataReader::size_of_data(const Column& column) const {
  const auto each = static_cast<std::size_t>(column.components), items = static_cast<std::size_t>(items_);
  in_.check_room(items, each);
  return items * each;
}

void VtkDataReader::lookup_table() {
  Column column{.name = vtk_decoded(in_.word()), .type = "UInt8", .components = 4};
  const std::int64_t size = in_.count("the size of a lookup table", 4);
  add_rounded(column.name, in_.colors(column, 4 * static_cast<std::size_t>(size)));
  last_array_ = column.name;
  add_vtk_field(document_, std::move(column));
}

void VtkDataReader::field() {
  const std::string name = vtk_decoded(in_.word());  // "FieldData" is what VTK writes
  if (lower_case(name) != "fielddata")
    add_loss(document_.dropped, "names of fields", 1, fmt::format("\"{}\"", name));
  const std::int64_t arrays = in_.count("the number of arrays", 4);
  has_field_ = has_field_ || data_;
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
    else if (items == 0)  // VTK keeps it too, and shows nothing
      add_loss(document_.dropped, "arrays without values", 1, fmt::format("\"{}\"", column.name));
    else
      in_.fail_in_line(
          fmt::format("array \"{}\": expected {}, found {}", column.name, counted(items_, "tuples"), items));
  }
}

void VtkDataReader::check_data(const std::vector<Column>& data, std::size_t items, const char* what) const {
  for (const Column& column : data)
    if (column_size(column) != items * static_cast<std::size_t>(column.components))
      in_.fail_in_line(fmt::format("array \"{}\": expected values of {} {}, found {}", column.name, items,
                                   what, column_size(column) / static_cast<std::size_t>(column.components)));
}

}  // namespace tetproof::io
