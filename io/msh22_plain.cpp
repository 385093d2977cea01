// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh22_plain.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "io/plain_lines.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t most_tags = 16;

class PieceReader {
 public:
  PieceReader(const NodeIndex& index, PlainElements22::Piece& piece) : index_(index), piece_(piece) {}

  bool read(PlainLine& line) {
    std::int64_t tag, number, count;
    if (!line.integer(tag) || !line.integer(number) || !line.integer(count)) return false;
    if (count < 0 || count > static_cast<std::int64_t>(most_tags)) return false;
    for (std::int64_t k = 0; k < count; ++k)
      if (!line.integer(tags_[static_cast<std::size_t>(k)])) return false;
    if (!piece_.runs.empty() && number == number_) {
      const auto& last = piece_.runs.back().tags;
      if (!std::equal(last.begin(), last.end(), tags_.begin(), tags_.begin() + count)) start_run(count);
    } else {
      type_ = number < 0 || number > 1000 ? nullptr : element_type(static_cast<int>(number));
      if (!type_) return false;
      number_ = number;
      start_run(count);
    }
    const std::size_t each = static_cast<std::size_t>(type_->nodes), start = piece_.nodes.size();
    for (std::size_t k = 0; k < each; ++k) {
      std::int64_t node;
      if (!line.integer(node)) return false;
      const Index place = index_.known(node);
      if (place < 0) return false;
      piece_.nodes.push_back(place);
    }
    if (start >= each &&
        std::equal(piece_.nodes.begin() + static_cast<std::ptrdiff_t>(start), piece_.nodes.end(),
                   piece_.nodes.begin() + static_cast<std::ptrdiff_t>(start - each)))
      return false;
    piece_.tags.push_back(tag);
    ++piece_.runs.back().count;
    return line.end();
  }

 private:
  void start_run(std::int64_t tags) {
    piece_.runs.push_back({type_, {tags_.begin(), tags_.begin() + tags}, 0});
  }

  const NodeIndex& index_;
  PlainElements22::Piece& piece_;
  std::array<std::int64_t, most_tags> tags_{};
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;
};

// Whether the first element of a piece has the nodes of the last one before it.
bool repeats(const PlainElements22::Piece& before, const PlainElements22::Piece& piece) {
  const auto each = static_cast<std::size_t>(piece.runs.front().type->nodes);
  return before.nodes.size() >= each &&
         std::equal(piece.nodes.begin(), piece.nodes.begin() + static_cast<std::ptrdiff_t>(each),
                    before.nodes.end() - static_cast<std::ptrdiff_t>(each));
}

}  // namespace

std::optional<PlainElements22> read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index) {
  if (in.binary() || count < least_plain_lines) return std::nullopt;
  in.skip_blanks();
  const std::string_view text = in.text();
  const auto cut = cut_lines(text, in.offset(), count);
  if (!cut) return std::nullopt;
  PlainElements22 read;
  read.pieces.resize(cut->size());
  std::atomic<bool> plain = true;
  tbb::parallel_for(std::size_t{0}, cut->size(), [&](std::size_t p) {
    PlainLine line(text.data() + (*cut)[p].offset, text.data() + text.size());
    PlainElements22::Piece& piece = read.pieces[p];
    PieceReader reader(index, piece);
    piece.tags.reserve((*cut)[p].count);
    piece.nodes.reserve(4 * (*cut)[p].count);
    for (std::size_t i = 0; i < (*cut)[p].count; ++i)
      if (!plain.load(std::memory_order_relaxed) || !reader.read(line)) {
        plain = false;
        return;
      }
    if (p + 1 == cut->size()) read.behind = static_cast<std::size_t>(line.place() - text.data());
  });
  if (!plain) return std::nullopt;
  for (std::size_t p = 1; p < read.pieces.size(); ++p)
    if (repeats(read.pieces[p - 1], read.pieces[p])) return std::nullopt;
  return read;
}

}  // namespace tetproof::io
