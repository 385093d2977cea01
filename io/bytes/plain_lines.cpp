// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/plain_lines.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

#include "io/bytes/large_pages.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 16;

struct Wave {
  std::vector<LinePiece> pieces{};
  std::string_view text;  // the part of the source that is in memory
};

// The number of bytes that holds about the wanted lines, but no more than `most`.
std::size_t wave_size(std::size_t lines, double bytes_each, std::size_t most) {
  const double wanted = static_cast<double>(lines) * bytes_each;
  return wanted < static_cast<double>(most)
             ? std::min(most, (static_cast<std::size_t>(wanted) / piece_size + 1) * piece_size)
             : most;
}

// Cuts the wave's text into pieces of whole lines, at most `count` lines. With `to_end` the last line may
// lack its line feed.
void cut(Wave& wave, std::size_t first, std::size_t count, bool to_end,
         const std::function<void(std::size_t, std::size_t)>& load) {
  const std::string_view text = wave.text;
  const std::size_t pieces = (text.size() + piece_size - 1) / piece_size;
  std::vector<std::size_t> feeds(pieces);
  tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t p) {
    const std::size_t from = p * piece_size;
    const std::string_view piece = text.substr(from, piece_size);
    load(from, piece.size());
    feeds[p] = static_cast<std::size_t>(std::count(piece.begin(), piece.end(), '\n'));
  });
  wave.pieces.clear();
  std::size_t begin = 0;  // where the first line that ends in the piece begins
  for (std::size_t p = 0; p < pieces && count > 0; ++p) {
    std::size_t lines = feeds[p];
    const std::string_view piece = text.substr(p * piece_size, piece_size);
    if (p + 1 == pieces && to_end && text.back() != '\n') ++lines;
    if (lines == 0) continue;
    lines = std::min(lines, count);
    wave.pieces.push_back({wave.pieces.size(), first, lines, text.substr(begin)});
    first += lines, count -= lines;
    begin = p * piece_size + piece.rfind('\n') + 1;
  }
}

}  // namespace

std::optional<std::size_t> read_lines(const Source& source, std::size_t offset, std::size_t count,
                                      const LineReader& reader) {
  const std::string_view all = source.bytes;
  const std::size_t most = std::clamp<std::size_t>(
      4 * piece_size * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
      std::size_t{1} << 21, std::size_t{1} << 24);
  std::optional<Scratch> memory;
  double bytes_each = 32;
  Wave wave;
  for (std::size_t done = 0; done < count;) {
    const std::size_t size = std::min(wave_size(count - done, bytes_each, most), all.size() - offset);
    if (size == 0) return std::nullopt;
    wave.text = all.substr(offset, size);
    if (source.file) {
      if (!memory) memory.emplace(most);
      wave.text = {memory->data(), size};
    }
    cut(wave, done, count - done, offset + size == all.size(), [&](std::size_t from, std::size_t bytes) {
      if (source.file) source.file->copy(offset + from, bytes, memory->data() + from);
    });
    if (wave.pieces.empty()) {
      if (size == most || offset + size == all.size()) return std::nullopt;  // a line is too long
      bytes_each *= 8;
      continue;
    }
    reader.begin(wave.pieces);
    std::atomic<bool> plain = true;
    const char* behind = nullptr;
    tbb::parallel_for(std::size_t{0}, wave.pieces.size(), [&](std::size_t p) {
      if (!plain.load(std::memory_order_relaxed)) return;
      const char* const end = reader.read(wave.pieces[p]);
      if (!end) plain = false;
      if (p + 1 == wave.pieces.size()) behind = end;
    });
    if (!plain || !reader.end(wave.pieces)) return std::nullopt;
    const auto used = static_cast<std::size_t>(behind - wave.text.data());
    const std::size_t lines = wave.pieces.back().first + wave.pieces.back().count - done;
    bytes_each = 1.02 * static_cast<double>(used) / static_cast<double>(lines);
    offset += used, done += lines;
  }
  return offset;
}

}  // namespace tetproof::io
