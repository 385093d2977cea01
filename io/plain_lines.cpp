// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/plain_lines.hpp"

#include <algorithm>

namespace tetproof::io {

std::optional<std::vector<LinePiece>> cut_lines(std::string_view text, std::size_t offset,
                                                std::size_t count) {
  constexpr std::size_t piece_size = std::size_t{1} << 17;
  // So much of the text at a time that a few long lines do not have all of it counted.
  const std::size_t wave = std::clamp<std::size_t>(count / 4096, 8, 1024);  // pieces
  std::vector<LinePiece> pieces;
  std::size_t found = 0;
  for (std::size_t start = offset; found < count && start < text.size(); start += wave * piece_size) {
    // A line begins at the offset and behind every line feed.
    const std::size_t here = std::min(wave, (text.size() - start + piece_size - 1) / piece_size);
    std::vector<LinePiece> wave_pieces(here);
    tbb::parallel_for(std::size_t{0}, here, [&](std::size_t p) {
      const std::size_t from = start + p * piece_size, to = std::min(from + piece_size, text.size());
      LinePiece& piece = wave_pieces[p];
      piece.offset = from;
      if (from != offset) {
        const std::size_t feed = text.substr(from - 1, to - from).find('\n');
        if (feed == std::string_view::npos) return;
        piece.offset = from + feed;
      }
      piece.count =
          1 + static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(piece.offset),
                                                  text.begin() + static_cast<std::ptrdiff_t>(to) - 1, '\n'));
    });
    for (LinePiece& piece : wave_pieces) {
      if (piece.count == 0) continue;
      piece.first = found;
      piece.count = std::min(piece.count, count - found);
      found += piece.count;
      pieces.push_back(piece);
      if (found == count) return pieces;
    }
  }
  return std::nullopt;
}

}  // namespace tetproof::io
