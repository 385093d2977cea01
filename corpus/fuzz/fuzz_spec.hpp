// SPDX-License-Identifier: GPL-3.0-or-later
// Random surfaces by name: "fuzz:seed=7,case=12" and "fuzz:RECIPE". Internal.
#pragma once

#include <string>

#include "corpus/fuzz_surface.hpp"

namespace tetproof::corpus {

/// True if `spec` is "fuzz" or begins with "fuzz:".
bool is_fuzz_spec(const std::string& spec);

/// The surface of such a specification. The seed is 1 and the case is 0 where they are not given. InputError,
/// one line that begins with the specification.
FuzzSurface fuzz_surface_of(const std::string& spec);

}  // namespace tetproof::corpus
