// SPDX-License-Identifier: GPL-3.0-or-later
// Handles the numbers of a .msh section that are unusual or wrong.
#include "io/msh/numbers.hpp"

#include <fmt/format.h>

#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::io {

void Numbers::check_count(std::int64_t value, const char* expected, std::size_t least_bytes_each) const {
  if (value < 0) fail(fmt::format("expected {}, found {}", expected, value));
  if (static_cast<std::uint64_t>(value) >
      remaining() / least_bytes_each + 1)  // the last line may lack its end
    fail(fmt::format("expected {}, found {}, more than the {} left can hold", expected, value,
                     counted(remaining(), "bytes")));
}

std::int32_t Numbers::words_in_line() const {
  std::int32_t words = 0;
  bool in_word = false;
  for (std::size_t i = at_; i < bytes_.size() && bytes_[i] != '\n' && bytes_[i] != '\r'; ++i) {
    words += !in_word && !is_blank(bytes_[i]);
    in_word = !is_blank(bytes_[i]);
  }
  return words;
}

bool Numbers::at_section_end() {
  skip_blanks();
  return at_ == bytes_.size() || bytes_[at_] == '$';
}

std::int64_t Numbers::line(std::size_t offset) const {
  Scanner place(*path_, bytes_, offset);
  place.at_end();
  return place.line();
}

void Numbers::fail(std::string_view message) const {
  const Scanner here(*path_, bytes_, at_);
  binary_ ? here.fail_at_byte(message) : here.fail_in_line(message);
}

std::int64_t Numbers::unusual_integer(const char* expected, bool may_wrap) {
  Scanner slow(*path_, bytes_, at_);
  if (may_wrap) {
    const std::string_view word = slow.peek_word();
    std::uint64_t value;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size() && !word.empty()) {
      slow.word();
      at_ = slow.offset();
      return static_cast<std::int64_t>(value);
    }
  }
  const std::int64_t value = slow.integer(expected);
  at_ = slow.offset();
  return value;
}

double Numbers::unusual_real(const char* expected) {
  Scanner slow(*path_, bytes_, at_);
  const double value = slow.real(expected);
  at_ = slow.offset();
  return value;
}

void Numbers::fail_short(const char* expected, std::size_t size) const {
  fail(fmt::format("expected {} ({}), found {} and the end of the file", expected, counted(size, "bytes"),
                   counted(remaining(), "bytes")));
}

}  // namespace tetproof::io
