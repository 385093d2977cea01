// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/tallies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

template <class Key>
std::map<std::string, Tally> tally(const std::vector<CaseResult>& cases, const Key& key) {
  std::map<std::string, Tally> rows;
  for (const CaseResult& result : cases) ++rows[key(result)].of[static_cast<std::size_t>(result.outcome)];
  return rows;
}

std::int64_t sum_where(const Tally& tally, bool (*holds)(Outcome)) {
  std::int64_t sum = 0;
  for (const Outcome outcome : outcomes_in_order())
    if (holds(outcome)) sum += tally.count(outcome);
  return sum;
}

}  // namespace

std::int64_t Tally::cases() const {
  return std::accumulate(of.begin(), of.end(), std::int64_t{0});
}

std::int64_t Tally::findings() const {
  return sum_where(*this, is_finding);
}

std::int64_t Tally::unjudged() const {
  return sum_where(*this, is_unjudged);
}

const std::array<Outcome, outcome_count>& outcomes_in_order() {
  static const auto order = [] {
    std::array<Outcome, outcome_count> all{};
    for (int o = 0; o < outcome_count; ++o) all[static_cast<std::size_t>(o)] = static_cast<Outcome>(o);
    std::sort(all.begin() + 1, all.end(), [](Outcome a, Outcome b) { return severity(a) > severity(b); });
    return all;
  }();
  return order;
}

std::vector<Outcome> shown_outcomes(const CampaignResult& result) {
  const Tally all = tally_of_all(result);
  std::vector<Outcome> shown;
  for (const Outcome outcome : outcomes_in_order())
    if (all.count(outcome) > 0 || outcome == Outcome::sound || outcome == Outcome::slow ||
        outcome == Outcome::not_judged)
      shown.push_back(outcome);
  return shown;
}

Tally tally_of_all(const CampaignResult& result) {
  return tally(result.cases, [](const CaseResult&) { return ""; })[""];
}

std::vector<TallyRow> tally_by_mesher(const CampaignResult& result) {
  std::map<std::string, Tally> rows = tally(result.cases, [](const CaseResult& one) { return one.mesher; });
  std::vector<TallyRow> sorted;
  for (const MesherFacts& mesher : result.settings.meshers)
    sorted.emplace_back(mesher.name, rows[mesher.name]);
  return sorted;
}

std::vector<TallyRow> tally_by_kind(const CampaignResult& result) {
  const auto rows = tally(result.cases, [](const CaseResult& one) { return kind_of_recipe(one.recipe); });
  return {rows.begin(), rows.end()};
}

std::string kind_of_recipe(const std::string& recipe) {
  const std::string kind = recipe.substr(0, recipe.find_first_of("(+"));
  return kind.empty() ? "other" : kind;
}

std::int64_t new_groups(const CampaignResult& result) {
  return std::count_if(result.groups.begin(), result.groups.end(),
                       [](const FailureGroup& group) { return !group.known; });
}

bool nothing_judged(const CampaignResult& result) {
  const Tally all = tally_of_all(result);
  return all.cases() > 0 && all.count(Outcome::sound) + all.findings() == 0;
}

std::int64_t partly_unjudged(const CampaignResult& result) {
  return std::count_if(result.cases.begin(), result.cases.end(), [](const CaseResult& one) {
    return std::any_of(one.further.begin(), one.further.end(),
                       [](const FurtherFailure& further) { return is_unjudged(further.outcome); });
  });
}

bool is_incomplete(const CampaignResult& result) {
  return tally_of_all(result).unjudged() > 0 || partly_unjudged(result) > 0 || nothing_judged(result) ||
         !result.missing.empty();
}

std::string summary_line(const CampaignResult& result) {
  const Tally all = tally_of_all(result);
  const std::int64_t fresh = new_groups(result);
  const auto known = static_cast<std::int64_t>(result.groups.size()) - fresh;
  std::string line = fmt::format("seed {}: {} on {}: {} sound, {} in {}", result.settings.seed,
                                 io::counted(result.settings.meshers.size(), "meshers"),
                                 io::counted(result.surfaces, "surfaces"), all.count(Outcome::sound),
                                 io::counted(all.findings(), "findings"), io::counted(fresh, "new groups"));
  if (known > 0) line += fmt::format(" and {}", io::counted(known, "known groups"));
  for (const Outcome outcome : outcomes_in_order())
    if (outcome != Outcome::sound && !is_finding(outcome) && all.count(outcome) > 0)
      line += fmt::format(", {} {}", all.count(outcome), name_of(outcome));
  if (all.unjudged() > 0)
    line += fmt::format("; nothing is said of {}", io::counted(all.unjudged(), "cases"));
  if (const std::int64_t cases = partly_unjudged(result); cases > 0)
    line += fmt::format("; some runs of {} were not judged", io::counted(cases, "cases"));
  if (nothing_judged(result)) line += "; not one mesh was judged";
  if (const auto& ids = result.settings.judge.check; !ids.empty())
    line += fmt::format("; judged by {} only", fmt::join(ids, ", "));
  if (!result.missing.empty()) line += "; not all cases were run";
  return line;
}

const ShrunkCase* shrunk_of_group(const CampaignResult& result, const FailureGroup& group) {
  const std::string id = group.id();
  for (const ShrunkCase& one : result.shrunk)
    if (one.group == id) return &one;
  return nullptr;
}

}  // namespace tetproof::corpus
