// SPDX-License-Identifier: GPL-3.0-or-later
// zlib's CRC-32, computed by several threads.
#pragma once

#include <cstdint>
#include <string_view>

#include "io/bytes/input_file.hpp"

namespace tetproof::io {

std::uint32_t crc32_of(std::string_view bytes);
/// The checksum of the first `size` bytes.
std::uint32_t crc32_of(const Source& bytes, std::size_t size);
/// The checksum of some bytes followed by `more` bytes, from the checksums of both parts.
std::uint32_t crc32_joined(std::uint32_t of_first, std::uint32_t of_more, std::size_t more);

}  // namespace tetproof::io
