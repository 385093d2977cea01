// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/shrink_file.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace tetproof::corpus {
namespace {

using Pieces = std::vector<std::string>;

std::string joined(const Pieces& pieces) {
  std::string bytes;
  for (const std::string& piece : pieces) bytes += piece;
  return bytes;
}

Pieces lines_of(const std::string& bytes) {
  Pieces lines(1);
  for (const char c : bytes) {
    lines.back() += c;
    if (c == '\n') lines.emplace_back();
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

Pieces bytes_of(const std::string& bytes) {
  Pieces pieces;
  for (const char c : bytes) pieces.emplace_back(1, c);
  return pieces;
}

// Leaves out runs of pieces, half of all at first, single ones at last. Returns whether anything went.
bool leave_out(Pieces& pieces, const std::function<bool(const std::string&)>& fails,
               const std::function<bool()>& over) {
  const std::size_t before = pieces.size();
  for (std::size_t size = std::max<std::size_t>(1, pieces.size() / 2);; size /= 2) {
    for (std::size_t at = 0; at < pieces.size() && !over();) {
      const std::size_t end = std::min(pieces.size(), at + size);
      Pieces fewer(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(at));
      fewer.insert(fewer.end(), pieces.begin() + static_cast<std::ptrdiff_t>(end), pieces.end());
      if (fails(joined(fewer)))
        pieces = std::move(fewer);
      else
        at = end;
    }
    if (size <= 1 || over()) return pieces.size() < before;
  }
}

}  // namespace

std::string shrink_file(std::string bytes, const std::function<bool(const std::string&)>& fails,
                        double seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto over = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds;
  };
  for (const auto& split : {lines_of, bytes_of})
    for (bool again = true; again && !over();) {
      Pieces pieces = split(bytes);
      again = leave_out(pieces, fails, over);
      bytes = joined(pieces);
    }
  return bytes;
}

}  // namespace tetproof::corpus
