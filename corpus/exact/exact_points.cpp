// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and distances of a few points, with exact integers.
#include "corpus/exact/exact_integers.hpp"
#include "corpus/truth.hpp"

namespace tetproof::corpus {

int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
  const std::array<Eigen::Vector3d, 4> all{a, b, c, d};
  const int unit = last_bit(all);
  const IntegerPoint p = integers(a, unit);
  return dot(cross(integers(b, unit) - p, integers(c, unit) - p), integers(d, unit) - p).sign();
}

bool within_of_line(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    double limit) {
  const std::array<Eigen::Vector3d, 4> all{p, a, b, {limit, 0, 0}};
  const int unit = last_bit(all);
  const IntegerPoint way = integers(b, unit) - integers(a, unit),
                     area = cross(integers(p, unit) - integers(a, unit), way);
  const Integer least = integer(limit, unit);
  return dot(area, area) <= least * least * dot(way, way);
}

bool within_of_plane(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c, double limit) {
  const std::array<Eigen::Vector3d, 5> all{p, a, b, c, {limit, 0, 0}};
  const int unit = last_bit(all);
  const IntegerPoint normal =
      cross(integers(b, unit) - integers(a, unit), integers(c, unit) - integers(a, unit));
  const Integer height = dot(normal, integers(p, unit) - integers(a, unit)), least = integer(limit, unit);
  return height * height <= least * least * dot(normal, normal);
}

}  // namespace tetproof::corpus
