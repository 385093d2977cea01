// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/shrink_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <tuple>

#include "corpus/campaign/case_run.hpp"
#include "corpus/campaign/certified_surface.hpp"
#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/report/finding.hpp"
#include "corpus/shrink/shrink_recipe.hpp"
#include "corpus/shrink/shrink_surface.hpp"
#include "io/bytes/checksum.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

// If a failure does not occur again in so many runs, it is given up.
constexpr int most_runs = 20;

// Runs one mesher on surfaces, and looks for one outcome with one signature.
class Reproduction {
 public:
  Reproduction(const Mesher& mesher, const FailureGroup& group, const CampaignOptions& options,
               const std::string& scratch)
      : mesher_(mesher),
        group_(group),
        options_(options),
        scratch_(scratch),
        runs_(runs_to_fail(group.cases.front().failed, group.cases.front().repeats)) {}

  // How often the original fails decides how often each candidate is run. A single failing run tells nothing:
  // a mesher with a damaged heap is not deterministic, whatever its preset says.
  void measure(const TriangleSurface& original) {
    constexpr int least = 5;
    const verify::JudgedSurface judged(original);
    const int before = group_.cases.front().repeats > 1 ? group_.cases.front().failed : 0;
    int runs = before > 0 ? group_.cases.front().repeats : 0, failed = before;
    for (; runs < least || (failed == 0 && runs < most_runs); ++runs) {
      const ScratchFolder folder(fmt::format("{}/shrink-{}", scratch_, calls_.fetch_add(1)));
      failed +=
          is_it(run_and_judge(mesher_, judged, folder.path(), options_.limits, options_.judge).judgement);
    }
    runs_ = std::max(runs_, failed > 0 ? runs_to_fail(failed, runs) : most_runs);
  }

  // Whether it fails in one of as many runs as it takes.
  bool fails(const TriangleSurface& surface) {
    const verify::JudgedSurface judged(surface);
    for (int r = 0; r < runs_; ++r) {
      const ScratchFolder folder(fmt::format("{}/shrink-{}", scratch_, calls_.fetch_add(1)));
      if (is_it(run_and_judge(mesher_, judged, folder.path(), options_.limits, options_.judge).judgement))
        return true;
    }
    return false;
  }

  bool is_it(const Judgement& judgement) const { return belongs_to(judgement, group_); }

  // All repeats on one surface. The folder of the first failing run stays until this object ends.
  struct Count {
    int repeats = 0, failed = 0;
    JudgedRun first{};
    std::unique_ptr<ScratchFolder> folder{};
  };
  Count count(const TriangleSurface& surface) {
    const verify::JudgedSurface judged(surface);
    Count counted;
    // At least as many as it takes to see it: "0 of 1" would say little of one that fails now and then.
    for (const int runs = std::max(runs_, repeats_of(mesher_, options_.repeats));
         counted.repeats < runs || (counted.failed == 0 && counted.repeats < most_runs); ++counted.repeats) {
      auto folder =
          std::make_unique<ScratchFolder>(fmt::format("{}/shrink-{}", scratch_, calls_.fetch_add(1)));
      JudgedRun one = run_and_judge(mesher_, judged, folder->path(), options_.limits, options_.judge);
      if (!is_it(one.judgement)) continue;
      if (++counted.failed > 1) continue;
      counted.first = std::move(one);
      counted.folder = std::move(folder);
    }
    return counted;
  }

  std::int64_t calls() const { return calls_; }

 private:
  const Mesher& mesher_;
  const FailureGroup& group_;
  const CampaignOptions& options_;
  std::string scratch_;
  int runs_;
  std::atomic<std::int64_t> calls_{0};
};

// A surface on its way to become smaller.
struct Smaller {
  TriangleSurface surface;
  std::string recipe{}, steps{};
};

Smaller shrink(const FuzzSurface& original, Reproduction& reproduction, const CampaignOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const StillFails fails = [&](const TriangleSurface& candidate) { return reproduction.fails(candidate); };
  Smaller smaller{original.surface};
  std::string steps;
  bool recipes_finished = true;
  // Simpler recipes first: pruning the construction takes whole parts at once. Half of the time at most.
  if (!original.recipe.kind.empty()) {
    RecipeShrinkResult simpler = shrink_recipe(
        original, fails, {.seconds = options.shrink_s / 2, .threads = options.threads, .seed = options.seed});
    recipes_finished = simpler.finished;
    if (simpler.steps > 0 && simpler.confirmed) {
      smaller.surface = std::move(simpler.surface.surface);
      smaller.recipe = recipe_text(simpler.surface.recipe);
      steps = io::counted(simpler.steps, "simpler recipes");
    }
  }
  const double used = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ShrinkResult result = shrink_surface(
      smaller.surface, fails,
      {.seconds = std::max(0.0, options.shrink_s - used), .threads = options.threads, .seed = options.seed});
  const bool changed = result.surface.vertices != smaller.surface.vertices ||
                       result.surface.triangles != smaller.surface.triangles;
  if (changed && result.confirmed) {
    smaller.surface = std::move(result.surface);
    smaller.recipe.clear();
    steps += (steps.empty() || result.steps.empty() ? "" : ", ") + result.steps;
  }
  if (!recipes_finished || !result.finished)
    steps += (steps.empty() ? "" : ", ") + std::string("stopped by --shrink");
  smaller.steps = steps;
  return smaller;
}

