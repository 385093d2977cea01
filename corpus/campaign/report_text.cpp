// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "corpus/campaign/group_text.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/campaign/text_table.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

std::string table(const char* head, const std::vector<TallyRow>& rows, const std::vector<Outcome>& columns) {
  std::vector<std::vector<std::string>> cells{{head, "cases"}};
  for (const Outcome outcome : columns) cells[0].push_back(name_of(outcome));
  for (const auto& [name, tally] : rows) {
    std::vector<std::string>& row = cells.emplace_back();
    row = {name, std::to_string(tally.cases())};
    for (const Outcome outcome : columns) row.push_back(std::to_string(tally.count(outcome)));
  }
  return text_table(cells) + "\n";
}

// "tetgen,pq 5, tetgen,pY 2".
std::string cases_by_variant(const FailureGroup& group) {
  std::map<std::string, int> counts;
  for (const CaseResult& member : group.cases) ++counts[member.mesher];
  std::vector<std::string> words;
  for (const auto& [name, count] : counts) words.push_back(fmt::format("{} {}", printable(name), count));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string repeats(int failed, int repeats) {
  return repeats > 1 ? fmt::format(", {} of {} runs", failed, repeats) : "";
}

std::string shrunk_text(const ShrunkCase& shrunk) {
  if (shrunk.failed == 0)
    return fmt::format("  did not occur again in {}\n", io::counted(shrunk.repeats, "further runs"));
  std::string text = fmt::format("  smallest known: {}{}", io::counted(shrunk.triangles, "triangles"),
                                 repeats(shrunk.failed, shrunk.repeats));
  if (!shrunk.steps.empty()) text += fmt::format(" ({})", printable(shrunk.steps));
  if (!shrunk.folder.empty()) text += "\n  folder: " + shrunk.folder;
  return text + "\n";
}

}  // namespace

std::string group_text(const CampaignResult& result, const FailureGroup& group, std::size_t number) {
  const CaseResult& first = group.cases.front();
  std::string text = fmt::format("{}. {}{}\n", number, printable(group.id()), group.known ? "  (known)" : "");
  text += fmt::format("  {} on {}: {}\n", io::counted(group.cases.size(), "cases"),
                      io::counted(group.surfaces, "surfaces"), cases_by_variant(group));
  if (!first.what.empty() && first.what != group.signature) text += "  says: " + printable(first.what) + "\n";
  text += fmt::format("  smallest: case {} of {}, {}{}{}\n", first.index, printable(first.mesher),
                      io::counted(first.triangles, "triangles"), repeats(first.failed, first.repeats),
                      first.recipe.empty() ? "" : ", " + printable(first.recipe));
  if (const ShrunkCase* shrunk = shrunk_of_group(result, group)) text += shrunk_text(*shrunk);
  const std::string command = replay_command(result.settings, first.index, first.mesher);
  if (!command.empty()) text += "  again: " + printable(command) + "\n";
  return text;
}

std::string campaign_text(const CampaignResult& result) {
  const std::vector<Outcome> columns = shown_outcomes(result);
  std::string text = summary_line(result) + "\n\n";
  text += table("mesher", tally_by_mesher(result), columns);
  text += table("kind of surface", tally_by_kind(result), columns);
  std::size_t number = 0;
  for (const FailureGroup& group : result.groups) text += group_text(result, group, ++number);
  for (const std::string& id : result.known_unseen)
    text += "known, and did not occur: " + printable(id) + "\n";
  for (const std::string& line : result.missing) text += "missing: " + line + "\n";
  return text;
}

}  // namespace tetproof::corpus
