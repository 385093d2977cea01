// SPDX-License-Identifier: GPL-3.0-or-later
// Words that surface formats use for physical groups.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tetproof::io {

/// The number of a group that has no name: the word is this number. None if the word is a name.
std::optional<std::int64_t> group_number(std::string_view word);

}  // namespace tetproof::io
