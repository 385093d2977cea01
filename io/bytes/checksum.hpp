// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-32 as zlib has it, by several threads.
#pragma once

#include <cstdint>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

std::uint32_t crc32_of(std::string_view bytes);
/// Of the first `size` bytes.
std::uint32_t crc32_of(const Source& bytes, std::size_t size);
/// That of some bytes and `more` of them behind these, from those of both.
std::uint32_t crc32_joined(std::uint32_t of_first, std::uint32_t of_more, std::size_t more);

}  // namespace tetproof::io
