// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the arrays of VTK's legacy files: attributes of points and cells, and fields.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_legacy.hpp"
#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {

class VtkDataReader {
 public:
  /// Arrays of points and cells go into `piece`, others into tables of `document`, which also gets what is
  /// dropped.
  VtkDataReader(VtkLegacyScanner& in, Document& document, VtkPiece& piece)
      : in_(in), document_(document), piece_(piece) {}

  /// Reads what follows the word POINT_DATA or CELL_DATA. The attributes that follow are of this kind.
  void start(bool of_points);
  bool started() const { return data_ != nullptr; }

  /// Reads what follows a word of the file: an attribute of points or cells, FIELD, METADATA. `name`: the
  /// word in lower case.
  void attribute(const std::string& name, std::string_view word);
  void field();
  void metadata();
  /// METADATA that follow are about this array.
  void set_last_array(const std::string& name) { last_array_ = name; }

  /// Gives the arrays their roles, and checks that each has a value for each point or cell.
  void finish(std::size_t points, std::size_t cells);

 private:
  void add_role(const Column& column, std::string_view word);
  void take_roles();
  void table_of(const std::string& array, std::string_view table);
  void take(Column&& column);
  void colors(Column& column);
  void add_rounded(const std::string& array, std::size_t colors);
  std::size_t size_of_data(const Column& column) const;
  void lookup_table();
  void check_data(const std::vector<Column>& data, std::size_t items, const char* what) const;

  struct Role {
    std::string array, word;
  };
  VtkLegacyScanner& in_;
  Document& document_;
  VtkPiece& piece_;
  std::vector<Column>* data_ = nullptr;
  std::int64_t items_ = 0;
  std::string last_array_;   // METADATA are about this one
  std::vector<Role> roles_;  // of the arrays of these data
  bool has_field_ = false;   // whether these data have a FIELD
};

}  // namespace tetproof::io
