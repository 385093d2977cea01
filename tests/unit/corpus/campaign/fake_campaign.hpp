// SPDX-License-Identifier: GPL-3.0-or-later
// A mesher without a process and surfaces without a recipe, for tests of the driver: what happens to a case
// is written in the test.
#pragma once

#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus::test {

/// A tetrahedron, or a bipyramid of 4 + 2 * (index % 3) triangles, of size index + 1 along x.
inline TriangleSurface fake_surface(std::uint64_t index) {
  const auto n = static_cast<Index>(index % 3);
  const double size = static_cast<double>(index + 1);
  TriangleSurface s;
  if (n == 0) {
    s.vertices = {{size, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    s.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    return s;
  }
  // A bipyramid over a polygon of n + 2 corners.
  const std::vector<Eigen::Vector3d> ring =
      n == 1 ? std::vector<Eigen::Vector3d>{{size, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}
             : std::vector<Eigen::Vector3d>{{size, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  s.vertices = ring;
  const auto corners = static_cast<Index>(ring.size());
  s.vertices.insert(s.vertices.end(), {{0, 0, 1}, {0, 0, -1}});
  for (Index k = 0; k < corners; ++k) {
    s.triangles.push_back({k, (k + 1) % corners, corners});
    s.triangles.push_back({(k + 1) % corners, k, corners + 1});
  }
  return s;
}

/// The index of the case that a surface was made for.
inline std::uint64_t index_of(const TriangleSurface& surface) {
  return static_cast<std::uint64_t>(std::lround(surface.vertices[0].x())) - 1;
}

/// What a run of the fake mesher ends with. Without a failure it returns a mesh of one tetrahedron: it is
/// sound for a surface of four triangles, and fills too little of the others.
struct FakeRun {
  std::optional<Outcome> failure{};
  std::string signature{};
};

class FakeMesher : public Mesher {
 public:
  using Script = std::function<FakeRun(std::uint64_t index, int run)>;
  FakeMesher(std::string name, Script script, int repeats = 1)
      : name_(std::move(name)), script_(std::move(script)), repeats_(repeats) {}

  MesherRun run(const TriangleSurface& surface, const std::string&, const Limits&) const override {
    ++runs;
    const std::uint64_t index = index_of(surface);
    int number = 0;
    {
      const std::lock_guard lock(mutex_);
      number = count_[index]++;
    }
    const FakeRun what = script_(index, number);
    MesherRun run;
    run.failure = what.failure;
    run.signature = what.signature;
    run.message = what.signature.empty() ? "" : "it says: " + what.signature;
    if (!run.failure) {
      run.mesh.points = {surface.vertices.begin(), surface.vertices.begin() + 4};
      run.mesh.tets = {{3, 0, 1, 2}};
    }
    return run;
  }
  std::string name() const override { return name_; }
  std::string command() const override { return "fake {surface} {mesh}"; }
  std::string version() const override { return version_text; }
  std::string surface_ending() const override { return ""; }
  bool may_change_boundary() const override { return false; }
  double fidelity() const override { return 0; }
  int repeats() const override { return repeats_; }

  mutable std::atomic<int> runs{0};
  std::string version_text = "fake 1.0";

 private:
  std::string name_;
  Script script_;
  int repeats_;
  mutable std::mutex mutex_;
  mutable std::map<std::uint64_t, int> count_;
};

/// Options with fake surfaces.
inline CampaignOptions fake_options(std::uint64_t cases, const std::string& folder = {}) {
  return {.seed = 7,
          .cases = cases,
          .threads = 2,
          .folder = folder,
          .words = {{"--mesher", "fake"}},
          .version = "1",
          .surface_of = [](std::uint64_t index) {
            return FuzzSurface{.surface = fake_surface(index), .recipe = {}};
          }};
}

/// A script that crashes, refuses, is slow and is sound by the index alone.
inline FakeRun usual_script(std::uint64_t index, int) {
  if (index % 7 == 3) return {Outcome::crashed, "f: Assertion `x > 0' failed"};
  if (index % 11 == 5) return {Outcome::crashed, "g: SIGSEGV"};
  if (index % 13 == 6) return {Outcome::slow, "cpu"};
  if (index % 3 != 0) return {Outcome::refused, "too hard"};
  return {};
}

}  // namespace tetproof::corpus::test
