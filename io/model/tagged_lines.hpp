// SPDX-License-Identifier: GPL-3.0-or-later
// Reads long runs of lines that begin with a tag, by several threads.
#pragma once

#include "io/bytes/plain_lines.hpp"
#include "io/model/node_index.hpp"

namespace tetproof::io {

/// Like `read_plain_lines`, for lines that begin with a tag. The tag of line i becomes the one at `position`
/// + i of `tags`. If a line is not plain, no tag is added.
template <class Read>
std::optional<std::size_t> read_tagged_lines(const Source& text, std::size_t offset, std::size_t count,
                                             Tags& tags, std::size_t position, const Read& read) {
  if (count < least_plain_lines) return std::nullopt;
  std::vector<std::int64_t> of_wave;
  std::size_t first = 0;
  LineReader reader;
  reader.begin = [&](const std::vector<LinePiece>& wave) {
    first = wave.front().first;
    of_wave.resize(wave.back().first + wave.back().count - first);
  };
  reader.read = [&](const LinePiece& piece) -> const char* {
    PlainLine line(piece.text.data(), piece.text.data() + piece.text.size());
    for (std::size_t i = piece.first; i < piece.first + piece.count; ++i)
      if (!line.integer(of_wave[i - first]) || !read(line, i) || !line.end()) return nullptr;
    return line.place();
  };
  reader.end = [&](const std::vector<LinePiece>&) {
    tags.add(position + first, of_wave);
    return true;
  };
  const auto behind = read_lines(text, offset, count, reader);
  if (!behind) tags.cut(position);
  return behind;
}

}  // namespace tetproof::io
