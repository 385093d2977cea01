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

}  // namespace

void keep_first_of_each(Intersections& all, std::size_t most) {
  keep_first(all.pairs, most);
  keep_first(all.contacts, most);
  keep_first(all.folds, most);
  keep_first(all.near, most);
}

Decider::Decider(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                 std::size_t most, const Near* near)
    : points_(points), triangles_(triangles), most_(most) {
  if (near) nearby_.emplace(points, triangles, *near);
}

bool Decider::finds(const Box& x, const Box& y) const {
  const Triangle &first = triangles_[x.number], &second = triangles_[y.number];
  if (nearby_ && nearby_->wide_apart(first, second)) return false;
  const bool meeting = triangles_meet(points_, first, second);
  if (meeting || !nearby_) return meeting;
  const PairNearness pair = nearby_->look(x, y, meeting);
  return pair.contact_count > 0 || pair.near || pair.fold;
}

void Decider::add(const Box& x, const Box& y, Intersections& found) {
  const auto [low, high] = std::minmax({static_cast<Index>(x.number), static_cast<Index>(y.number)});
  if (nearby_ && nearby_->wide_apart(triangles_[low], triangles_[high])) return;
  const bool meeting = triangles_meet(points_, triangles_[low], triangles_[high]);
  if (meeting) {
    ++found.count;
    count_one(met_);
    append(found.pairs, std::array<Index, 2>{low, high}, most_);
  }
  if (!nearby_) return;
  const PairNearness pair = nearby_->look(x, y, meeting);
  if (pair.contact_count > 0 || pair.near || pair.fold) count_one(near_pairs_);
  for (int i = 0; i < pair.contact_count; ++i) append(found.contacts, pair.contacts[i], most_);
  if (pair.near) {
    ++found.near_count;
    append(found.near, std::array<Index, 2>{low, high}, most_);
  }
  if (pair.fold) append(found.folds, std::array<Index, 2>{low, high}, most_);
}

// The first items of the union are among the first items of its parts, so the order of the parts does not
// matter.
void Decider::join(Intersections& all, const Intersections& part) {
  const std::lock_guard lock(joining_);
  const auto extend = [&](auto& list, const auto& more) {
    list.insert(list.end(), more.begin(), more.end());
    if (list.size() > 2 * most_ + 1024) keep_first(list, most_);
  };
  all.count += part.count;
  all.near_count += part.near_count;
  extend(all.pairs, part.pairs);
  extend(all.contacts, part.contacts);
  extend(all.folds, part.folds);
  extend(all.near, part.near);
}

}  // namespace tetproof::verify
