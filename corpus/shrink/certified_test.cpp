// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/certified_test.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

bool has_equal_or_unused_vertices(const TriangleSurface& surface) {
  std::vector<std::uint8_t> used(surface.vertices.size(), 0);
  for (const auto& t : surface.triangles)
    for (const Index v : t) used[v] = 1;
  if (std::find(used.begin(), used.end(), 0) != used.end()) return true;
  std::vector<std::array<double, 3>> points;
  for (const Eigen::Vector3d& p : surface.vertices) points.push_back({p.x(), p.y(), p.z()});
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

// 128 bits that tell one surface from another: the surfaces themselves would fill the memory.
std::array<std::uint64_t, 2> digest_of(const TriangleSurface& surface) {
  std::array<std::uint64_t, 2> sums{0x9e3779b97f4a7c15, 0xc2b2ae3d27d4eb4f};
  const auto add = [&](std::uint64_t word) {
    sums[0] = (sums[0] ^ word) * 0xbf58476d1ce4e5b9;
    sums[0] ^= sums[0] >> 31;
    sums[1] = (sums[1] ^ word) * 0x94d049bb133111eb;
    sums[1] ^= sums[1] >> 29;
  };
  for (const Eigen::Vector3d& p : surface.vertices)
    for (const double x : p) add(std::bit_cast<std::uint64_t>(x));
  for (const auto& t : surface.triangles)
    for (const Index v : t) add(static_cast<std::uint64_t>(v));
  return sums;
}

}  // namespace

CertifiedTest::CertifiedTest(const TriangleSurface& original, const StillFails& fails,
                             const ShrinkOptions& options)
    : fails_(fails), threads_(threads_or_cores(options.threads)), limit_(options.seconds) {
  const verify::SurfaceReport report = verify::judge_surface(original);
  if (!report.fault.empty())
    throw InputError(fmt::format("the surface to shrink is not valid: {}", report.fault));
  for (const verify::SurfaceComponent& c : report.components) outward_[c.depth % 2] = c.outward;
  if (!outward_[1]) outward_[1] = !*outward_[0];
}

bool CertifiedTest::oriented_as_original(const verify::SurfaceReport& report) const {
  return std::all_of(report.components.begin(), report.components.end(),
                     [&](const verify::SurfaceComponent& c) { return c.outward == *outward_[c.depth % 2]; });
}

bool CertifiedTest::certified(const TriangleSurface& surface) const {
  if (has_equal_or_unused_vertices(surface)) return false;
  const verify::SurfaceReport report = verify::judge_surface(surface);
  return report.fault.empty() && oriented_as_original(report);
}

bool CertifiedTest::call(const TriangleSurface& surface) {
  ++calls_;
  return fails_(surface);
}

std::optional<CertifiedTest::Success> CertifiedTest::first(std::size_t n, std::size_t most_triangles,
                                                           const MakeCandidate& make) {
  std::optional<Success> best;
  const auto found = first_success(n, threads_, limit_, [&](std::size_t i) {
    std::optional<TriangleSurface> candidate = make(i);
    if (!candidate || candidate->triangles.empty() || candidate->triangles.size() > most_triangles)
      return false;
    const auto digest = digest_of(*candidate);
    {
      const std::scoped_lock lock(mutex_);
      if (passed_.contains(digest)) return false;
    }
    if (!certified(*candidate)) return false;
    const bool fails = call(*candidate);
    const std::scoped_lock lock(mutex_);
    if (!fails)
      passed_.insert(digest);
    else if (!best || i < best->index)
      best = Success{i, *std::move(candidate)};
    return fails;
  });
  cut_short_ |= !found && limit_.over();
  if (!found) return std::nullopt;
  return best;
}

}  // namespace tetproof::corpus
