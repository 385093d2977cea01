// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of tetproof-compare. Not installed.
#pragma once

#include <optional>
#include <string>

#include "io/document.hpp"
#include "verify/compare_grids.hpp"

namespace tetproof::verify {

/// Whether the file is a trace: decided by the ending, or else by the first character. Of a pipe and standard
/// input nothing is known before they are read.
std::optional<bool> is_trace(const std::string& path);

/// The grid in a document that was read from `path`, and what of it a comparison of tetrahedra leaves out.
/// InputError if there are no tetrahedra.
NamedGrid named_grid(const std::string& path, const Document& document);

}  // namespace tetproof::verify
