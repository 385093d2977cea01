// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/trace_splits.hpp"

#include <algorithm>

namespace tetproof::verify {

TetKey sorted(std::array<int, 4> points) {
  std::sort(points.begin(), points.end());
  return points;
}

std::optional<Split> read_split(TraceStream& stream, Side side, std::int64_t n, TracePoints& points,
                                const PartnerPoint& partner) {
  const auto* insertion = stream.next_is<trace::Insertion>();
  if (!insertion) {
    if (stream.next() && !stream.next_is<trace::End>()) stream.fail("insertion or end");
    return std::nullopt;
  }
  if (insertion->n != n)
    stream.fail(fmt::format("insertion {}", n), fmt::format("insertion {}", insertion->n));
  Split split{.insertion = *insertion, .line = stream.line()};
  std::array<int, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = points.number(side, insertion->tet[i]);
  split.tet = sorted(corners);
  for (const int i : insertion->replaced) split.replaced.push_back(corners[i]);
  std::sort(split.replaced.begin(), split.replaced.end());
  split.point = points.insert(side, insertion->point, partner(split.tet));
  for (stream.take(); const auto* flip = stream.next_is<trace::Flip>(); stream.take()) {
    FlipKey key{};
    for (int i = 0; i < 3; ++i) key[i] = points.number(side, flip->face[i]);
    for (int i = 0; i < 2; ++i) key[3 + i] = points.number(side, flip->edge[i]);
    key[5] = flip->two_to_three;
    std::sort(key.begin(), key.begin() + 3);
    std::sort(key.begin() + 3, key.begin() + 5);
    split.flips.push_back({*flip, key, stream.line()});
  }
  return split;
}

}  // namespace tetproof::verify