ShrunkCase shrink_group(const Mesher& mesher, const FailureGroup& group, const CampaignOptions& options,
                        const std::string& scratch, std::int64_t cases_run) {
  const auto start = std::chrono::steady_clock::now();
  const CaseResult& smallest = group.cases.front();
  const CertifiedSurface original(options, smallest.index);
  Reproduction reproduction(mesher, group, options, scratch);
  Smaller smaller{original.made().surface, original.recipe()};
  if (options.shrink_s > 0) {
    reproduction.measure(original.made().surface);
    smaller = shrink(original.made(), reproduction, options);
  }
  Reproduction::Count counted = reproduction.count(smaller.surface);
  if (counted.failed == 0 && !smaller.steps.empty()) {
    smaller = {original.made().surface, original.recipe()};
    counted = reproduction.count(smaller.surface);
  }
  ShrunkCase record{.group = group.id(),
                    .index = smallest.index,
                    .mesher = smallest.mesher,
                    .triangles = static_cast<std::int64_t>(smaller.surface.triangles.size()),
                    .repeats = counted.repeats,
                    .failed = counted.failed,
                    .steps = smaller.steps,
                    .recipe = smaller.recipe,
                    .calls = reproduction.calls(),
                    .asked_s = options.shrink_s};
  if (counted.failed > 0) {
    record.folder = finding_folder(record.group, smallest, options.seed);
    const std::string place = options.folder + "/" + record.folder;
    std::filesystem::create_directories(options.folder + "/findings");
    std::filesystem::remove_all(place);  // of a run that was killed, or that shrank less
    write_finding(place, {.seed = options.seed,
                          .index = smallest.index,
                          .original = original.made(),
                          .shrunk = std::move(smaller.surface),
                          .shrunk_recipe = record.recipe,
                          .shrink_steps = record.steps,
                          .mesher = &mesher,
                          .run = std::move(counted.first.run),
                          .judgement = std::move(counted.first.judgement),
                          .checks = options.judge.check,
                          .repeats = counted.repeats,
                          .failed = counted.failed,
                          .cases = static_cast<std::int64_t>(group.cases.size()),
                          .cases_run = cases_run,
                          .run_folder = counted.folder->path()});
  }
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return record;
}

}  // namespace

bool belongs_to(const Judgement& judgement, const FailureGroup& group) {
  return judgement.outcome == group.outcome &&
         as_journalled({.signature = judgement.signature}).signature == group.signature;
}

int runs_to_fail(int failed, int repeats) {
  if (failed <= 0 || repeats <= 1 || failed >= repeats) return 1;
  constexpr int most = 50;
  const double passes = 1 - static_cast<double>(failed) / repeats;
  int runs = 0;
  for (double all_pass = 1; all_pass > 0.01 && runs < most; ++runs) all_pass *= passes;
  return runs;
}

std::string finding_folder(const std::string& group, const CaseResult& smallest, std::uint64_t seed) {
  std::string name;
  for (const char c : group) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
    if (name.size() == 60) break;
  }
  if (!name.empty() && name.back() == '-') name.pop_back();
  const std::string all = fmt::format("{}\n{}\n{}\n{}", group, smallest.mesher, seed, smallest.index);
  return fmt::format("findings/{}-{:08x}", name, io::crc32_of(all));
}

void shrink_groups(const std::vector<const Mesher*>& meshers, const CampaignOptions& options,
                   const std::vector<FailureGroup>& groups, Journal& journal, const std::string& scratch,
                   std::int64_t cases_run, std::vector<ShrunkCase>& shrunk) {
  std::size_t number = 0;
  for (const FailureGroup& group : groups) {
    ++number;
    const std::string id = group.id();
    const CaseResult& smallest = group.cases.front();
    const bool done = std::any_of(shrunk.begin(), shrunk.end(), [&](const ShrunkCase& one) {
      return std::tie(one.group, one.index, one.mesher) == std::tie(id, smallest.index, smallest.mesher) &&
             one.asked_s >= options.shrink_s;
    });
    if (group.known || done) continue;
    const auto mesher = std::find_if(meshers.begin(), meshers.end(),
                                     [&](const Mesher* one) { return one->name() == smallest.mesher; });
    if (options.say && options.shrink_s > 0)
      options.say(fmt::format("shrinking group {} of {}: {}", number, groups.size(), id));
    const ShrunkCase record = shrink_group(**mesher, group, options, scratch, cases_run);
    journal.append(record);
    shrunk.push_back(record);
  }
}

}  // namespace tetproof::corpus
