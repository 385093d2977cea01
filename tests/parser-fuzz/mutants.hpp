// SPDX-License-Identifier: GPL-3.0-or-later
// Broken copies of a good file: cut off, bytes changed, counts made huge.
#pragma once

#include <cstdint>
#include <string>

namespace tetproof::test {

/// Mutant number `index` of `sample`: the same for the same three arguments, on every machine.
std::string mutant(const std::string& sample, std::uint64_t seed, int index);

}  // namespace tetproof::test
