// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh22_plain.hpp"

#include <algorithm>
#include <array>

#include "io/plain_lines.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t most_tags = 16;

class PieceReader {
 public:
  PieceReader(const NodeIndex& index, PlainElements22& piece) : index_(index), piece_(piece) {}

  bool read(PlainLine& line) {
    std::int64_t tag, number, count;
    if (!line.integer(tag) || !line.integer(number) || !line.integer(count)) return false;
    if (count < 0 || count > static_cast<std::int64_t>(most_tags)) return false;
    for (std::int64_t k = 0; k < count; ++k)
      if (!line.integer(tags_[static_cast<std::size_t>(k)])) return false;
    if (!piece_.runs.empty() && number == number_) {
      if (!has_last_tags(count)) start_run(count);
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
    if (start >= each && repeats_before(start, each)) return false;
    piece_.tags.push_back(tag);
    ++piece_.runs.back().count;
    return line.end();
  }

 private:
  // Both by hand, since they compare a few numbers.
  bool has_last_tags(std::int64_t count) const {
    const std::vector<std::int64_t>& last = piece_.runs.back().tags;
    if (last.size() != static_cast<std::size_t>(count)) return false;
    for (std::size_t k = 0; k < last.size(); ++k)
      if (last[k] != tags_[k]) return false;
    return true;
  }
  bool repeats_before(std::size_t start, std::size_t each) const {
    const Index* const nodes = piece_.nodes.data() + start;
    for (std::size_t k = 0; k < each; ++k)
      if (nodes[k] != (nodes - each)[k]) return false;
    return true;
  }

  void start_run(std::int64_t tags) {
    piece_.runs.push_back({type_, {tags_.begin(), tags_.begin() + tags}, 0});
  }

  const NodeIndex& index_;
  PlainElements22& piece_;
  std::array<std::int64_t, most_tags> tags_{};
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;
};

// Whether the piece's first element has the nodes of the last one before it.
bool repeats(const std::vector<Index>& last, const PlainElements22& piece) {
  const auto each = static_cast<std::size_t>(piece.runs.front().type->nodes);
  return last.size() == each && std::equal(last.begin(), last.end(), piece.nodes.begin());
}

}  // namespace

bool read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index,
                           const std::function<void(const PlainElements22&)>& take) {
  if (in.binary() || count < least_plain_lines) return false;
  in.skip_blanks();
  std::vector<PlainElements22> read;
  std::vector<Index> last;  // nodes of the last element of the wave before
  LineReader reader;
  reader.begin = [&](const std::vector<LinePiece>& wave) {
    if (read.size() < wave.size()) read.resize(wave.size());
  };
  reader.read = [&](const LinePiece& piece) -> const char* {
    PlainLine line(piece.text.data(), piece.text.data() + piece.text.size());
    PlainElements22& mine = read[piece.number];
    mine.clear();
    PieceReader lines(index, mine);
    for (std::size_t i = 0; i < piece.count; ++i)
      if (!lines.read(line)) return nullptr;
    return line.place();
  };
  reader.end = [&](const std::vector<LinePiece>& wave) {
    for (const LinePiece& piece : wave) {
      const PlainElements22& mine = read[piece.number];
      if (repeats(last, mine)) return false;
      last.assign(mine.nodes.end() - mine.runs.back().type->nodes, mine.nodes.end());
    }
    for (const LinePiece& piece : wave) take(read[piece.number]);
    return true;
  };
  const auto behind = read_lines(in.source(), in.offset(), count, reader);
  if (behind) in.go_to(*behind);
  return behind.has_value();
}

}  // namespace tetproof::io
