// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles rounded to short decimal numbers, ties to even, with the same bits on every machine: as text and
// back, both correctly rounded. Internal.
#pragma once

#include <string>

namespace tetproof::corpus {

double to_significant_digits(double x, int digits);
double to_decimal_places(double x, int places);

/// A finite double as the shortest decimal number that gives it back.
struct Decimal {
  std::string digits;  ///< no zeros at the end; empty for 0
  int exponent = 0;    ///< of the power of ten of the first digit
  bool negative = false;

  double value() const;
};
Decimal shortest_decimal(double x);

}  // namespace tetproof::corpus
