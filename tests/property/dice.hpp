// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine. The standard defines the engine but not the
// distributions.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <string>

namespace tetproof::test {

class Dice {
 public:
  Dice(std::uint64_t seed, int feature)
      : random_(seed * 1000003 + static_cast<std::uint64_t>(feature) * 0x9e3779b97f4a7c15u) {}

  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(n));
  }
  std::size_t index(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  bool chance(int one_in) { return below(one_in) == 0; }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  /// Any double except NaN; the unusual ones are frequent.
  double wild() {
    static constexpr double strange[] = {0.0,
                                         -0.0,
                                         5e-324,
                                         -2.2250738585072009e-308,
                                         1.7976931348623157e308,
                                         0.1,
                                         0.30000000000000004,
                                         1e22,
                                         9007199254740993.0,
                                         std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity()};
    if (chance(2)) return strange[index(std::size(strange))];
    const double any = std::bit_cast<double>(random_());
    return std::isnan(any) ? 0.5 : any;
  }
  /// Any double, NaN included.
  double any_real() { return chance(9) ? std::numeric_limits<double>::quiet_NaN() : wild(); }

  /// A name that differs from those with another `k`.
  std::string name(int k, bool odd) {
    static const char* const strange[] = {
        "two words", "a \"quoted\" one", "it's",        "<b> & \"c\"", "#hash",
        "$EndNodes", "back\\slash",      " blanks ",    "tab\tin it",  "caf\xc3\xa9",
        "100%",      "comma,semi;",      "{\"json\"}]", "-->",         "]]>"};
    return odd ? strange[index(std::size(strange))] + std::to_string(k)
               : std::string(1, static_cast<char>('a' + k));
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace tetproof::test
