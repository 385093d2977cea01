// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of VTK's legacy files, text and binary: words, arrays of numbers or texts, and lists of cells.
#pragma once

#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// Reads the parts of a legacy file one after the other. InputError, with the place, for what the format does
/// not permit. Simple parts are read with the functions of Scanner.
class VtkLegacyScanner : public Scanner {
 public:
  explicit VtkLegacyScanner(const InputFile& file) : Scanner(file) {}
  using Scanner::Scanner;

  /// From here on numbers are binary.
  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }

  /// The word that follows, in lower case. The scanner stays where it is, because binary data may follow, and
  /// their first bytes may look like blanks.
  std::string next_word() const;
  /// Reads a word that names a type of numbers. Returns the type's name in .vtu files, or "bit".
  std::string type();
  int components();

  /// A word that VTK takes for a type, because it begins with the type's name: "int1".
  struct OddType {
    std::string word;
    std::int64_t line;  ///< of the first
    std::string type;
    std::int64_t count = 0;
    std::int64_t others = 0;  ///< behind the last one: of further words
  };
  const std::vector<OddType>& odd_types() const { return odd_types_; }

  /// Appends `count` values of `column.type`. They begin in the next line.
  void numbers(Column& column, std::size_t count);
  /// Does the same, but refuses a type that is not of integers.
  void integers(Column& column, std::size_t count);
  /// Appends `count` colours as bytes, as VTK has them. Text gives them as reals from 0 to 1. Returns how
  /// many of these are no multiple of 1/255, to six digits, and so were rounded.
  std::size_t colors(Column& column, std::size_t count);
  /// Checks that `items` times `each` values can follow: each needs a bit at least.
  void check_room(std::size_t items, std::size_t each) const;

  /// Reads a list of cells: each with its number of points in front or, since version 5.1, as offsets and
  /// connectivity. `ends` gets the end of each cell in `connectivity`.
  void cells(std::vector<std::int64_t>& connectivity, std::vector<std::int64_t>& ends);

 private:
  void texts(Column& column, std::size_t count);
  void cells_by_offsets(std::size_t count, std::size_t size, std::vector<std::int64_t>& connectivity,
                        std::vector<std::int64_t>& ends);

  bool binary_ = false;
  std::vector<OddType> odd_types_;
};

}  // namespace tetproof::io
