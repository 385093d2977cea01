// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>

#include "corpus/campaign/case_run.hpp"
#include "corpus/campaign/certified_surface.hpp"
#include "corpus/campaign/conclude.hpp"
#include "corpus/campaign/journal.hpp"
#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/campaign/share_work.hpp"
#include "corpus/campaign/shrink_groups.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

CampaignSettings settings_for(const std::vector<const Mesher*>& meshers, const CampaignOptions& o) {
  CampaignSettings s{.seed = o.seed,
                     .cases = o.cases,
                     .shard = o.shard,
                     .shards = o.shards,
                     .surfaces = o.surfaces,
                     .limits = o.limits,
                     .judge = o.judge,
                     .repeats = o.repeats,
                     .version = o.version};
  for (std::size_t m = 0; m < meshers.size(); ++m)
    s.meshers.push_back({.name = meshers[m]->name(),
                         .command = meshers[m]->command(),
                         .version = meshers[m]->version(),
                         .repeats = repeats_of(*meshers[m], o.repeats),
                         .words = m < o.words.size() ? o.words[m] : std::vector<std::string>{}});
  return s;
}

void check(const std::vector<const Mesher*>& meshers, const CampaignOptions& o) {
  if (meshers.empty()) throw InputError("expected at least one mesher");
  check_shard(o.shard, o.shards);
  std::set<std::string> names;
  for (const Mesher* mesher : meshers)
    if (!names.insert(mesher->name()).second)
      throw InputError(fmt::format("the mesher '{}' is there twice", mesher->name()));
  if (!o.surface_of) random_recipe(o.seed, 0, o.surfaces);  // throws for unknown kinds and modifiers
}

// Runs the cases that are not done yet, on several threads.
class Campaign {
 public:
  Campaign(const std::vector<const Mesher*>& meshers, const CampaignOptions& options, Journal* journal,
           const std::string& scratch)
      : meshers_(meshers), options_(options), journal_(journal), scratch_(scratch) {
    if (journal_)
      for (const CaseResult& result : journal_->content().cases) {
        done_.emplace(result.index, result.mesher);
        cases_.push_back(result);
      }
  }

  std::vector<CaseResult> run() {
    share_work({.first = options_.shard, .end = options_.cases, .step = options_.shards}, options_.threads,
               [this](std::uint64_t index, const std::atomic<bool>& stop) { run_surface(index, stop); });
    return std::move(cases_);
  }

 private:
  void run_surface(std::uint64_t index, const std::atomic<bool>& stop) {
    std::vector<const Mesher*> to_do;
    for (const Mesher* mesher : meshers_)
      if (!done_.contains({index, mesher->name()})) to_do.push_back(mesher);
    if (to_do.empty()) return;
    const CertifiedSurface made(options_, index);
    const std::string recipe = made.recipe();
    for (std::size_t m = 0; m < to_do.size() && !stop; ++m) {
      const std::string folder = fmt::format("{}/{}", scratch_, mesher_number(*to_do[m]));
      CaseResult result = run_case(*to_do[m], made.judged(), index, folder, options_);
      result.recipe = recipe;
      keep(as_journalled(result));
    }
  }

  std::size_t mesher_number(const Mesher& mesher) const {
    return static_cast<std::size_t>(std::find(meshers_.begin(), meshers_.end(), &mesher) - meshers_.begin());
  }

  void keep(const CaseResult& result) {
    if (journal_) journal_->append(result);
    const std::lock_guard lock(mutex_);
    cases_.push_back(result);
    if (options_.progress) options_.progress(result);
  }

  const std::vector<const Mesher*>& meshers_;
  const CampaignOptions& options_;
  Journal* journal_;
  std::string scratch_;
  std::set<std::pair<std::uint64_t, std::string>> done_;
  std::mutex mutex_;
  std::vector<CaseResult> cases_;
};

}  // namespace

CampaignResult run_campaign(const std::vector<const Mesher*>& meshers, const CampaignOptions& options) {
  check(meshers, options);
  const CampaignSettings settings = settings_for(meshers, options);
  std::optional<Journal> journal;
  if (!options.folder.empty()) journal.emplace(options.folder, settings);
  if (options.started) options.started(journal ? journal->content().cases.size() : 0);
  // Beside the journal, so that what a killed run left there is found and removed.
  const ScratchFolder scratch(
      journal ? fmt::format("{}/scratch-{}-of-{}", options.folder, options.shard, options.shards) : "");
  Journal* const open = journal ? &*journal : nullptr;
  std::vector<CaseResult> cases = Campaign(meshers, options, open, scratch.path()).run();

  std::vector<ShrunkCase> shrunk;
  if (open) {
    shrunk = open->content().shrunk;
    shrink_groups(meshers, options, group_failures(cases, options.known), *open, scratch.path(),
                  static_cast<std::int64_t>(cases.size()), shrunk);
  }
  return conclude(settings, std::move(cases), std::move(shrunk), options.known);
}

}  // namespace tetproof::corpus
