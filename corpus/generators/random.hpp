// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine. The C++ standard fixes the engine but not the
// distributions, so the distributions are our own.
#pragma once

#include <cstdint>
#include <random>

namespace tetproof::corpus {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< [0, 1)
  double between(double low, double high) { return low + (high - low) * unit(); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }  ///< 0 .. n-1

 private:
  std::mt19937_64 engine_;
};

}  // namespace tetproof::corpus
