// SPDX-License-Identifier: GPL-3.0-or-later
// Writes bytes as base64 (RFC 4648), and knows its digits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetproof::io {

inline constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Writes `size` bytes as base64, with padding at the end. Returns where the text ends: at most
/// 4 * ceil(size / 3) characters behind `to`.
char* put_base64(char* to, const unsigned char* from, std::size_t size);

/// The bytes as base64.
std::string base64(std::string_view bytes);

}  // namespace tetproof::io
