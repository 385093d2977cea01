// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/decimals.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "io/bytes/scanner.hpp"

namespace tetproof::corpus {
namespace {

// The text of std::to_chars, which the standard defines digit by digit.
template <class... Format>
std::string text_of(double x, Format... format) {
  std::array<char, 400> buffer;
  return std::string(buffer.data(),
                     std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, format...).ptr);
}

double number_of(std::string_view text) {
  double value = 0;
  parse_real(text, value);
  return value;
}

}  // namespace

double to_significant_digits(double x, int digits) {
  return std::isfinite(x) ? number_of(text_of(x, std::chars_format::scientific, digits - 1)) : x;
}

double to_decimal_places(double x, int places) {
  return std::isfinite(x) ? number_of(text_of(x, std::chars_format::fixed, places)) : x;
}

Decimal shortest_decimal(double x) {
  Decimal result;
  result.negative = x < 0;
  if (x == 0) return result;
  const std::string text = text_of(std::abs(x), std::chars_format::scientific);  // "1.25e-07"
  const std::size_t e = text.find('e');
  const char* exponent = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
  std::from_chars(exponent, text.data() + text.size(), result.exponent);
  for (const char c : text.substr(0, e))
    if (c != '.') result.digits += c;
  while (result.digits.back() == '0') result.digits.pop_back();
  return result;
}

double Decimal::value() const {
  if (digits.empty()) return 0;
  return number_of(fmt::format("{}{}.{}0e{}", negative ? "-" : "", digits[0], digits.substr(1), exponent));
}

}  // namespace tetproof::corpus
