// SPDX-License-Identifier: GPL-3.0-or-later
// Unpacks the blocks of compressed arrays in VTK's XML files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tetproof::io {

enum class VtuPacking { none, zlib, lz4, lzma };

/// The packing that VTK calls `compressor`. `known` becomes false if there is no such one.
VtuPacking packing_of(std::string_view compressor, bool& known);
/// "zlib", "LZ4", "LZMA".
const char* name_of(VtuPacking packing);

/// How many times as large as a packed block its content can be. A block that claims more is not unpacked, so
/// that a small file cannot ask for much memory.
std::uint64_t most_times_larger(VtuPacking packing);

/// Unpacks a block of `size` bytes into `block`. Returns what was found instead; empty: just that.
std::string unpack(VtuPacking packing, std::string_view packed, std::uint64_t size, std::string& block);

}  // namespace tetproof::io
