// SPDX-License-Identifier: GPL-3.0-or-later
// Damage to numbers, in text and in binary: counts, indices, coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <limits>

#include "corpus/readers/damage.hpp"

namespace tetproof::corpus {
namespace {

using Done = std::optional<std::string>;

struct Token {
  std::size_t at, size;
  bool whole;           // no point, no exponent
  std::size_t in_line;  // the number of numbers in its line
};

bool is_number_byte(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+' || c == 'e' ||
         c == 'E';
}

// The numbers that stand alone between blanks or quotes.
std::vector<Token> numbers(const std::string& bytes) {
  std::vector<Token> all;
  std::size_t line = 0;  // the first token of the present line
  const auto end_line = [&] {
    for (std::size_t k = line; k < all.size(); ++k) all[k].in_line = all.size() - line;
    line = all.size();
  };
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == '\n') end_line();
    if (!is_number_byte(bytes[i]) || (i > 0 && !std::isspace(static_cast<unsigned char>(bytes[i - 1])) &&
                                      bytes[i - 1] != '"' && bytes[i - 1] != '>'))
      continue;
    std::size_t end = i;
    bool digits = false, whole = true;
    for (; end < bytes.size() && is_number_byte(bytes[end]); ++end) {
      digits = digits || std::isdigit(static_cast<unsigned char>(bytes[end]));
      whole = whole && (std::isdigit(static_cast<unsigned char>(bytes[end])) || end == i);
    }
    const bool alone = end == bytes.size() || std::isspace(static_cast<unsigned char>(bytes[end])) ||
                       bytes[end] == '"' || bytes[end] == '<';
    if (digits && alone) all.push_back({i, end - i, whole, 0});
    i = end - 1;
    if (end < bytes.size() && bytes[end] == '\n') continue;
  }
  end_line();
  return all;
}

// Replaces one of the numbers for which `fits`.
template <class Fits>
Done replace_number(std::string& bytes, Random& random, const std::string& by, const Fits& fits) {
  std::vector<Token> all = numbers(bytes);
  std::erase_if(all, [&](const Token& token) { return !fits(token); });
  if (all.empty()) return std::nullopt;
  const Token token = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
  const std::string before = bytes.substr(token.at, token.size);
  if (before == by) return std::nullopt;
  bytes.replace(token.at, token.size, by);
  return fmt::format("the number {} at byte {} became {}", before, token.at, by);
}

// Replaces the bytes of a number of 4 or 8 bytes, in either byte order.
Done replace_binary(std::string& bytes, Random& random, std::uint64_t bits, std::size_t size) {
  if (bytes.size() < size) return std::nullopt;
  const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size() - size + 1)));
  const bool big = random.below(4) == 0;
  for (std::size_t k = 0; k < size; ++k)
    bytes[at + k] = static_cast<char>(bits >> 8 * (big ? size - 1 - k : k));
  return fmt::format("bytes {} to {} became the {} number 0x{:0{}x}", at, at + size - 1,
                     big ? "big-endian" : "little-endian", bits & (~std::uint64_t{0} >> (64 - 8 * size)),
                     2 * size);
}

bool looks_binary(const std::string& bytes) {
  return std::any_of(bytes.begin(), bytes.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return (u < ' ' && c != '\n' && c != '\r' && c != '\t') || u >= 0x7f;
  });
}

// Counts stand in lines of few numbers, or in binary.
bool is_count(const Token& token) {
  return token.whole && token.in_line <= 4;
}

template <std::size_t n, std::size_t m>
Done count_becomes(std::string& bytes, Random& random, const std::array<const char*, n>& words,
                   const std::array<std::uint64_t, m>& bits) {
  if (looks_binary(bytes) && random.below(3) > 0)
    return replace_binary(bytes, random, bits[static_cast<std::size_t>(random.below(m))],
                          random.below(2) ? 4 : 8);
  return replace_number(bytes, random, words[static_cast<std::size_t>(random.below(n))], is_count);
}

Done huge_count(std::string& bytes, Random& random) {
  return count_becomes(
      bytes, random,
      std::array{"1000000", "100000000", "2147483647", "2147483648", "4294967295", "99999999999",
                 "9223372036854775807", "18446744073709551615", "99999999999999999999999999"},
      std::array<std::uint64_t, 6>{0x7fffffff, 0x10000000, 0x00ffffff, 0x7fffffffffffffff, 0x4000000000000000,
                                   0x0000000100000000});
}

Done negative_count(std::string& bytes, Random& random) {
  return count_becomes(
      bytes, random, std::array{"-1", "-2", "-1000", "-2147483648", "-9223372036854775808"},
      std::array<std::uint64_t, 4>{0xffffffffffffffff, 0x80000000, 0x8000000000000000, 0xfffffffffffffffe});
}

Done wrong_count(std::string& bytes, Random& random) {
  return count_becomes(bytes, random, std::array{"0", "1", "2", "3", "5", "7", "100"},
                       std::array<std::uint64_t, 5>{0, 1, 2, 7, 255});
}

Done index_out_of_range(std::string& bytes, Random& random) {
  constexpr std::array words{"0", "-1", "-7", "1000", "123456789", "2147483647", "4294967297"};
  constexpr std::array<std::uint64_t, 4> bits{1000, 0x7fffffff, 0xffffffff, 123456789};
  if (looks_binary(bytes) && random.below(3) > 0)
    return replace_binary(bytes, random, bits[static_cast<std::size_t>(random.below(4))], 4);
  return replace_number(bytes, random, words[static_cast<std::size_t>(random.below(words.size()))],
                        [](const Token& token) { return token.whole && token.in_line >= 3; });
}

Done not_finite(std::string& bytes, Random& random) {
  constexpr std::array words{"nan",    "-nan",   "NaN",   "inf",    "-inf", "1e999",
                             "-1e999", "1e-999", "0x1p3", "1.#IND", "1,5"};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  if (looks_binary(bytes) && random.below(3) > 0)
    return replace_binary(bytes, random, std::bit_cast<std::uint64_t>(random.below(2) ? nan : -inf), 8);
  return replace_number(bytes, random, words[static_cast<std::size_t>(random.below(words.size()))],
                        [](const Token&) { return true; });
}

Done wordy_number(std::string& bytes, Random& random) {
  const std::array<std::string, 4> words{"", "abc", "12abc", std::string(4000, '9')};
  return replace_number(bytes, random, words[static_cast<std::size_t>(random.below(4))],
                        [](const Token&) { return true; });
}

}  // namespace

std::vector<DamageKind> damage_to_numbers() {
  return {{"huge-count", "a count became huge", huge_count},
          {"negative-count", "a count became negative", negative_count},
          {"wrong-count", "a count became another, small one", wrong_count},
          {"index-range", "an index became one that nothing has", index_out_of_range},
          {"not-finite", "a number became NaN, infinity, or none", not_finite},
          {"no-number", "a number is missing, a word, or has 4000 digits", wordy_number}};
}

}  // namespace tetproof::corpus
