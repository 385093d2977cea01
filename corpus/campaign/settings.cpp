// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/settings.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "corpus/meshing/command_words.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

// A value for one line of text. Long lists (the meshers) are compared piece by piece before they come here.
std::string shown(const Json& value) {
  return value.is_string() ? fmt::format("'{}'", value.get<std::string>())
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Collects the leaves in which two objects differ, with the path of their keys.
void compare(const Json& there, const Json& wanted, const std::string& path,
             std::vector<std::string>& found) {
  if (there == wanted) return;
  if (there.is_object() && wanted.is_object()) {
    for (const auto& [key, value] : wanted.items()) {
      const std::string name = path.empty() ? key : path + "." + key;
      if (there.contains(key))
        compare(there.at(key), value, name, found);
      else
        found.push_back(fmt::format("{}: nothing, not {}", name, shown(value)));
    }
    return;
  }
  found.push_back(fmt::format("{}: {}, not {}", path, shown(there), shown(wanted)));
}

void compare_meshers(const CampaignSettings& there, const CampaignSettings& wanted,
                     std::vector<std::string>& found) {
  const auto names = [](const CampaignSettings& settings) {
    std::vector<std::string> all;
    for (const MesherFacts& mesher : settings.meshers) all.push_back(mesher.name);
    return all;
  };
  if (names(there) != names(wanted)) {
    found.push_back(
        fmt::format("meshers: {}, not {}", fmt::join(names(there), " "), fmt::join(names(wanted), " ")));
    return;
  }
  const Json a = settings_json(there).at("meshers"), b = settings_json(wanted).at("meshers");
  for (std::size_t m = 0; m < a.size(); ++m) compare(a[m], b[m], there.meshers[m].name, found);
}

}  // namespace

Json settings_json(const CampaignSettings& s) {
  Json json;
  json["version"] = s.version;
  json["seed"] = s.seed;
  json["cases"] = s.cases;
  json["shard"] = s.shard;
  json["shards"] = s.shards;
  json["surfaces"] = {{"kinds", s.surfaces.kinds},
                      {"modifiers", s.surfaces.modifiers},
                      {"most_triangles", s.surfaces.most_triangles},
                      {"extreme_sizes", s.surfaces.extreme_sizes}};
  json["limits"] = {
      {"cpu_s", s.limits.cpu_s}, {"wall_s", s.limits.wall_s}, {"memory_mb", s.limits.memory_mb}};
  json["judge"] = {{"tolerance", s.judge.tolerance}, {"seconds", s.judge.seconds}, {"check", s.judge.check}};
  json["repeats"] = s.repeats;
  json["meshers"] = Json::array();
  for (const MesherFacts& mesher : s.meshers)
    json["meshers"].push_back({{"name", mesher.name},
                               {"command", mesher.command},
                               {"version", mesher.version},
                               {"repeats", mesher.repeats},
                               {"words", mesher.words}});
  return json;
}

CampaignSettings settings_of(const Json& json) {
  CampaignSettings s;
  json.at("version").get_to(s.version);
  json.at("seed").get_to(s.seed);
  json.at("cases").get_to(s.cases);
  json.at("shard").get_to(s.shard);
  json.at("shards").get_to(s.shards);
  const Json& surfaces = json.at("surfaces");
  surfaces.at("kinds").get_to(s.surfaces.kinds);
  surfaces.at("modifiers").get_to(s.surfaces.modifiers);
  surfaces.at("most_triangles").get_to(s.surfaces.most_triangles);
  surfaces.at("extreme_sizes").get_to(s.surfaces.extreme_sizes);
  const Json& limits = json.at("limits");
  limits.at("cpu_s").get_to(s.limits.cpu_s);
  limits.at("wall_s").get_to(s.limits.wall_s);
  limits.at("memory_mb").get_to(s.limits.memory_mb);
  const Json& judge = json.at("judge");
  judge.at("tolerance").get_to(s.judge.tolerance);
  judge.at("seconds").get_to(s.judge.seconds);
  judge.at("check").get_to(s.judge.check);
  json.at("repeats").get_to(s.repeats);
  for (const Json& mesher : json.at("meshers"))
    s.meshers.push_back({.name = mesher.at("name"),
                         .command = mesher.at("command"),
                         .version = mesher.at("version"),
                         .repeats = mesher.at("repeats"),
                         .words = mesher.at("words").get<std::vector<std::string>>()});
  return s;
}

void check_shard(std::uint64_t shard, std::uint64_t shards) {
  if (shards > most_shards)
    throw InputError(fmt::format("expected at most {} shards, found {}", most_shards, shards));
  if (shard >= shards)
    throw InputError(
        fmt::format("expected a shard from 0 to below the number of shards, found {} of {}", shard, shards));
}

std::string differences(const CampaignSettings& there, const CampaignSettings& wanted, bool with_shard) {
  std::vector<std::string> found;
  Json a = settings_json(there), b = settings_json(wanted);
  for (Json* json : {&a, &b}) {
    json->erase("meshers");
    if (!with_shard) json->erase("shard");
  }
  compare(a, b, "", found);
  compare_meshers(there, wanted, found);
  return fmt::format("{}", fmt::join(found, "; "));
}

std::string replay_command(const CampaignSettings& s, std::uint64_t index, const std::string& mesher) {
  const CampaignSettings usual;
  std::string line = fmt::format("tetproof-fuzz --replay {}:{}", s.seed, index);
  const auto list = [&](const char* option, const std::vector<std::string>& words) {
    if (!words.empty())
      line += fmt::format(" {} {}", option, shell_word(fmt::format("{}", fmt::join(words, ","))));
  };
  list("--kinds", s.surfaces.kinds);
  list("--modifiers", s.surfaces.modifiers);
  if (s.surfaces.most_triangles != usual.surfaces.most_triangles)
    line += fmt::format(" --most-triangles {}", s.surfaces.most_triangles);
  if (s.surfaces.extreme_sizes) line += " --extreme-sizes";
  if (s.limits.cpu_s != usual.limits.cpu_s) line += fmt::format(" --cpu {}", s.limits.cpu_s);
  if (s.limits.wall_s != usual.limits.wall_s) line += fmt::format(" --wall {}", s.limits.wall_s);
  if (s.limits.memory_mb != usual.limits.memory_mb) line += fmt::format(" --memory {}", s.limits.memory_mb);
  if (s.repeats != usual.repeats) line += fmt::format(" --repeat {}", s.repeats);
  list("--check", s.judge.check);
  for (const MesherFacts& facts : s.meshers)
    if (facts.name == mesher && !facts.words.empty()) {
      for (const std::string& word : facts.words) line += fmt::format(" {}", shell_word(word));
      return line;
    }
  return "";
}

std::string preset_of(const std::string& mesher) {
  return mesher.substr(0, mesher.find(','));
}

}  // namespace tetproof::corpus
