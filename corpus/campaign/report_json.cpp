// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "corpus/campaign/settings.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

Json tally_json(const std::vector<TallyRow>& rows) {
  Json json = Json::object();
  for (const auto& [name, tally] : rows) {
    Json& row = json[name];
    row["cases"] = tally.cases();
    for (const Outcome outcome : outcomes_in_order()) row[name_of(outcome)] = tally.count(outcome);
  }
  return json;
}

Json case_json(const CaseResult& r) {
  return {{"case", r.index},          {"mesher", r.mesher},   {"outcome", name_of(r.outcome)},
          {"signature", r.signature}, {"what", r.what},       {"triangles", r.triangles},
          {"recipe", r.recipe},       {"repeats", r.repeats}, {"failed", r.failed}};
}

Json group_json(const CampaignResult& result, const FailureGroup& group) {
  const CaseResult& first = group.cases.front();
  Json json;
  json["id"] = group.id();
  json["mesher"] = group.mesher;
  json["outcome"] = name_of(group.outcome);
  json["signature"] = group.signature;
  json["known"] = group.known;
  json["variants"] = group.variants;
  json["surfaces"] = group.surfaces;
  json["replay"] = replay_command(result.settings, first.index, first.mesher);
  if (const ShrunkCase* shrunk = shrunk_of_group(result, group))
    json["shrunk"] = {{"triangles", shrunk->triangles}, {"repeats", shrunk->repeats},
                      {"failed", shrunk->failed},       {"steps", shrunk->steps},
                      {"recipe", shrunk->recipe},       {"folder", shrunk->folder}};
  json["cases"] = Json::array();
  for (const CaseResult& member : group.cases) json["cases"].push_back(case_json(member));
  return json;
}

}  // namespace

std::string campaign_json(const CampaignResult& result) {
  Json json;
  json["summary"] = summary_line(result);
  const Tally all = tally_of_all(result);
  json["findings"] = all.findings();
  json["new_groups"] = new_groups(result);
  json["unjudged"] = all.unjudged();
  json["surfaces"] = result.surfaces;
  json["settings"] = settings_json(result.settings);
  json["by_mesher"] = tally_json(tally_by_mesher(result));
  json["by_kind"] = tally_json(tally_by_kind(result));
  json["groups"] = Json::array();
  for (const FailureGroup& group : result.groups) json["groups"].push_back(group_json(result, group));
  json["known_unseen"] = result.known_unseen;
  json["missing"] = result.missing;
  json["not_sound"] = Json::array();  // and no finding: each by its name
  for (const CaseResult& one : result.cases)
    if (one.outcome != Outcome::sound && !is_finding(one.outcome))
      json["not_sound"].push_back(case_json(one));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tetproof::corpus
