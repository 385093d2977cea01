// SPDX-License-Identifier: GPL-3.0-or-later
// The one exception for what a user can mend: a bad file, a bad surface, a bad option.
#pragma once

#include <stdexcept>
#include <string>

namespace tetproof {

/// Bad input. `what()` is one line that tells the reader what to do: place, what was expected, what was found,
/// as in "bunny.stl:1204: facet has 2 vertices, expected 3". Programs print it and exit 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tetproof
