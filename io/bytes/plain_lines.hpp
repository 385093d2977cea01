// SPDX-License-Identifier: GPL-3.0-or-later
// Reads long runs of lines of plain numbers by several threads. Anything unusual is left to the readers that
// take one word after the other, because they can report it.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// Shorter runs of lines are read one word after the other.
inline constexpr std::size_t least_plain_lines = 1024;

/// A line of numbers between blanks. Every function returns false if the line is not that plain.
class PlainLine {
 public:
  PlainLine(const char* at, const char* end) : at_(at), end_(end) {}

  /// A decimal integer of at most 18 digits without leading zeros. It may have a minus sign.
  bool integer(std::int64_t& value) {
    skip_blanks();
    const bool negative = at_ < end_ && *at_ == '-';
    const char* const start = at_ + negative;
    const char* c = start;
    std::uint64_t sum = 0;
    for (unsigned digit; c < end_ && (digit = static_cast<unsigned char>(*c) - '0') < 10; ++c)
      sum = 10 * sum + digit;
    if (c == start || c - start > 18 || (*start == '0' && c - start > 1)) return false;
    at_ = c;
    value = negative ? -static_cast<std::int64_t>(sum) : static_cast<std::int64_t>(sum);
    return ends_word();
  }

  bool real(double& value) {
    skip_blanks();
    const auto [c, error] = std::from_chars(at_, end_, value);
    at_ = c;
    return error == std::errc() && ends_word();
  }

  /// Whether the line has no more words. Goes to the next line.
  bool end() {
    skip_blanks();
    if (at_ < end_ && *at_ == '\r') ++at_;
    if (at_ == end_) return true;
    return *at_++ == '\n';
  }

  const char* place() const { return at_; }

 private:
  void skip_blanks() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
  }
  bool ends_word() const {
    return at_ == end_ || *at_ == ' ' || *at_ == '\t' || *at_ == '\n' || *at_ == '\r';
  }

  const char *at_, *end_;
};

/// A piece of a text: some whole lines.
struct LinePiece {
  std::size_t number = 0;            ///< its position in its wave
  std::size_t first = 0, count = 0;  ///< the first line's position in the run, and the number of lines
  std::string_view text;             ///< begins with the first of these lines, and has at least all of them
};

/// The functions that `read_lines` calls. It reads wave by wave; a wave is the part of the text that is in
/// memory at once.
struct LineReader {
  /// Called before a wave is read, with its pieces (at least one).
  std::function<void(const std::vector<LinePiece>&)> begin = [](const auto&) {};
  /// Reads a piece, called from several threads. Returns the end of its last line; null if a line is not
  /// plain.
  std::function<const char*(const LinePiece&)> read;
  /// Called after the whole wave was read and was plain. Returns false if its lines do not fit together after
  /// all.
  std::function<bool(const std::vector<LinePiece>&)> end = [](const auto&) { return true; };
};

/// Reads `count` lines from `offset` on. Returns the offset after the last one; nothing if the text has fewer
/// lines or if a line is not plain.
std::optional<std::size_t> read_lines(const Source& text, std::size_t offset, std::size_t count,
                                      const LineReader& reader);

/// Calls `read(PlainLine&, i)` for each line i of `count`, from several threads. `read` returns false if the
/// line is not plain. Returns the offset after the last line; nothing if a line is not plain.
template <class Read>
std::optional<std::size_t> read_plain_lines(const Source& text, std::size_t offset, std::size_t count,
                                            const Read& read) {
  if (count < least_plain_lines) return std::nullopt;
  LineReader reader;
  reader.read = [&](const LinePiece& piece) -> const char* {
    PlainLine line(piece.text.data(), piece.text.data() + piece.text.size());
    for (std::size_t i = piece.first; i < piece.first + piece.count; ++i)
      if (!read(line, i) || !line.end()) return nullptr;
    return line.place();
  };
  return read_lines(text, offset, count, reader);
}

}  // namespace tetproof::io
