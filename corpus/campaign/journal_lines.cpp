// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/journal_lines.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "corpus/campaign/journal.hpp"
#include "corpus/campaign/settings.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_key = "tetproof_fuzz_journal";
constexpr int format_version = 1;

// What a mesher says may be long. A journal of a million cases should still be read in seconds.
constexpr std::size_t longest_text = 1000;

std::string cut(const std::string& text) {
  return text.size() <= longest_text ? text : text.substr(0, longest_text) + "...";
}

std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Outcome outcome_of(const Json& json) {
  const std::string name = json.get<std::string>();
  if (const std::optional<Outcome> outcome = outcome_of_name(name)) return *outcome;
  throw InputError(fmt::format("expected the name of an outcome, found '{}'", name));
}

}  // namespace

std::string header_line(const CampaignSettings& settings) {
  Json json{{format_key, format_version}};
  json["settings"] = settings_json(settings);
  return line(json);
}

std::string line_of(const CaseResult& r) {
  Json json;
  json["case"] = r.index;
  json["mesher"] = r.mesher;
  json["outcome"] = name_of(r.outcome);
  json["signature"] = cut(r.signature);
  json["what"] = cut(r.what);
  json["triangles"] = r.triangles;
  json["recipe"] = r.recipe;
  json["repeats"] = r.repeats;
  json["failed"] = r.failed;
  for (const FurtherFailure& more : r.further)
    json["further"].push_back({{"outcome", name_of(more.outcome)},
                               {"signature", cut(more.signature)},
                               {"what", cut(more.what)},
                               {"failed", more.failed}});
  json["cpu_s"] = r.cpu_s;
  json["judge_s"] = r.judge_s;
  return line(json);
}

std::string line_of(const ShrunkCase& s) {
  return line({{"shrunk", s.group},
               {"case", s.index},
               {"mesher", s.mesher},
               {"triangles", s.triangles},
               {"repeats", s.repeats},
               {"failed", s.failed},
               {"steps", s.steps},
               {"recipe", s.recipe},
               {"folder", s.folder},
               {"calls", s.calls},
               {"seconds", s.seconds},
               {"asked_s", s.asked_s}});
}

bool is_header(const Json& json) {
  return json.is_object() && json.contains(format_key);
}

bool is_shrunk(const Json& json) {
  return json.is_object() && json.contains("shrunk");
}

CampaignSettings header_of(const Json& json) {
  if (json.at(format_key) != format_version)
    throw InputError(fmt::format("expected a journal of format {}, found format {}", format_version,
                                 json.at(format_key).dump()));
  return settings_of(json.at("settings"));
}

CaseResult case_of(const Json& json) {
  CaseResult r;
  json.at("case").get_to(r.index);
  json.at("mesher").get_to(r.mesher);
  r.outcome = outcome_of(json.at("outcome"));
  json.at("signature").get_to(r.signature);
  json.at("what").get_to(r.what);
  json.at("triangles").get_to(r.triangles);
  json.at("recipe").get_to(r.recipe);
  json.at("repeats").get_to(r.repeats);
  json.at("failed").get_to(r.failed);
  if (json.contains("further"))
    for (const Json& more : json.at("further"))
      r.further.push_back({.outcome = outcome_of(more.at("outcome")),
                           .signature = more.at("signature"),
                           .what = more.at("what"),
                           .failed = more.at("failed")});
  json.at("cpu_s").get_to(r.cpu_s);
  json.at("judge_s").get_to(r.judge_s);
  return r;
}

ShrunkCase shrunk_of(const Json& json) {
  ShrunkCase s;
  json.at("shrunk").get_to(s.group);
  json.at("case").get_to(s.index);
  json.at("mesher").get_to(s.mesher);
  json.at("triangles").get_to(s.triangles);
  json.at("repeats").get_to(s.repeats);
  json.at("failed").get_to(s.failed);
  json.at("steps").get_to(s.steps);
  json.at("recipe").get_to(s.recipe);
  json.at("folder").get_to(s.folder);
  json.at("calls").get_to(s.calls);
  json.at("seconds").get_to(s.seconds);
  s.asked_s = json.value("asked_s", 0.0);
  return s;
}

CaseResult as_journalled(const CaseResult& result) {
  return case_of(Json::parse(line_of(result)));
}

}  // namespace tetproof::corpus
