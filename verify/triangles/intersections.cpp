// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/intersections.hpp"

#include <CGAL/box_intersection_d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <mutex>

#include "verify/triangles/box.hpp"
#include "verify/triangles/decider.hpp"
#include "verify/triangles/hubs.hpp"

namespace tetproof::verify {
namespace {

// Slabs perpendicular to one axis, each of which is searched independently. A box belongs to every slab that
// it reaches. A pair is counted in one slab only: in the later of the two slabs in which its boxes begin.
// Both boxes reach that slab.
struct Slabs {
  int axis = 0;
  std::vector<double> splits;  // where each slab begins, from the second on

  std::uint32_t slab_of(double x) const {
    return static_cast<std::uint32_t>(std::upper_bound(splits.begin(), splits.end(), x) - splits.begin());
  }
};

Slabs make_slabs(const std::vector<Box>& boxes) {
  constexpr std::size_t boxes_each = 16384;
  // The axis along which the boxes are thinnest. The number of slabs is limited so that, on average, a box
  // reaches about one slab more than the one in which it begins.
  Slabs slabs;
  double reach = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    double low = boxes[0].low[axis], high = low, sum = 0;
    for (const Box& box : boxes) {
      low = std::min(low, box.low[axis]);
      high = std::max(high, box.high[axis]);
      sum += box.high[axis] - box.low[axis];
    }
    const double share = sum / (static_cast<double>(boxes.size()) * (high - low));
    if (share < reach) reach = share, slabs.axis = axis;
  }
  const std::size_t whole = boxes.size() / boxes_each;
  const double most = std::min(static_cast<double>(whole), 1 / reach);
  const auto count = most >= 2 ? static_cast<std::size_t>(most) : 1;
  std::vector<double> lows(boxes.size());
  std::transform(boxes.begin(), boxes.end(), lows.begin(),
                 [&](const Box& box) { return box.low[slabs.axis]; });
  for (std::size_t i = 1; i < count; ++i) {
    const auto at = lows.begin() + static_cast<std::ptrdiff_t>(i * lows.size() / count);
    std::nth_element(lows.begin(), at, lows.end());
    slabs.splits.push_back(*at);
  }
  return slabs;
}

// Finds some of very many pairs that meet, at least one; which ones does not depend on the threads. Takes
// pairs at hubs first. Then compares each of the other triangles with those before it, until there are enough
// pairs or too many comparisons.
std::vector<std::array<Index, 2>> some_pairs(std::span<const Eigen::Vector3d> points,
                                             std::span<const Triangle> triangles, const Hubs& hubs,
                                             const std::vector<Box>& without_hub, std::size_t enough) {
  constexpr std::size_t most_compared = 2'000'000'000;
  std::vector<std::array<Index, 2>> pairs;
  const auto add_if_meeting = [&](Index s, Index t) {
    const auto pair = std::array{std::min(s, t), std::max(s, t)};
    if (triangles_meet(points, triangles[static_cast<std::size_t>(pair[0])],
                       triangles[static_cast<std::size_t>(pair[1])]))
      pairs.push_back(pair);
  };
  try {
    hubs.candidates([](Index) { return 0.0; }, Threads::one,
                    [&](Index s, Index t) {
                      add_if_meeting(s, t);
                      if (pairs.size() < 2 * enough) return;
                      keep_first(pairs, pairs.size());
                      if (pairs.size() >= enough) throw TooManyPairs{};
                    });
  } catch (const TooManyPairs&) {
  }
  keep_first(pairs, enough);
  const std::vector<Box>& boxes = without_hub;
  std::size_t compared = 0;
  for (std::size_t i = 0;
       i < boxes.size() && pairs.size() < enough && (pairs.empty() || compared < most_compared); ++i) {
    compared += i;
    for (std::size_t k = 0; k < i && pairs.size() < enough; ++k)
      if (boxes[k].meets(boxes[i]))
        add_if_meeting(static_cast<Index>(boxes[k].number), static_cast<Index>(boxes[i].number));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Decides all pairs whose boxes meet.
void search_slabs(const std::vector<Box>& boxes, std::size_t triangles, Decider& decider,
                  Intersections& result) {
  if (boxes.empty()) return;
  const Slabs slabs = make_slabs(boxes);
  std::vector<std::uint32_t> begins(triangles), ends(triangles);
  tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
    begins[boxes[i].number] = slabs.slab_of(boxes[i].low[slabs.axis]);
    ends[boxes[i].number] = slabs.slab_of(boxes[i].high[slabs.axis]);
  });
  tbb::parallel_for(
      std::size_t{0}, slabs.splits.size() + 1,
      [&](std::size_t slab) {
        std::vector<Box> mine;
        for (const Box& box : boxes)
          if (begins[box.number] <= slab && slab <= ends[box.number]) mine.push_back(box);
        Intersections found;
        const auto meet = [&](const Box& x, const Box& y) {
          if (std::max(begins[x.number], begins[y.number]) == slab) decider.add(x, y, found);
        };
        try {
          // Below the cutoff CGAL sweeps instead of splitting further. A cutoff of 1000 halves the time of
          // the default, 10.
          CGAL::box_self_intersection_d(mine.begin(), mine.end(), meet,
                                        CGAL::Box_intersection_d::Box_traits_d<Box>(), 1000,
                                        CGAL::Box_intersection_d::CLOSED);
        } catch (const TooManyPairs&) {
          return;
        }
        decider.join(result, found);
      },
      tbb::simple_partitioner());
}

// Pairs from many threads, each kept once.
class Distinct {
 public:
  void add(Index s, Index t) {
    auto& mine = local_.local();
    mine.push_back({std::min(s, t), std::max(s, t)});
    if (mine.size() < most_local) return;
    const std::lock_guard lock(joining_);
    merge(mine);
    // Then more than most_counted_pairs meet, or more than that are near each other.
    if (all_.size() > 2 * most_counted_pairs) throw TooManyPairs{};
  }
  const std::vector<std::array<Index, 2>>& pairs() {
    for (auto& mine : local_) merge(mine);
    return all_;
  }

