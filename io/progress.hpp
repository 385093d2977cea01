// SPDX-License-Identifier: GPL-3.0-or-later
// How far a long computation is, for whoever waits for it.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace tetproof {

/// Gets the name of a stage when it begins, with 0 and 0; and while the stage lasts, where this is known, how
/// many of its parts are done and how many there are. The total is 0 if it is not known. It must return soon
/// and must not throw; several threads may call it at once.
using ProgressListener = std::function<void(std::string_view stage, std::uint64_t done, std::uint64_t total)>;

}  // namespace tetproof
