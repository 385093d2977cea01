// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's legacy files consist of, in text and in binary: words, arrays of numbers or texts, and lists of
// cells.
#pragma once

#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// Reads the parts of a legacy file one after the other. InputError, with the place, for what the format does
/// not permit. The scanner is everyone's: what is simple is read from it.
class VtkLegacyScanner : public Scanner {
 public:
  explicit VtkLegacyScanner(const InputFile& file) : Scanner(file) {}

  /// From here on numbers are binary.
  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }

  /// In small letters and without a step: binary data may begin with what would be skipped as blanks.
  std::string next_word() const;
  /// A word that names the type of numbers, as .vtu files call it (or "bit").
  std::string type();
  int components();

  /// Appends `count` values of `column.type`, which begin in the next line.
  void numbers(Column& column, std::size_t count);
  /// The same, if these are integers.
  void integers(Column& column, std::size_t count);
  /// Reals from 0 to 1 in text, bytes in binary: bytes in either case to VTK.
  void colors(Column& column, std::size_t count);
  /// That `items` times `each` values can follow: they need bytes, or bits.
  void check_room(std::size_t items, std::size_t each) const;

  /// A list of cells, either of so many numbers each or, since version 5.1, as offsets and connectivity.
  /// `ends`: of each cell in `connectivity`.
  void cells(std::vector<std::int64_t>& connectivity, std::vector<std::int64_t>& ends);

 private:
  void texts(Column& column, std::size_t count);
  void cells_by_offsets(std::size_t count, std::size_t size, std::vector<std::int64_t>& connectivity,
                        std::vector<std::int64_t>& ends);

  bool binary_ = false;
};

}  // namespace tetproof::io
