// SPDX-License-Identifier: GPL-3.0-or-later
// Variables that make a program write its output line by line.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// "NAME=value" of what `stdbuf -oL -eL` would set, in addition to `environment`. Empty: there is no stdbuf.
std::vector<std::string> line_buffering(const std::vector<std::string>& environment);

}  // namespace tetproof::corpus
