// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: vtkZLibDataCompressor, vtkLZ4DataCompressor (a block of LZ4 without a frame) and
// vtkLZMADataCompressor (an .xz stream) of VTK 9.1.
#include "io/vtk/vtu_unpack.hpp"

#include <fmt/format.h>
#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace tetproof::io {
namespace {

constexpr const char* other_data = "other data";

std::string how_many(std::uint64_t size, std::uint64_t found) {
  return found == size ? "" : fmt::format("{}", found);
}

std::string unpack_zlib(std::string_view packed, std::uint64_t size, std::string& block) {
  block.resize(size);
  auto got = static_cast<uLongf>(size);
  const int state =
      ::uncompress(reinterpret_cast<Bytef*>(block.data()), &got,
                   reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  return state == Z_OK ? how_many(size, got) : other_data;
}

std::string unpack_lz4(std::string_view packed, std::uint64_t size, std::string& block) {
  constexpr std::uint64_t most = LZ4_MAX_INPUT_SIZE;
  if (size > most || packed.size() > most) return fmt::format("more than the {} that LZ4 packs", most);
  block.resize(size);
  const int got = ::LZ4_decompress_safe(packed.data(), block.data(), static_cast<int>(packed.size()),
                                        static_cast<int>(size));
  return got < 0 ? other_data : how_many(size, static_cast<std::uint64_t>(got));
}

// LZMA can make very much of very little, so the memory grows only with what comes out.
std::string unpack_lzma(std::string_view packed, std::uint64_t size, std::string& block) {
  constexpr std::uint64_t memory = std::uint64_t{256} << 20, step = std::uint64_t{1} << 20;
  lzma_stream stream = LZMA_STREAM_INIT;
  if (::lzma_stream_decoder(&stream, memory, 0) != LZMA_OK) return "no memory for it";
  const std::unique_ptr<lzma_stream, void (*)(lzma_stream*)> end(&stream, ::lzma_end);
  stream.next_in = reinterpret_cast<const std::uint8_t*>(packed.data());
  stream.avail_in = packed.size();
  block.clear();
  lzma_ret state = LZMA_OK;
  // One byte more than there should be, so that a longer stream is noticed.
  while (state == LZMA_OK && block.size() <= size) {
    const std::size_t before = block.size();
    block.resize(std::min(size + 1, before + std::max<std::uint64_t>(step, before)));
    stream.next_out = reinterpret_cast<std::uint8_t*>(block.data()) + before;
    stream.avail_out = block.size() - before;
    while (state == LZMA_OK && stream.avail_out > 0) state = ::lzma_code(&stream, LZMA_FINISH);
    block.resize(block.size() - stream.avail_out);
  }
  return state == LZMA_STREAM_END ? how_many(size, block.size()) : other_data;
}

}  // namespace

VtuPacking packing_of(std::string_view compressor, bool& known) {
  known = true;
  if (compressor.empty()) return VtuPacking::none;
  if (compressor == "vtkZLibDataCompressor") return VtuPacking::zlib;
  if (compressor == "vtkLZ4DataCompressor") return VtuPacking::lz4;
  if (compressor == "vtkLZMADataCompressor") return VtuPacking::lzma;
  known = false;
  return VtuPacking::none;
}

const char* name_of(VtuPacking packing) {
  switch (packing) {
    case VtuPacking::zlib:
      return "zlib";
    case VtuPacking::lz4:
      return "LZ4";
    case VtuPacking::lzma:
      return "LZMA";
    default:
      return "nothing";
  }
}

std::uint64_t most_times_larger(VtuPacking packing) {
  // zlib's limit is 1032, LZ4's 255. xz makes zeros 7,000 times smaller.
  return packing == VtuPacking::lz4 ? 255 : packing == VtuPacking::lzma ? 16384 : 1032;
}

std::string unpack(VtuPacking packing, std::string_view packed, std::uint64_t size, std::string& block) {
  if (packing == VtuPacking::lz4) return unpack_lz4(packed, size, block);
  if (packing == VtuPacking::lzma) return unpack_lzma(packed, size, block);
  return unpack_zlib(packed, size, block);
}

}  // namespace tetproof::io
