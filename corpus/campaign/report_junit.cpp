// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign as JUnit XML: a suite for each mesher. Its test cases are one for all sound cases, one for each
// group (a failure, or skipped where it is known), and one for each outcome of which nothing is said.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/campaign/settings.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "io/bytes/words.hpp"
#include "io/bytes/xml_text.hpp"

namespace tetproof::corpus {
namespace {

using io::xml_escaped;

struct Suite {
  std::string cases;
  int tests = 0, failures = 0, skipped = 0;
};

void add(Suite& suite, const std::string& mesher, const std::string& name, const std::string& inside) {
  ++suite.tests;
  suite.cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"{}\n", xml_escaped(mesher),
                             xml_escaped(name), inside.empty() ? "/>" : ">");
  if (!inside.empty()) suite.cases += inside + "    </testcase>\n";
}

void add_skipped(Suite& suite, const std::string& mesher, const std::string& name, const std::string& why) {
  ++suite.skipped;
  add(suite, mesher, name, fmt::format("      <skipped message=\"{}\"/>\n", xml_escaped(why)));
}

std::string failure(const CampaignResult& result, const FailureGroup& group) {
  const CaseResult& first = group.cases.front();
  std::string text =
      fmt::format("smallest: case {} of {}, {}, {} of {} runs\n{}\n{}\n", first.index, first.mesher,
                  io::counted(first.triangles, "triangles"), first.failed, first.repeats, first.recipe,
                  replay_command(result.settings, first.index, first.mesher));
  return fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n", name_of(group.outcome),
                     xml_escaped(first.what), xml_escaped(text, io::XmlLines::keep));
}

// The suite of one mesher. A group is in the suite of its smallest case's mesher, so that it counts once.
Suite suite_of(const CampaignResult& result, const std::string& mesher, const Tally& tally) {
  Suite suite;
  if (tally.count(Outcome::sound) > 0)
    add(suite, mesher, fmt::format("sound: {}", tally.count(Outcome::sound)), "");
  for (const FailureGroup& group : result.groups) {
    if (group.cases.front().mesher != mesher) continue;
    const std::string name = fmt::format("{} ({})", group.id(), io::counted(group.cases.size(), "cases"));
    if (group.known) {
      add_skipped(suite, mesher, name, "known");
    } else {
      ++suite.failures;
      add(suite, mesher, name, failure(result, group));
    }
  }
  for (const Outcome outcome : outcomes_in_order())
    if (outcome != Outcome::sound && !is_finding(outcome) && tally.count(outcome) > 0)
      add_skipped(suite, mesher, fmt::format("{}: {}", name_of(outcome), tally.count(outcome)),
                  is_unjudged(outcome) ? "nothing is said of these cases" : "no finding");
  return suite;
}

std::string counts(const Suite& suite) {
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", suite.tests, suite.failures,
                     suite.skipped);
}

std::string suite_xml(const std::string& name, const Suite& suite) {
  return fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", xml_escaped(name), counts(suite),
                     suite.cases);
}

}  // namespace

std::string campaign_junit(const CampaignResult& result) {
  Suite all;
  std::string suites;
  const auto append = [&](const std::string& name, const Suite& suite) {
    suites += suite_xml(name, suite);
    all.tests += suite.tests;
    all.failures += suite.failures;
    all.skipped += suite.skipped;
  };
  for (const auto& [mesher, tally] : tally_by_mesher(result)) append(mesher, suite_of(result, mesher, tally));
  if (!result.missing.empty()) {
    Suite missing;
    for (const std::string& line : result.missing) add_skipped(missing, "shards", line, "not run");
    append("shards", missing);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tetproof-fuzz\" {}>\n{}"
      "</testsuites>\n",
      counts(all), suites);
}

}  // namespace tetproof::corpus
