// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/volumes.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Mpzf.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tetproof::verify {
namespace {

// Sums and products of doubles without rounding. So the order of a parallel sum does not matter.
using Exact = CGAL::Mpzf;

// The double nearest to q, ties to even; infinite if q is beyond the range of doubles.
double nearest(const CGAL::Gmpq& q) {
  const double truncated = mpq_get_d(q.mpq());  // rounds towards zero
  if (!std::isfinite(truncated)) return truncated;
  const double infinity = std::numeric_limits<double>::infinity();
  const double away = std::nextafter(truncated, q < 0 ? -infinity : infinity);
  if (!std::isfinite(away)) return truncated;
  const auto order = CGAL::compare(CGAL::abs(q - CGAL::Gmpq(truncated)), CGAL::abs(CGAL::Gmpq(away) - q));
  const bool even = (std::bit_cast<std::uint64_t>(truncated) & 1) == 0;
  return order == CGAL::SMALLER || (order == CGAL::EQUAL && even) ? truncated : away;
}

CGAL::Gmpq times_power_of_two(const CGAL::Gmpq& q, int power) {
  CGAL::Gmpq result;
  if (power >= 0)
    mpq_mul_2exp(result.mpq(), q.mpq(), static_cast<mp_bitcnt_t>(power));
  else
    mpq_div_2exp(result.mpq(), q.mpq(), static_cast<mp_bitcnt_t>(-power));
  return result;
}

Exact determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Exact ax = a.x(), ay = a.y(), az = a.z(), bx = b.x(), by = b.y(), bz = b.z(), cx = c.x(), cy = c.y(),
              cz = c.z();
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
}

}  // namespace

struct ExactVolumes::Sums {
  std::vector<Exact> six_volumes;

  Exact weighted(std::span<const int> weights) const {
    Exact sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != 0) sum += Exact(weights[i]) * six_volumes[i];
    return sum;
  }
};

ExactVolumes::ExactVolumes(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                           std::span<const Index> set_of, std::size_t sets)
    : sums_(std::make_unique<Sums>()) {
  sums_->six_volumes.assign(sets, Exact(0));
  // Each thread first adds up runs of triangles of one set: consecutive triangles belong to few sets.
  struct Part {  // NOLINT(bugprone-exception-escape): CGAL's number could throw where memory ends, and then
                 // all ends
    Index set;
    Exact sum;
  };
  tbb::enumerable_thread_specific<std::vector<Part>> parts;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 1024),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      std::vector<Part>& mine = parts.local();
                      for (std::size_t t = range.begin(); t < range.end(); ++t) {
                        const Index set = set_of.empty() ? 0 : set_of[t];
                        if (set < 0) continue;
                        const auto& [a, b, c] = triangles[t];
                        if (mine.empty() || mine.back().set != set) mine.push_back({set, Exact(0)});
                        mine.back().sum += determinant(points[a], points[b], points[c]);
                      }
                    });
  for (const std::vector<Part>& mine : parts)
    for (const Part& part : mine) sums_->six_volumes[part.set] += part.sum;
}

ExactVolumes::~ExactVolumes() = default;
ExactVolumes::ExactVolumes(ExactVolumes&&) noexcept = default;
ExactVolumes& ExactVolumes::operator=(ExactVolumes&&) noexcept = default;

int ExactVolumes::sign(std::size_t set) const {
  return static_cast<int>(CGAL::sign(sums_->six_volumes[set]));
}

double ExactVolumes::volume(std::size_t set) const {
  return nearest(CGAL::Gmpq(sums_->six_volumes[set]) / 6);
}

double ExactVolumes::weighted_sum(std::span<const int> weights) const {
  return nearest(CGAL::Gmpq(sums_->weighted(weights)) / 6);
}

double ExactVolumes::difference(std::span<const int> weights, const ExactVolumes& other,
                                std::span<const int> other_weights, int exponent) const {
  return nearest(times_power_of_two(
      CGAL::Gmpq(sums_->weighted(weights) - other.sums_->weighted(other_weights)) / 6, -3 * exponent));
}

double ExactVolumes::weighted_sum_in_units(std::span<const int> weights, int exponent) const {
  return nearest(times_power_of_two(CGAL::Gmpq(sums_->weighted(weights)) / 6, -3 * exponent));
}

int ExactVolumes::compare_size(std::size_t i, std::size_t j) const {
  return static_cast<int>(CGAL::compare(CGAL::abs(sums_->six_volumes[i]), CGAL::abs(sums_->six_volumes[j])));
}

}  // namespace tetproof::verify
