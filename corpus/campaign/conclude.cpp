// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/conclude.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace tetproof::corpus {
namespace {

void sort(std::vector<CaseResult>& cases, const std::vector<MesherFacts>& meshers) {
  std::map<std::string, std::size_t> place;
  for (const MesherFacts& mesher : meshers) place.emplace(mesher.name, place.size());
  std::sort(cases.begin(), cases.end(), [&](const CaseResult& a, const CaseResult& b) {
    return std::pair(a.index, place.at(a.mesher)) < std::pair(b.index, place.at(b.mesher));
  });
}

}  // namespace

CampaignResult conclude(CampaignSettings settings, std::vector<CaseResult> cases,
                        std::vector<ShrunkCase> shrunk, const std::vector<std::string>& known) {
  CampaignResult result;
  result.cases = std::move(cases);
  sort(result.cases, settings.meshers);
  result.groups = group_failures(result.cases, known);
  std::set<std::uint64_t> surfaces;
  for (const CaseResult& one : result.cases) surfaces.insert(one.index);
  result.surfaces = static_cast<std::int64_t>(surfaces.size());

  std::set<std::string> seen;
  for (const FailureGroup& group : result.groups) {
    const std::string id = group.id();
    seen.insert(id);
    const CaseResult& smallest = group.cases.front();
    const auto last = std::find_if(shrunk.rbegin(), shrunk.rend(), [&](const ShrunkCase& one) {
      return std::tie(one.group, one.index, one.mesher) == std::tie(id, smallest.index, smallest.mesher);
    });
    if (last != shrunk.rend()) result.shrunk.push_back(std::move(*last));
  }
  if (settings.shards == 1) {
    const std::set<std::string> sorted(known.begin(), known.end());
    for (const std::string& id : sorted)
      if (!seen.contains(id)) result.known_unseen.push_back(id);
  }
  result.settings = std::move(settings);
  return result;
}

}  // namespace tetproof::corpus
