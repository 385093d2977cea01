// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/shrink_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "corpus/shrink/certified_test.hpp"
#include "corpus/shrink/collapse_edges.hpp"
#include "corpus/shrink/decimals.hpp"
#include "corpus/shrink/editable_surface.hpp"
#include "corpus/shrink/halving.hpp"
#include "corpus/shrink/parts.hpp"
#include "corpus/shrink/patches.hpp"
#include "corpus/shrink/shorten_coordinates.hpp"

namespace tetproof::corpus {
namespace {

// What was done, for the user.
struct Steps {
  std::int64_t parts = 0, handles = 0, patches = 0, edges = 0;
  bool coordinates = false;

  std::string text(const TriangleSurface& surface) const {
    std::string all;
    const auto add = [&](const std::string& step) {
      if (!all.empty()) all += ", ";
      all += step;
    };
    const auto count = [&](std::int64_t n, const char* one, const char* many) {
      if (n > 0) add(fmt::format("{} {}", n, n == 1 ? one : many));
    };
    count(parts, "part removed", "parts removed");
    count(handles, "handle cut", "handles cut");
    count(patches, "patch replaced", "patches replaced");
    count(edges, "edge collapsed", "edges collapsed");
    if (coordinates) {
      const int decimals = most_decimals(surface, coarsest_decimals(surface));
      add(fmt::format("coordinates to {} decimal{}", decimals, decimals == 1 ? "" : "s"));
    }
    return all.empty() ? "nothing could be removed" : all;
  }
};

class Shrinker {
 public:
  Shrinker(const TriangleSurface& surface, CertifiedTest& test, const ShrinkOptions& options)
      : current_(surface), test_(test), seed_(options.seed) {}

  // Each returns whether it changed anything.
  bool remove_parts() {
    const bool solids = remove_sets(&Parts::solids);
    return remove_sets(&Parts::cavities) || solids;
  }
  bool cut_handles() { return replace(&handle_rings, steps_.handles); }
  bool cut_off_pieces() { return replace(&balls, steps_.patches); }
  bool replace_stars() {
    return replace([](const TriangleSurface& s, std::uint64_t) { return stars(s); }, steps_.patches);
  }
  bool collapse_edges() {
    const std::int64_t collapsed = corpus::collapse_edges(test_, current_, seed_);
    steps_.edges += collapsed;
    return collapsed > 0;
  }
  bool shorten_coordinates() {
    const bool changed = corpus::shorten_coordinates(test_, current_);
    steps_.coordinates |= changed;
    return changed;
  }

  const TriangleSurface& current() const { return current_; }
  const Steps& steps() const { return steps_; }

 private:
  bool remove_sets(std::vector<std::vector<Index>> Parts::*sets) {
    const Parts parts = find_parts(current_);
    const std::size_t n = (parts.*sets).size();
    if (n == 0 || parts.solids.size() + parts.cavities.size() < 2) return false;
    const TriangleSurface base = current_;
    std::vector<std::uint8_t> removed(parts.solids.size() + parts.cavities.size(), 0);
    const auto with = [&](std::span<const std::size_t> run) {
      std::vector<std::uint8_t> all = removed;
      for (const std::size_t i : run)
        for (const Index part : (parts.*sets)[i]) all[part] = 1;
      return all;
    };
    try_by_halves(
        test_, n, 1, [&] { return current_.triangles.size() - 1; },
        [&](std::span<const std::size_t> run) {
          return std::optional(without_parts(base, parts, with(run)));
        },
        [&](std::span<const std::size_t> run, TriangleSurface surface) {
          removed = with(run);
          current_ = std::move(surface);
        });
    const auto count = std::count(removed.begin(), removed.end(), 1);
    steps_.parts += count;
    return count > 0;
  }

  // Replaces the first of the patches that can go, until none can.
  template <class Patches>
  bool replace(Patches patches, std::int64_t& count) {
    for (bool changed = false;; changed = true) {
      const std::vector<Patch> all = patches(current_, seed_);
      auto success = test_.first(all.size(), current_.triangles.size() - 1,
                                 [&](std::size_t i) { return replace_patch(current_, all[i]); });
      if (!success) return changed;
      current_ = std::move(success->surface);
      ++count;
    }
  }

  TriangleSurface current_;
  CertifiedTest& test_;
  std::uint64_t seed_;
  Steps steps_;
};

}  // namespace

ShrinkResult shrink_surface(const TriangleSurface& surface, const StillFails& fails,
                            const ShrinkOptions& options) {
  CertifiedTest test(surface, fails, options);
  ShrinkResult result;
  const TriangleSurface start = without_unused_vertices(surface);
  if (!test.call(start)) {
    result.surface = start;
    result.confirmed = false;
    result.steps = "nothing: the surface did not fail when it was tested again";
  } else {
    Shrinker shrinker(start, test, options);
    bool changed = true;
    while (changed) {
      changed = shrinker.remove_parts();
      changed |= shrinker.cut_handles();
      changed |= shrinker.cut_off_pieces();
      changed |= shrinker.collapse_edges();
      changed |= shrinker.replace_stars();
      changed |= shrinker.shorten_coordinates();
      if (test.out_of_time()) break;
    }
    result.surface = shrinker.current();
    result.finished = !changed && !test.cut_short();
    result.confirmed = test.call(result.surface);
    result.steps = shrinker.steps().text(result.surface);
  }
  result.calls = test.calls();
  result.seconds = test.elapsed();
  return result;
}

}  // namespace tetproof::corpus
