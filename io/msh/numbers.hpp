// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the numbers of a .msh section with the same calls for text and for binary.
#pragma once

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

class Numbers {
 public:
  Numbers(const std::string& path, std::string_view bytes, std::size_t offset, bool binary, bool swapped)
      : path_(&path), bytes_(bytes), source_(bytes), at_(offset), binary_(binary), swapped_(swapped) {}
  Numbers(const InputFile& file, std::size_t offset, bool binary, bool swapped)
      : path_(&file.path()),
        bytes_(file.bytes()),
        source_(file),
        at_(offset),
        binary_(binary),
        swapped_(swapped) {}

  std::size_t offset() const { return at_; }
  const Source& source() const { return source_; }
  void go_to(std::size_t offset) { at_ = offset; }
  std::size_t remaining() const { return bytes_.size() - at_; }
  bool binary() const { return binary_; }
  bool swapped() const { return swapped_; }

  /// Reads an int: 4 bytes in binary.
  std::int64_t integer(const char* expected) {
    return binary_ ? raw<std::int32_t>(expected) : text_integer(expected);
  }
  /// Reads a size_t: 8 bytes in binary. Tags are such in 4.1.
  std::int64_t size(const char* expected) {
    return binary_ ? raw<std::int64_t>(expected) : text_integer(expected, true);
  }
  double real(const char* expected) { return binary_ ? raw<double>(expected) : text_real(expected); }

  /// Reads a size_t that is a count. InputError if the rest of the file cannot hold so many things of so many
  /// bytes.
  std::int64_t count(const char* expected, std::size_t least_text, std::size_t least_binary) {
    const std::int64_t value = size(expected);
    check_count(value, expected, binary_ ? least_binary : least_text);
    return value;
  }
  void check_count(std::int64_t value, const char* expected, std::size_t least_bytes_each) const;

  void skip_blanks() {
    while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
  }

  /// Whether the next word of a text is the end of its section or of the file.
  bool at_section_end();
  std::int64_t line(std::size_t offset) const;  ///< the line of a text at this byte

  /// The number of words left in this line of text.
  std::int32_t words_in_line() const;

  /// "path:line: MESSAGE" or "path: byte N: MESSAGE".
  [[noreturn]] void fail(std::string_view message) const;

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::int64_t text_integer(const char* expected, bool may_wrap = false) {
    skip_blanks();
    const char* const start = bytes_.data() + at_;
    const char* const end = bytes_.data() + bytes_.size();
    std::uint64_t value = 0;
    const char* c = start;
    for (unsigned digit; c < end && (digit = static_cast<unsigned char>(*c) - '0') < 10; ++c)
      value = 10 * value + digit;
    if (c == start || c - start > 18 || (c < end && !is_blank(*c)))
      return unusual_integer(expected, may_wrap);
    at_ += c - start;
    return static_cast<std::int64_t>(value);
  }

  double text_real(const char* expected) {
    skip_blanks();
    double value;
    const auto [c, error] = std::from_chars(bytes_.data() + at_, bytes_.data() + bytes_.size(), value);
    if (error != std::errc() || (c < bytes_.data() + bytes_.size() && !is_blank(*c)))
      return unusual_real(expected);
    at_ = c - bytes_.data();
    return value;
  }

  template <class T>
  T raw(const char* expected) {
    if (remaining() < sizeof(T)) fail_short(expected, sizeof(T));
    unsigned char buffer[sizeof(T)];
    std::memcpy(buffer, bytes_.data() + at_, sizeof(T));
    if (swapped_)
      for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(buffer[k], buffer[sizeof(T) - 1 - k]);
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, buffer, sizeof(T));
    return value;
  }

  // Handles signs and words that are no integers. `may_wrap`: Gmsh writes the size_t -k as 2^64 - k.
  std::int64_t unusual_integer(const char* expected, bool may_wrap);
  double unusual_real(const char* expected);
  [[noreturn]] void fail_short(const char* expected, std::size_t size) const;

  const std::string* path_;
  std::string_view bytes_;
  Source source_;
  std::size_t at_;
  bool binary_, swapped_;
};

}  // namespace tetproof::io
