// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of nodes or elements of two documents that are joined.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The numbers of one document.
struct NumbersOf {
  std::vector<std::int64_t> numbers;
  bool of_file = false;  ///< the file says them; else the reader counted

  static NumbersOf nodes(const Document& document);
  static NumbersOf elements(const Document& document);
};

struct JointNumbers {
  std::vector<std::int64_t> tags;  ///< as in a document: empty if they count up from `first`
  std::int64_t first = 1;
  bool of_files = false;
  bool all_move = false, more_move = false;  ///< numbers of the first (second) document are others now
};

/// Numbers of files stay where they do not meet; else those of the second file move up by one step. Numbers
/// that a reader counted come behind those of a file, and behind counted ones go on. If sums might overflow,
/// all are numbered from 1.
JointNumbers join_numbers(NumbersOf all, NumbersOf more);

}  // namespace tetproof::io
