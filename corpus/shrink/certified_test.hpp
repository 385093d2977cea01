// SPDX-License-Identifier: GPL-3.0-or-later
// The test that a shrinker repeats: a candidate is certified first, and tested only if it is a valid surface.
// Internal.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>

#include "corpus/shrink/ordered_search.hpp"
#include "corpus/shrink/shrink_surface.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {

/// Makes candidate i, or nothing where there is none. Called by several threads at once.
using MakeCandidate = std::function<std::optional<TriangleSurface>(std::size_t)>;

class CertifiedTest {
 public:
  /// InputError if `original` is no valid surface. Keeps a reference to `fails`.
  CertifiedTest(const TriangleSurface& original, const StillFails& fails, const ShrinkOptions& options);

  struct Success {
    std::size_t index;
    TriangleSurface surface;
  };
  /// The first of n candidates that is a valid surface of no more than `most_triangles` and still fails. A
  /// candidate that was tested before and did not fail is not tested again.
  std::optional<Success> first(std::size_t n, std::size_t most_triangles, const MakeCandidate& make);

  /// One call of the test, without certifying.
  bool call(const TriangleSurface& surface);
  /// Closed, manifold, oriented as the original is, free of self-intersections, without unused or equal
  /// vertices. Exact.
  bool certified(const TriangleSurface& surface) const;

  bool out_of_time() const { return limit_.over(); }
  bool cut_short() const { return cut_short_; }  ///< some candidate was not tried as the time was over
  double elapsed() const { return limit_.elapsed(); }
  std::int64_t calls() const { return calls_; }

 private:
  bool oriented_as_original(const verify::SurfaceReport& report) const;

  const StillFails& fails_;
  int threads_;
  TimeLimit limit_;
  /// Whether components at even and at odd depth point outward. A file may orient a cavity either way.
  std::array<std::optional<bool>, 2> outward_;
  std::atomic<std::int64_t> calls_ = 0;
  bool cut_short_ = false;
  std::mutex mutex_;
  std::set<std::array<std::uint64_t, 2>> passed_;  // the candidates that did not fail, by their digests
};

}  // namespace tetproof::corpus
