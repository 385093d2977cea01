// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/intersections.hpp"

#include <CGAL/box_intersection_d.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>

#include "verify/triangles/box.hpp"

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

// Sorts the list, removes repeated items and keeps the first `most`.
template <class T>
void keep_first(std::vector<T>& list, std::size_t most) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  if (list.size() > most) list.resize(most), list.shrink_to_fit();
}

template <class T>
void add(std::vector<T>& list, const T& item, std::size_t most) {
  list.push_back(item);
  if (list.size() > 2 * most + 1024) keep_first(list, most);
}

// What is near is kept whole: the search ends before there is too much of it. A pair has six contacts at
// most.
constexpr std::size_t all_near = 6 * static_cast<std::size_t>(most_counted_pairs);

void keep_first(Intersections& all, std::size_t most) {
  keep_first(all.pairs, most);
  keep_first(all.contacts, all_near);
  keep_first(all.folds, all_near);
  keep_first(all.near, all_near);
}

// Finds some of very many pairs that meet, at least one: compares each triangle with those before it until
// there are enough pairs or too many comparisons.
std::vector<std::array<Index, 2>> some_pairs(std::span<const Eigen::Vector3d> points,
                                             std::span<const Triangle> triangles,
                                             const std::vector<Box>& boxes, std::size_t enough) {
  constexpr std::size_t most_compared = 2'000'000'000;
  std::vector<std::array<Index, 2>> pairs;
  std::size_t compared = 0;
  for (std::size_t i = 0;
       i < boxes.size() && pairs.size() < enough && (pairs.empty() || compared < most_compared); ++i) {
    compared += i;
    for (std::size_t k = 0; k < i && pairs.size() < enough; ++k) {
      const Box &x = boxes[k], &y = boxes[i];
      bool apart = false;
      for (int axis = 0; axis < 3; ++axis)
        apart = apart || x.low[axis] > y.high[axis] || y.low[axis] > x.high[axis];
      if (!apart && triangles_meet(points, triangles[x.number], triangles[y.number]))
        pairs.push_back({static_cast<Index>(x.number), static_cast<Index>(y.number)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct TooManyPairs {};

// Counts pairs from many threads. Ends the search by an exception after most_counted_pairs.
class Counter {
 public:
  void count_one() {
    if (count_.fetch_add(1, std::memory_order_relaxed) >= most_counted_pairs) throw TooManyPairs{};
  }
  bool too_many() const { return count_ > most_counted_pairs; }

 private:
  std::atomic<std::int64_t> count_ = 0;
};

}  // namespace

Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most,
                                 const Near* near) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (excluded.empty() || !excluded[t]) {
      boxes.push_back(box_of(points, triangles[t], t));
      const double room = near ? near->room(static_cast<Index>(t)) : 0;
      for (int k = 0; k < 3; ++k) boxes.back().low[k] -= room, boxes.back().high[k] += room;
    }
  Intersections result;
  if (boxes.empty()) return result;

  const Slabs slabs = make_slabs(boxes);
  std::vector<std::uint32_t> begins(triangles.size()), ends(triangles.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
    begins[boxes[i].number] = slabs.slab_of(boxes[i].low[slabs.axis]);
    ends[boxes[i].number] = slabs.slab_of(boxes[i].high[slabs.axis]);
  });
  const std::optional<Nearby> nearby =
      near ? std::optional<Nearby>(std::in_place, points, triangles, *near) : std::nullopt;
  std::mutex joining;
  Counter met, near_pairs;
  tbb::parallel_for(
      std::size_t{0}, slabs.splits.size() + 1,
      [&](std::size_t slab) {
        std::vector<Box> mine;
        for (const Box& box : boxes)
          if (begins[box.number] <= slab && slab <= ends[box.number]) mine.push_back(box);
        Intersections found;
        const auto meet = [&](const Box& x, const Box& y) {
          if (std::max(begins[x.number], begins[y.number]) != slab) return;
          const auto [low, high] = std::minmax({static_cast<Index>(x.number), static_cast<Index>(y.number)});
          if (nearby && nearby->wide_apart(low, high)) return;
          const bool meeting = triangles_meet(points, triangles[low], triangles[high]);
          if (meeting) {
            ++found.count;
            met.count_one();
            add(found.pairs, std::array<Index, 2>{low, high}, most);
          }
          if (!nearby) return;
          const PairNearness pair = nearby->look(x, y, meeting);
          if (pair.contact_count > 0 || pair.near || pair.fold) near_pairs.count_one();
          for (int i = 0; i < pair.contact_count; ++i) add(found.contacts, pair.contacts[i], all_near);
          if (pair.near) add(found.near, std::array<Index, 2>{low, high}, all_near);
          if (pair.fold) add(found.folds, std::array<Index, 2>{low, high}, all_near);
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
        // The first items of the union are among the first items of its parts, so the order of the parts does
        // not matter.
        const std::lock_guard lock(joining);
        const auto join = [&](auto& all, const auto& part, std::size_t kept) {
          all.insert(all.end(), part.begin(), part.end());
          if (all.size() > 2 * kept + 1024) keep_first(all, kept);
        };
        result.count += found.count;
        join(result.pairs, found.pairs, most);
        join(result.contacts, found.contacts, all_near);
        join(result.folds, found.folds, all_near);
        join(result.near, found.near, all_near);
      },
      tbb::simple_partitioner());
  // Whether there are too many pairs does not depend on the threads. Which of them were found first does, so
  // these lists are not used.
  if (near && near_pairs.too_many()) {
    result = self_intersections(points, triangles, excluded, most);
    result.more_near = true;
    return result;
  }
  if (met.too_many())
    return {.more = true,
            .count = most_counted_pairs,
            .pairs = some_pairs(points, triangles, boxes, std::min<std::size_t>(most, 1000))};
  keep_first(result, most);
  return result;
}

}  // namespace tetproof::verify
