// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one case again, and shows what the judge says of each run. Not installed.
#pragma once

#include "corpus/program/fuzz_options.hpp"
#include "io/program/program.hpp"

namespace tetproof::corpus {

/// Finds what `a.replay` names, runs it and prints; returns the exit code. InputError if there is no such
/// case.
int replay(const FuzzArguments& a, const program::Common& common);

}  // namespace tetproof::corpus
