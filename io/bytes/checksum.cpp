// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/checksum.hpp"

#include <zlib.h>

#include <vector>

#include "io/bytes/plain_records.hpp"

namespace tetproof::io {

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

std::uint32_t crc32_joined(std::uint32_t of_first, std::uint32_t of_more, std::size_t more) {
  return static_cast<std::uint32_t>(::crc32_combine(of_first, of_more, static_cast<z_off_t>(more)));
}

std::uint32_t crc32_of(const Source& bytes, std::size_t size) {
  constexpr std::size_t block = std::size_t{1} << 16;
  const std::size_t whole = size / block;
  std::vector<std::uint32_t> blocks(whole);
  read_records(bytes, 0, block, whole, [&](const char* text, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      blocks[first + i] = crc32_of(std::string_view(text + i * block, block));
  });
  std::uint32_t all = 0;
  for (const std::uint32_t one : blocks) all = crc32_joined(all, one, block);
  const std::string_view rest = bytes.bytes.substr(whole * block, size - whole * block);
  return crc32_joined(all, crc32_of(rest), rest.size());
}

}  // namespace tetproof::io
