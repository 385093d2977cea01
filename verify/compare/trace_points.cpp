// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/trace_points.hpp"

namespace tetproof::verify {

void TracePoints::mark(Named& named, int number) {
  if (const auto size = static_cast<std::size_t>(number) + 1; named.all.size() < size) named.all.resize(size);
  named.all[number] = true;
}

int TracePoints::number(Side side, const Eigen::Vector3d& point) {
  Named& named = named_[static_cast<std::size_t>(side)];
  const auto [known, fresh] = named.numbers.try_emplace(key(point));
  if (!fresh) return known->second;
  int number = index_.find(point, named.all);
  if (number < 0) {  // perhaps this trace writes a point in two ways after all
    const std::vector<bool>& others = named_[side == Side::reference].all;
    number = index_.find(point);
    if (number >= 0 && (static_cast<std::size_t>(number) >= others.size() || !others[number])) number = -1;
  }
  if (number < 0) number = index_.append(point);
  mark(named, number);
  return known->second = number;
}

int TracePoints::insert(Side side, const Eigen::Vector3d& point, int partner) {
  Named& named = named_[static_cast<std::size_t>(side)];
  const int number = partner < 0 ? index_.append(point) : partner;
  mark(named, number);
  named.numbers.insert_or_assign(key(point), number);
  return number;
}

}  // namespace tetproof::verify
