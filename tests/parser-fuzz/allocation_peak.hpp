// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory C++ code holds: the test program's operator new and delete keep count.
#pragma once

#include <cstddef>

namespace tetproof::test {

/// Bytes that are allocated now.
std::size_t allocated();
/// The largest value of `allocated` since the last call of `start_peak`.
std::size_t peak_allocated();
void start_peak();

}  // namespace tetproof::test
