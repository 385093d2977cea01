// SPDX-License-Identifier: GPL-3.0-or-later
// Reads words, numbers and raw bytes from a text one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof {

/// Reads words, numbers and raw bytes from a file's text and counts lines. Blanks are space, tab, CR, LF, VT
/// and FF. Lines end with LF, CR LF or a lone CR. Every failure is an InputError with the path, the line or
/// byte offset, what was expected and what was found.
class Scanner {
 public:
  Scanner(const std::string& path, std::string_view bytes, std::size_t offset = 0)
      : path_(&path), bytes_(bytes), at_(offset) {}
  /// Starts at the beginning of the file, or after the byte order mark that some editors write before UTF-8.
  explicit Scanner(const InputFile& file)
      : Scanner(file.path(), file.bytes(), file.bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  std::size_t offset() const { return at_; }
  std::size_t remaining() const { return bytes_.size() - at_; }
  std::int64_t line() const;  ///< the current line, from 1; counted on demand

  /// Skips blanks and line ends; if `comment` is given, also comments from that character to the end of the
  /// line. True if nothing is left.
  bool at_end(char comment = '\0');
  /// Skips blanks and a comment in this line. True at the end of the line or of the file.
  bool at_line_end(char comment = '\0');
  /// Whether the line ends at exactly this byte.
  bool ends_line() const { return remaining() == 0 || bytes_[at_] == '\n' || bytes_[at_] == '\r'; }
  char peek_byte() const { return remaining() == 0 ? '\0' : bytes_[at_]; }  ///< 0 at the end of the file
  void next_line();                 ///< goes to the start of the next line
  std::string_view rest_of_line();  ///< without its line end; the scanner stays before the line end

  std::string_view word(char comment = '\0');  ///< empty at the end of the file
  std::string_view peek_word(char comment = '\0');
  /// A decimal number, correctly rounded. Also accepts a plus sign, inf, nan and D exponents.
  double real(const char* expected, char comment = '\0');
  std::int64_t integer(const char* expected, char comment = '\0');
  /// The same, but the number must be in this line. If the line is too short, the message says so, instead of
  /// naming the next line's first word.
  double real_in_line(const char* expected, char comment = '\0');
  std::int64_t integer_in_line(const char* expected, char comment = '\0');
  /// A count: an integer >= 0 of items that the rest of the file can hold, each at least `least_bytes_each`
  /// long. So callers never allocate more than that.
  std::int64_t count(const char* expected, std::size_t least_bytes_each, char comment = '\0');

  std::string_view raw(std::size_t size, const char* expected);  ///< exactly `size` bytes

  /// Throws "path:line: expected EXPECTED, found WORD", for the word that was read last.
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
  /// Throws "path: byte N: MESSAGE", for binary parts.
  [[noreturn]] void fail_at_byte(std::string_view message) const;
  /// Throws "path:line: MESSAGE".
  [[noreturn]] void fail_in_line(std::string_view message) const;

 private:
  void expect_in_line(const char* expected, char comment);

  const std::string* path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  mutable std::size_t counted_to_ = 0;
  mutable std::int64_t lines_ = 1;
};

/// The double nearest to a decimal text, ties to even, as `strtod` gives it in the C locale. A number that is
/// too large gives infinity; one that is too small gives zero or a subnormal. False if the whole `text` is
/// not a number.
bool parse_real(std::string_view text, double& value);
/// The whole `text` as a decimal integer with an optional sign. False if it is no integer or does not fit.
bool parse_integer(std::string_view text, std::int64_t& value);

}  // namespace tetproof
