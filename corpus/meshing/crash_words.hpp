// SPDX-License-Identifier: GPL-3.0-or-later
// What programs and their libraries print when they crash.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tetproof::corpus {

/// A crash as the output tells it.
struct CrashWords {
  std::string signature;
  std::string message;           ///< the line
  bool needs_signal = true;      ///< it is a crash only if the program did not go on to a success
  bool wants_backtrace = false;  ///< the words do not say where
};

/// Assertions of the C library, of libstdc++ and of CGAL, exceptions that nobody caught, the heap's checks,
/// reports of sanitizers, and the crash handlers of meshers. An exception of type int is none: it is how
/// TetGen's library gives up.
std::optional<CrashWords> crash_words(const std::vector<std::string>& lines);

/// "f" of "int N::A::f(B, C) const [with T = D]", as assertions and compilers write functions.
std::string function_name(const std::string& declaration);

}  // namespace tetproof::corpus
