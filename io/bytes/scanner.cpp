// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/scanner.hpp"

#include <fmt/core.h>
#include <locale.h>

#include <charconv>
#include <cstdlib>

#include "io/bytes/one_line.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"

namespace tetproof {
namespace {

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

// A word as a message shows it: printable and short.
std::string shown(std::string_view found) {
  return found.empty() ? "the end of the file" : fmt::format("'{}'", io::start_in_one_line(found, 40));
}

}  // namespace

std::int64_t Scanner::line() const {
  for (; counted_to_ < at_; ++counted_to_) {
    const char c = bytes_[counted_to_];
    const bool half_of_crlf = c == '\r' && counted_to_ + 1 < bytes_.size() && bytes_[counted_to_ + 1] == '\n';
    lines_ += is_line_end(c) && !half_of_crlf;
  }
  return lines_;
}

bool Scanner::at_end(char comment) {
  for (; at_ < bytes_.size(); ++at_) {
    if (comment && bytes_[at_] == comment)
      while (at_ + 1 < bytes_.size() && !is_line_end(bytes_[at_ + 1])) ++at_;
    else if (!is_blank(bytes_[at_]))
      return false;
  }
  return true;
}

bool Scanner::at_line_end(char comment) {
  while (at_ < bytes_.size() && is_blank(bytes_[at_]) && !is_line_end(bytes_[at_])) ++at_;
  if (comment && at_ < bytes_.size() && bytes_[at_] == comment)
    while (at_ < bytes_.size() && !is_line_end(bytes_[at_])) ++at_;
  return at_ == bytes_.size() || is_line_end(bytes_[at_]);
}

void Scanner::next_line() {
  while (at_ < bytes_.size() && !is_line_end(bytes_[at_])) ++at_;
  if (at_ < bytes_.size() && bytes_[at_] == '\r' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n') ++at_;
  if (at_ < bytes_.size()) ++at_;
}

std::string_view Scanner::rest_of_line() {
  const std::size_t start = at_;
  while (at_ < bytes_.size() && !is_line_end(bytes_[at_])) ++at_;
  return bytes_.substr(start, at_ - start);
}

std::string_view Scanner::word(char comment) {
  if (at_end(comment)) return {};
  const std::size_t start = at_;
  while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && !(comment && bytes_[at_] == comment)) ++at_;
  return bytes_.substr(start, at_ - start);
}

std::string_view Scanner::peek_word(char comment) {
  at_end(comment);
  const std::size_t start = at_;
  const std::string_view found = word(comment);
  at_ = start;
  return found;
}

double Scanner::real(const char* expected, char comment) {
  const std::string_view text = word(comment);
  double value;
  if (!parse_real(text, value)) fail(expected, text);
  return value;
}

std::int64_t Scanner::integer(const char* expected, char comment) {
  const std::string_view text = word(comment);
  std::int64_t value;
  if (!parse_integer(text, value)) fail(expected, text);
  return value;
}

void Scanner::expect_in_line(const char* expected, char comment) {
  if (at_line_end(comment))
    fail_in_line(
        fmt::format("expected {}, found the end of the {}", expected, remaining() ? "line" : "file"));
}

double Scanner::real_in_line(const char* expected, char comment) {
  expect_in_line(expected, comment);
  return real(expected, comment);
}

std::int64_t Scanner::integer_in_line(const char* expected, char comment) {
  expect_in_line(expected, comment);
  return integer(expected, comment);
}

std::int64_t Scanner::count(const char* expected, std::size_t least_bytes_each, char comment) {
  const std::int64_t value = integer(expected, comment);
  const std::size_t most = remaining() / least_bytes_each + 1;  // the last item may lack its line end
  if (value < 0) fail_in_line(fmt::format("expected {}, found {}", expected, value));
  if (static_cast<std::size_t>(value) > most)
    fail_in_line(fmt::format("expected {}, found {}, more than the {} left can hold", expected, value,
                             io::counted(remaining(), "bytes")));
  return value;
}

std::string_view Scanner::raw(std::size_t size, const char* expected) {
  if (size > remaining())
    fail_at_byte(fmt::format("expected {} ({}), found {} and the end of the file", expected,
                             io::counted(size, "bytes"), io::counted(remaining(), "bytes")));
  const std::string_view found = bytes_.substr(at_, size);
  at_ += size;
  return found;
}

void Scanner::fail(std::string_view expected, std::string_view found) const {
  fail_in_line(fmt::format("expected {}, found {}", expected, shown(found)));
}

void Scanner::fail_at_byte(std::string_view message) const {
  throw InputError(fmt::format("{}: byte {}: {}", *path_, at_, message));
}

void Scanner::fail_in_line(std::string_view message) const {
  throw InputError(fmt::format("{}:{}: {}", *path_, line(), message));
}

bool parse_real(std::string_view text, double& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return true;
  if (error == std::errc::invalid_argument) return false;
  // Handle overflow and underflow, for which from_chars gives no value, and Fortran's D exponents.
  std::string plain(text);
  for (char& c : plain)
    if (c == 'd' || c == 'D') c = 'e';
  const auto again = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (again.ptr != plain.data() + plain.size()) return false;
  // A point is the decimal separator, whatever locale the process has set.
  static const locale_t decimal_point = ::newlocale(LC_ALL_MASK, "C", nullptr);
  if (again.ec == std::errc::result_out_of_range) value = ::strtod_l(plain.c_str(), nullptr, decimal_point);
  return true;
}

bool parse_integer(std::string_view text, std::int64_t& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace tetproof
