// SPDX-License-Identifier: GPL-3.0-or-later
// Reads words, numbers and raw bytes one after the other, and knows the place for error messages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof {

/// Reads words, numbers and raw bytes from a file's text, counting lines. Blanks are space, tab, CR, LF, VT
/// and FF; lines end with LF, CR LF or a lone CR. Every failure is an InputError: path, line or byte offset,
/// what was expected and what was found.
class Scanner {
 public:
  Scanner(const std::string& path, std::string_view bytes, std::size_t offset = 0)
      : path_(&path), bytes_(bytes), at_(offset) {}
  /// From the start, past the byte order mark that some editors put in front of UTF-8.
  explicit Scanner(const InputFile& file)
      : Scanner(file.path(), file.bytes(), file.bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  std::size_t offset() const { return at_; }
  std::size_t remaining() const { return bytes_.size() - at_; }
  std::int64_t line() const;  ///< of the current place, from 1; counted on demand

  /// Skips blanks over line ends and, if given, from `comment` to the end of the line; true when nothing is
  /// left.
  bool at_end(char comment = '\0');
  /// Skips blanks in this line and a comment; true at the line's end or the file's.
  bool at_line_end(char comment = '\0');
  bool ends_line() const {
    return remaining() == 0 || bytes_[at_] == '\n' || bytes_[at_] == '\r';
  }                                 ///< at this very byte
  void next_line();                 ///< to the start of the next line
  std::string_view rest_of_line();  ///< without its line end; stays in front of it

  std::string_view word(char comment = '\0');  ///< empty at the end of the file
  std::string_view peek_word(char comment = '\0');
  double real(const char* expected,
              char comment = '\0');  ///< decimal, exactly rounded; takes +, inf, nan, D exponents
  std::int64_t integer(const char* expected, char comment = '\0');
  /// The same, but the number must stand in this line: a short line is told as such, not as what follows it.
  double real_in_line(const char* expected, char comment = '\0');
  std::int64_t integer_in_line(const char* expected, char comment = '\0');
  /// An integer in [0, most]: a count that the rest of the file could hold. Nothing is allocated for more.
  std::int64_t count(const char* expected, std::size_t least_bytes_each, char comment = '\0');

  std::string_view raw(std::size_t size, const char* expected);  ///< exactly `size` bytes

  /// "path:line: expected EXPECTED, found WORD", for the word that was read last.
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
  /// "path: byte N: MESSAGE", for binary parts.
  [[noreturn]] void fail_at_byte(std::string_view message) const;
  /// "path:line: MESSAGE".
  [[noreturn]] void fail_in_line(std::string_view message) const;

 private:
  void expect_in_line(const char* expected, char comment);

  const std::string* path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  mutable std::size_t counted_to_ = 0;
  mutable std::int64_t lines_ = 1;
};

/// The double nearest to a decimal text, ties to even, as `strtod` in the C locale would give it; false if
/// `text` is not all of a number. Too large gives infinity, too small zero or a subnormal.
bool parse_real(std::string_view text, double& value);
/// All of `text` as a decimal integer with an optional sign; false if it is none or does not fit.
bool parse_integer(std::string_view text, std::int64_t& value);

}  // namespace tetproof
