// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/certified_test.hpp"

#include <fmt/core.h>

#include <algorithm>
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

// What tells one surface from another.
std::string bytes_of(const TriangleSurface& surface) {
  std::string bytes;
  for (const Eigen::Vector3d& p : surface.vertices)
    bytes.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
  for (const auto& t : surface.triangles)
    bytes.append(reinterpret_cast<const char*>(t.data()), 3 * sizeof(Index));
  return bytes;
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
    std::string bytes = bytes_of(*candidate);
    {
      const std::scoped_lock lock(mutex_);
      if (passed_.contains(bytes)) return false;
    }
    if (!certified(*candidate)) return false;
    const bool fails = call(*candidate);
    const std::scoped_lock lock(mutex_);
    if (!fails)
      passed_.insert(std::move(bytes));
    else if (!best || i < best->index)
      best = Success{i, *std::move(candidate)};
    return fails;
  });
  cut_short_ |= !found && limit_.over();
  if (!found) return std::nullopt;
  return best;
}

}  // namespace tetproof::corpus
