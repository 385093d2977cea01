// SPDX-License-Identifier: GPL-3.0-or-later
// The exception for everything that a user can correct: a bad file, a bad surface, a bad option.
#pragma once

#include <stdexcept>
#include <string>

namespace tetproof {

/// Bad input. `what()` is one line that tells the user what to do: the place, what was expected and what was
/// found, as in "bunny.stl:1204: facet has 2 vertices, expected 3". Programs print it and exit 2. Control
/// characters, which names from files may hold, are shown as "\x1B" and the like.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& message);
};

}  // namespace tetproof
