// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/decider.hpp"

#include <array>

namespace tetproof::verify {
namespace {

template <class T>
void append(std::vector<T>& list, const T& item, std::size_t most) {
  list.push_back(item);
  if (list.size() > 2 * most + 1024) keep_first(list, most);
}

void count_one(std::atomic<std::int64_t>& count) {
  if (count.fetch_add(1, std::memory_order_relaxed) >= most_counted_pairs) throw TooManyPairs{};
}

// What is near is kept whole: the search ends before there is too much of it. A pair has six contacts at
// most.
constexpr std::size_t all_near = 6 * static_cast<std::size_t>(most_counted_pairs);

}  // namespace

void keep_first_of_each(Intersections& all, std::size_t most) {
  keep_first(all.pairs, most);
  keep_first(all.contacts, all_near);
  keep_first(all.folds, all_near);
  keep_first(all.near, all_near);
}

Decider::Decider(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                 std::size_t most, const Near* near)
    : points_(points), triangles_(triangles), most_(most) {
  if (near) nearby_.emplace(points, triangles, *near);
}

bool Decider::finds(const Box& x, const Box& y) const {
  const auto first = static_cast<Index>(x.number), second = static_cast<Index>(y.number);
  if (nearby_ && nearby_->wide_apart(first, second)) return false;
  const bool meeting = triangles_meet(points_, triangles_[x.number], triangles_[y.number]);
  if (meeting || !nearby_) return meeting;
  const PairNearness pair = nearby_->look(x, y, meeting);
  return pair.contact_count > 0 || pair.near || pair.fold;
}

void Decider::add(const Box& x, const Box& y, Intersections& found) {
  const auto [low, high] = std::minmax({static_cast<Index>(x.number), static_cast<Index>(y.number)});
  if (nearby_ && nearby_->wide_apart(low, high)) return;
  const bool meeting = triangles_meet(points_, triangles_[low], triangles_[high]);
  if (meeting) {
    ++found.count;
    count_one(met_);
    append(found.pairs, std::array<Index, 2>{low, high}, most_);
  }
  if (!nearby_) return;
  const PairNearness pair = nearby_->look(x, y, meeting);
  if (pair.contact_count > 0 || pair.near || pair.fold) count_one(near_pairs_);
  for (int i = 0; i < pair.contact_count; ++i) append(found.contacts, pair.contacts[i], all_near);
  if (pair.near) append(found.near, std::array<Index, 2>{low, high}, all_near);
  if (pair.fold) append(found.folds, std::array<Index, 2>{low, high}, all_near);
}

// The first items of the union are among the first items of its parts, so the order of the parts does not
// matter.
void Decider::join(Intersections& all, const Intersections& part) {
  const std::lock_guard lock(joining_);
  const auto extend = [&](auto& list, const auto& more, std::size_t most) {
    list.insert(list.end(), more.begin(), more.end());
    if (list.size() > 2 * most + 1024) keep_first(list, most);
  };
  all.count += part.count;
  extend(all.pairs, part.pairs, most_);
  extend(all.contacts, part.contacts, all_near);
  extend(all.folds, part.folds, all_near);
  extend(all.near, part.near, all_near);
}

}  // namespace tetproof::verify
