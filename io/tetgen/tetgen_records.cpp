// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tetgen/tetgen_records.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/tetgen/tetgen.hpp"

namespace tetproof::io {
namespace {

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\v' || c == '\f';
}
bool ends_word(char c) {
  return is_separator(c) || is_line_end(c) || c == '#';
}

}  // namespace

Records::Records(const InputFile& file, Document& document) : file_(file), document_(document) {
  refuse_wide_text(file);
  const std::string_view bytes = file.bytes();
  at_ = bytes.data() + start_of_utf8(bytes);
  end_ = bytes.data() + end_of_text(bytes);
  if (const std::string warning = warning_of_end(file); !warning.empty())
    document.warnings.push_back(warning);
}

bool Records::next() {
  if (started_) skip_line();
  started_ = true;
  while (!more() && at_ < end_) skip_line();
  return at_ < end_;
}

void Records::expect_next(const char* expected) {
  if (!next()) fail(fmt::format("expected {}, found the end of the file", expected));
}

bool Records::more() {
  while (at_ < end_ && is_separator(*at_)) ++at_;
  return at_ < end_ && !is_line_end(*at_) && *at_ != '#';
}

int Records::words() {
  const char* const start = at_;
  int found = 0;
  for (; more() && found < 1000; ++found) word();
  at_ = start;
  return found;
}

std::int64_t Records::integer(const char* expected) {
  if (!more()) fail_missing(expected);
  std::uint64_t value = 0;  // may wrap; then there are too many digits, and it is not used
  const char* c = at_;
  for (unsigned digit; c < end_ && (digit = static_cast<unsigned char>(*c) - '0') < 10; ++c)
    value = 10 * value + digit;
  const bool plain =
      c > at_ && c - at_ <= 18 && (*at_ != '0' || c == at_ + 1) && (c == end_ || ends_word(*c));
  if (!plain) return unusual_integer(expected);
  at_ = c;
  return static_cast<std::int64_t>(value);
}

double Records::real(const char* expected) {
  if (!more()) fail_missing(expected);
  double value;
  const auto [c, error] = std::from_chars(at_, end_, value);
  if (error == std::errc() && (c == end_ || ends_word(*c))) {
    at_ = c;
    return value;
  }
  const std::string_view text = word();
  if (!parse_real(text, value)) fail(expected, text);
  return value;
}

std::int64_t Records::count(const char* expected, std::int64_t least_bytes_each) {
  const std::int64_t value = integer(expected);
  check_count(value, expected, least_bytes_each);
  return value;
}

void Records::check_count(std::int64_t value, const char* expected, std::int64_t least_bytes_each) const {
  if (value < 0) fail(fmt::format("expected {}, found {}", expected, value));
  if (value > static_cast<std::int64_t>(remaining()) / least_bytes_each + 1)
    fail(fmt::format("expected {}, found {}, more than the {} left can hold", expected, value,
                     counted(remaining(), "bytes")));
}

void Records::list_number(const char* expected, std::int64_t i, std::int64_t& first, const char* item) {
  const std::int64_t number = integer(expected);
  if (i == 0) first = number == 0 ? 0 : 1;
  if (number != first + i)
    add_loss(document_.dropped, item, 1, fmt::format("{} in place of {}", number, first + i));
}

// Counting lines takes long, so only the first example of a file has one.
void Records::end_record() {
  if (!more()) return;
  add_loss(document_.dropped, "words behind those that are read in a line", static_cast<std::size_t>(words()),
           listed_columns_ ? "" : place());
  listed_columns_ = true;
}

void Records::end_file(bool elements) {
  if (!next()) return;
  const std::string first = place();
  std::size_t lines = 1;
  while (next()) ++lines;
  add_loss(document_.dropped, lines_behind_those_announced, lines, first, elements);
}

void Records::other_number(const char* what, std::int64_t number, std::int64_t counted, const char* item) {
  if (item) add_loss(document_.dropped, item, 1, fmt::format("{} in place of {}", number, counted));
  if (warned_of_number_) return;
  warned_of_number_ = true;
  warn(fmt::format("{} {} stands where {} {} is due; TetGen goes by the order of the lines (the first such)",
                   what, number, what, counted));
}

std::size_t Records::next_line() {
  if (started_) skip_line();
  started_ = false;
  return offset();
}

void Records::go_to(std::size_t offset) {
  at_ = file_.bytes().data() + offset;
  started_ = false;
}

std::string_view Records::word() {
  const char* const start = at_;
  while (at_ < end_ && !ends_word(*at_)) ++at_;
  return {start, static_cast<std::size_t>(at_ - start)};
}

// TetGen reads integers as a C compiler does: 0x10 is sixteen, 010 is eight.
std::int64_t Records::unusual_integer(const char* expected) {
  const std::string_view text = word();
  std::string_view digits = text;
  const bool negative = !digits.empty() && digits[0] == '-';
  if (negative || (!digits.empty() && digits[0] == '+')) digits.remove_prefix(1);
  int base = 10;
  if (digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
    base = 16;
    digits.remove_prefix(2);
  } else if (digits.size() > 1 && digits[0] == '0') {
    base = 8;
  }
  std::uint64_t value = 0;
  const auto [c, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc() || c != digits.data() + digits.size() || digits.empty() ||
      value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) + (negative ? 1 : 0))
    fail(expected, text);
  if (base != 10 && !warned_of_base_) {
    warned_of_base_ = true;
    warn(fmt::format("{} is {} to TetGen, which reads integers as C does (the first such)", text, value));
  }
  return static_cast<std::int64_t>(negative ? 0 - value : value);
}

void Records::skip_line() {
  while (at_ < end_ && !is_line_end(*at_)) ++at_;
  if (at_ < end_ && *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n') ++at_;
  if (at_ < end_) ++at_;
}

void Records::warn(const std::string& message) {
  document_.warnings.push_back(fmt::format("{}: {}", place(), message));
}

std::string Records::place() const {
  return fmt::format("{}:{}", file_.path(), here().line());
}

void Records::fail_missing(const char* expected) const {
  if (at_ >= end_) here().fail(expected, {});
  fail(fmt::format("expected {}, found the end of the line", expected));
}

}  // namespace tetproof::io
