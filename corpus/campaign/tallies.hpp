// SPDX-License-Identifier: GPL-3.0-or-later
// The counts of outcomes that all reports of a campaign show. Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// The number of cases with each outcome.
struct Tally {
  std::array<std::int64_t, outcome_count> of{};
  std::int64_t cases() const;
  std::int64_t count(Outcome outcome) const { return of[static_cast<std::size_t>(outcome)]; }
  std::int64_t findings() const;
  std::int64_t unjudged() const;  ///< `is_unjudged`
};

/// A row of a table.
using TallyRow = std::pair<std::string, Tally>;

Tally tally_of_all(const CampaignResult& result);
std::vector<TallyRow> tally_by_mesher(const CampaignResult& result);  ///< in the order of the settings
std::vector<TallyRow> tally_by_kind(const CampaignResult& result);    ///< by name

/// All outcomes in the order of the tables: sound, the findings with the worst first, the rest.
const std::array<Outcome, outcome_count>& outcomes_in_order();
/// The outcomes that get a column for people: those that occur, and always sound, slow and not_judged,
/// because "none of them" is said.
std::vector<Outcome> shown_outcomes(const CampaignResult& result);

/// The kind of a recipe: its root, "cylinder" of "cylinder(n=32)+offset(x=1)". "other" without a recipe.
std::string kind_of_recipe(const std::string& recipe);

/// New groups: those that are not known.
std::int64_t new_groups(const CampaignResult& result);

/// Whether there were cases, and no run gave anything to judge: all were refused.
bool nothing_judged(const CampaignResult& result);

/// Cases of which some runs, but not the worst, were not judged.
std::int64_t partly_unjudged(const CampaignResult& result);

/// Whether there were runs, or shards, of which nothing can be said.
bool is_incomplete(const CampaignResult& result);

/// The first line of every report: how much was run, what was found, and what was not looked at.
std::string summary_line(const CampaignResult& result);

/// The record of the group's smallest case, if it was shrunk; else null.
const ShrunkCase* shrunk_of_group(const CampaignResult& result, const FailureGroup& group);

}  // namespace tetproof::corpus
