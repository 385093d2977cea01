// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a damaged file still says the same. Not installed.
#pragma once

#include <string>

#include "io/document.hpp"

namespace tetproof::corpus {

/// Whether our own reader takes the file, and finds the same points, elements, tags and values as in
/// `before`. Names and comments do not count.
bool same_content(const std::string& path, const Document& before);

}  // namespace tetproof::corpus
