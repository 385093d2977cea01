// SPDX-License-Identifier: GPL-3.0-or-later
// Puts counts into words, for messages.
#pragma once

#include <fmt/core.h>

#include <concepts>
#include <string>
#include <string_view>

namespace tetproof::io {

/// The singular of words of which one is a plural: "boundary face" of "boundary faces", "cell of type 42" of
/// "cells of type 42". The first plural is meant; words in capitals, numbers and all behind them stay as they
/// are, and so do words without a plural: "check overlap".
std::string singular(std::string_view many);

/// "1 hexahedron", "8 hexahedra".
std::string counted(std::integral auto n, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? singular(many) : std::string(many));
}

}  // namespace tetproof::io
