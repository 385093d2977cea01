// SPDX-License-Identifier: GPL-3.0-or-later
// A file in memory, and a scanner that knows its place in it: every reader starts from these.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tetproof {

/// A whole file, memory-mapped for reading; a pipe is read into memory. Throws InputError naming the path.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  /// All of standard input, read into memory. `path()` is "standard input", for messages.
  static InputFile standard_input();
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  /// Whether `path()` names a file, so that there can be others beside it; false for standard input.
  bool is_named() const { return named_; }
  std::string_view bytes() const { return bytes_; }
  /// Copies bytes of the file into memory. Several threads may do so at once.
  void copy(std::size_t offset, std::size_t size, char* to) const;
  /// Whether `copy` reads from the file and not from a copy in memory.
  bool in_file() const { return file_ >= 0; }

 private:
  struct StandardInput {};
  explicit InputFile(StandardInput);
  void read_all(int descriptor);  // into copy_

  std::string path_, copy_;
  std::string_view bytes_;
  void* map_ = nullptr;
  int file_ = -1;
  bool named_ = true;
};

/// Bytes of which long runs are wanted. It is better to copy a file piece by piece, into memory that is used
/// again, than to look at it in the map: the map costs a page fault for every few pages, which takes longer
/// than the copy, and it counts as resident memory.
struct Source {
  Source(std::string_view all) : bytes(all) {}
  Source(const InputFile& all) : bytes(all.bytes()), file(all.in_file() ? &all : nullptr) {}

  std::string_view bytes;
  const InputFile* file = nullptr;  ///< null: the bytes are in memory
};

/// Reads words, numbers and raw bytes from a file's text and counts lines. Blanks are space, tab, CR, LF, VT
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
  /// True if this very byte ends the line, or the file.
  bool ends_line() const { return remaining() == 0 || bytes_[at_] == '\n' || bytes_[at_] == '\r'; }
  void next_line();                 ///< to the start of the next line
  std::string_view rest_of_line();  ///< without its line end; stays in front of it

  std::string_view word(char comment = '\0');  ///< empty at the end of the file
  std::string_view peek_word(char comment = '\0');
  /// A decimal number, exactly rounded; with +, inf, nan and exponents with D.
  double real(const char* expected, char comment = '\0');
  std::int64_t integer(const char* expected, char comment = '\0');
  /// As above, but the number must stand in this line: the error names a short line, not the next line's
  /// word.
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
