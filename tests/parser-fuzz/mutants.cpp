// SPDX-License-Identifier: GPL-3.0-or-later
#include "mutants.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>
#include <vector>

namespace tetproof::test {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The standard fixes mt19937_64's numbers but not the distributions'.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t n) { return n ? random_() % n : 0; }
  char byte() { return static_cast<char>(random_()); }
  template <class T, std::size_t n>
  T one_of(const std::array<T, n>& from) {
    return from[below(n)];
  }

 private:
  std::mt19937_64 random_;
};

constexpr std::array<std::string_view, 16> hard_numbers{"-1",
                                                        "0",
                                                        "1",
                                                        "7",
                                                        "255",
                                                        "65536",
                                                        "2147483647",
                                                        "2147483648",
                                                        "4294967295",
                                                        "99999999999",
                                                        "9223372036854775807",
                                                        "9223372036854775808",
                                                        "-9223372036854775808",
                                                        "1e308",
                                                        "nan",
                                                        "99999999999999999999999999"};
constexpr std::array<std::uint64_t, 10> hard_bits{
    0xffffffffffffffff, 0x7fffffff,         0x80000000, 0xffffffff, 0x7fffffffffffffff,
    0x8000000000000000, 0x4000000000000000, 0x01000000, 0x00ffffff, 0};

void change_bytes(std::string& text, Dice& dice) {
  for (std::size_t n = 1 + dice.below(4); n > 0 && !text.empty(); --n)
    text[dice.below(text.size())] = dice.byte();
}

void flip_bit(std::string& text, Dice& dice) {
  if (!text.empty()) text[dice.below(text.size())] ^= static_cast<char>(1u << dice.below(8));
}

// A number in the text becomes another one, often far too large.
void change_number(std::string& text, Dice& dice) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (is_digit(text[i]) && (i == 0 || !is_digit(text[i - 1]))) starts.push_back(i);
  if (starts.empty()) return change_bytes(text, dice);
  const std::size_t start = starts[dice.below(starts.size())];
  const std::size_t end = std::find_if_not(text.begin() + start, text.end(), is_digit) - text.begin();
  text.replace(start, end - start, dice.one_of(hard_numbers));
}

// A number in the bytes likewise.
void change_binary_number(std::string& text, Dice& dice) {
  const std::size_t size = std::array<std::size_t, 3>{2, 4, 8}[dice.below(3)];
  if (text.size() < size) return change_bytes(text, dice);
  const std::size_t at = dice.below(text.size() - size + 1);
  const std::uint64_t bits = dice.one_of(hard_bits);
  const bool big = dice.below(2);
  for (std::size_t k = 0; k < size; ++k)
    text[at + k] = static_cast<char>(bits >> 8 * (big ? size - 1 - k : k));
}

// A piece is lost, or comes twice.
void change_piece(std::string& text, Dice& dice) {
  const std::size_t at = dice.below(text.size()), size = std::min(text.size() - at, 1 + dice.below(40));
  if (dice.below(2))
    text.erase(at, size);
  else
    text.insert(at, std::string(text, at, size));
}

void insert_bytes(std::string& text, Dice& dice) {
  std::string bytes(1 + dice.below(8), '\0');
  const bool blanks = dice.below(2);
  for (char& c : bytes)
    c = blanks ? dice.one_of(std::array{' ', '\n', '\r', '\t', '#', '\\', '/', '-'}) : dice.byte();
  text.insert(dice.below(text.size() + 1), bytes);
}

}  // namespace

std::string mutant(const std::string& sample, std::uint64_t seed, int index) {
  Dice dice(seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(index + 1));
  std::string text = sample;
  if (index % 7 == 0) {
    text.resize(dice.below(text.size()));
    return text;
  }
  constexpr std::array<void (*)(std::string&, Dice&), 6> changes{
      change_bytes, flip_bit, change_number, change_binary_number, change_piece, insert_bytes};
  changes[index % 7 - 1](text, dice);
  if (dice.below(4) == 0) changes[dice.below(changes.size())](text, dice);
  return text;
}

}  // namespace tetproof::test
