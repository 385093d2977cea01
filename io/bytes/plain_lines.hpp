// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs of lines of plain numbers, read by several threads. What is unusual in any way is left to the
// readers that take one word after the other, which know what to say of it.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

/// Fewer lines are read one word after the other.
inline constexpr std::size_t least_plain_lines = 1024;

/// A line of numbers between blanks. Everything answers false where the line is not as plain as that.
class PlainLine {
 public:
  PlainLine(const char* at, const char* end) : at_(at), end_(end) {}

  /// Decimal, of at most 18 digits without leading zeros; a minus sign is plain enough.
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

  /// That this was all of it; steps to the next line.
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

/// Whole lines of a text.
struct LinePiece {
  std::size_t number = 0;            ///< of its wave
  std::size_t first = 0, count = 0;  ///< lines
  std::string_view text;             ///< begins with the first of them, and has all of them
};

/// What reading lines wave by wave calls. A wave is as much of the text as is in memory at once.
struct LineReader {
  /// The lines of a wave, not empty, before any of them is read.
  std::function<void(const std::vector<LinePiece>&)> begin = [](const auto&) {};
  /// From several threads: where the last line ends, or null where one was not plain.
  std::function<const char*(const LinePiece&)> read;
  /// After all of the wave was read, and was plain; false where its lines do not fit together after all.
  std::function<bool(const std::vector<LinePiece>&)> end = [](const auto&) { return true; };
};

/// Reads the `count` lines from `offset` on: the offset behind the last one, or none if the text has fewer or
/// any was not plain.
std::optional<std::size_t> read_lines(const Source& text, std::size_t offset, std::size_t count,
                                      const LineReader& reader);

/// Calls `read(PlainLine&, i)` for line i of `count`, from several threads; it answers false for a line that
/// is not plain. The offset behind the last line, or none if any was not plain.
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
