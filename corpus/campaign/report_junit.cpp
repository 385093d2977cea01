// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign as JUnit XML: a suite for each mesher. Its test cases are one for all sound cases, one for each
// group (a failure, or skipped where it is known), and one for each outcome of which nothing is said.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/campaign/junit_suite.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

std::string details(const CampaignResult& result, const FailureGroup& group) {
  const CaseResult& first = group.cases.front();
  return fmt::format("smallest: case {} of {}, {}, {} of {} runs\n{}\n{}\n", first.index, first.mesher,
                     io::counted(first.triangles, "triangles"), first.failed, first.repeats, first.recipe,
                     replay_command(result.settings, first.index, first.mesher));
}

// The suite of one mesher. A group is in the suite of its smallest case's mesher, so that it counts once.
JunitSuite suite_of(const CampaignResult& result, const std::string& mesher, const Tally& tally) {
  JunitSuite suite(mesher);
  if (tally.count(Outcome::sound) > 0) suite.pass(fmt::format("sound: {}", tally.count(Outcome::sound)));
  for (const FailureGroup& group : result.groups) {
    if (group.cases.front().mesher != mesher) continue;
    const std::string name = fmt::format("{} ({})", group.id(), io::counted(group.cases.size(), "cases"));
    if (group.known) {
      suite.skip(name, "known");
    } else {
      suite.fail(name, name_of(group.outcome), group.cases.front().what, details(result, group));
    }
  }
  for (const Outcome outcome : outcomes_in_order())
    if (outcome != Outcome::sound && !is_finding(outcome) && tally.count(outcome) > 0)
      suite.skip(fmt::format("{}: {}", name_of(outcome), tally.count(outcome)),
                 is_unjudged(outcome) ? "nothing is said of these cases" : "no finding");
  return suite;
}

}  // namespace

std::string campaign_junit(const CampaignResult& result) {
  std::vector<JunitSuite> suites;
  for (const auto& [mesher, tally] : tally_by_mesher(result))
    suites.push_back(suite_of(result, mesher, tally));
  if (!result.missing.empty()) {
    JunitSuite missing("shards");
    for (const std::string& line : result.missing) missing.skip(line, "not run");
    suites.push_back(std::move(missing));
  }
  return junit_document(suites);
}

}  // namespace tetproof::corpus