 private:
  static constexpr std::size_t most_local = 1 << 20;
  void merge(std::vector<std::array<Index, 2>>& more) {
    all_.insert(all_.end(), more.begin(), more.end());
    more.clear();
    keep_first(all_, all_.size());
  }
  tbb::enumerable_thread_specific<std::vector<std::array<Index, 2>>> local_;
  std::vector<std::array<Index, 2>> all_;
  std::mutex joining_;
};

// Decides all pairs of which one triangle is at a hub.
void search_hubs(const Hubs& hubs, const std::function<Box(Index)>& box,
                 const std::function<double(Index)>& room, Decider& decider, Intersections& result) {
  Distinct distinct;
  try {
    hubs.candidates(room, Threads::all, [&](Index s, Index t) {
      const Box x = box(s), y = box(t);
      if (x.meets(y) && decider.finds(x, y)) distinct.add(s, t);
    });
  } catch (const TooManyPairs&) {  // deciding those that were found will count too many
  }
  const auto& pairs = distinct.pairs();
  constexpr std::size_t piece = 4096;
  tbb::parallel_for(std::size_t{0}, (pairs.size() + piece - 1) / piece, [&](std::size_t i) {
    Intersections found;
    try {
      for (std::size_t k = i * piece; k < std::min(pairs.size(), (i + 1) * piece); ++k)
        decider.add(box(pairs[k][0]), box(pairs[k][1]), found);
    } catch (const TooManyPairs&) {
      return;
    }
    decider.join(result, found);
  });
}

}  // namespace

Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most,
                                 const Near* near, std::size_t hub_from) {
  const auto room = [near](Index t) { return near ? near->room(t) : 0.0; };
  const auto box_in_room = [&](std::size_t t) {
    Box box = box_of(points, triangles[t], t);
    const double wider = room(static_cast<Index>(t));
    for (int k = 0; k < 3; ++k) box.low[k] -= wider, box.high[k] += wider;
    return box;
  };
  const Hubs hubs(points, triangles, excluded, hub_from);
  std::vector<Box> boxes;  // of the triangles without a hub
  boxes.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if ((excluded.empty() || !excluded[t]) && !hubs.at_hub(triangles[t])) boxes.push_back(box_in_room(t));

  Intersections result;
  Decider decider(points, triangles, most, near);
  search_slabs(boxes, triangles.size(), decider, result);
  if (!hubs.none() && !decider.too_many_near() && !decider.too_many_meet())
    search_hubs(
        hubs, [&](Index t) { return box_in_room(static_cast<std::size_t>(t)); }, room, decider, result);
  // Whether there are too many pairs does not depend on the threads. Which of them were found first does, so
  // these lists are not used.
  if (decider.too_many_near()) {
    result = self_intersections(points, triangles, excluded, most, nullptr, hub_from);
    result.more_near = true;
    return result;
  }
  if (decider.too_many_meet()) {
    return {.more = true,
            .count = most_counted_pairs,
            .pairs = some_pairs(points, triangles, hubs, boxes, std::min<std::size_t>(most, 1000))};
  }
  keep_first_of_each(result, most);
  return result;
}

}  // namespace tetproof::verify
