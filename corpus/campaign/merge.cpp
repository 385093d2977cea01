// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iterator>
#include <map>

#include "corpus/campaign/conclude.hpp"
#include "corpus/campaign/journal.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

struct Shard {
  std::string path;
  JournalContent content;
};

// The number of cases, each of one surface and one mesher, that belong to a shard.
std::uint64_t size_of_shard(const CampaignSettings& s, std::uint64_t shard) {
  const std::uint64_t surfaces = s.cases > shard ? (s.cases - shard - 1) / s.shards + 1 : 0;
  return surfaces * s.meshers.size();
}

}  // namespace

CampaignResult merge_campaign(const std::vector<std::string>& folders,
                              const std::vector<std::string>& known) {
  if (folders.empty()) throw InputError("expected at least one folder of a campaign");
  std::map<std::uint64_t, Shard> shards;
  const Shard* first = nullptr;
  for (const std::string& folder : folders) {
    const std::vector<std::string> paths = journals_in(folder);
    if (paths.empty()) throw InputError(fmt::format("{}: there is no journal of a campaign", folder));
    for (const std::string& path : paths) {
      Shard shard{path, read_journal(path)};
      if (shard.content.bytes == 0) continue;  // killed before its first line: it counts as missing
      const std::uint64_t number = shard.content.settings.shard;
      if (first) {
        const std::string different = differences(shard.content.settings, first->content.settings, false);
        if (!different.empty())
          throw InputError(
              fmt::format("{}: is of another campaign than {}: {}", path, first->path, different));
      }
      const auto [place, added] = shards.emplace(number, std::move(shard));
      if (!added) throw InputError(fmt::format("{}: has the same shard as {}", path, place->second.path));
      if (!first) first = &place->second;
    }
  }
  if (!first) throw InputError(fmt::format("{}: the journal is empty", folders.front()));

  CampaignSettings settings = first->content.settings;
  std::vector<CaseResult> cases;
  std::vector<ShrunkCase> shrunk;
  std::vector<std::string> missing;
  for (std::uint64_t s = 0; s < settings.shards; ++s) {
    const std::uint64_t expected = size_of_shard(settings, s);
    const auto place = shards.find(s);
    if (place == shards.end()) {
      if (expected > 0) missing.push_back(fmt::format("shard {} of {} is missing", s, settings.shards));
      continue;
    }
    JournalContent& content = place->second.content;
    if (content.cases.size() < expected)
      missing.push_back(fmt::format("shard {} of {} lacks {} of {} cases", s, settings.shards,
                                    expected - content.cases.size(), expected));
    std::move(content.cases.begin(), content.cases.end(), std::back_inserter(cases));
    std::move(content.shrunk.begin(), content.shrunk.end(), std::back_inserter(shrunk));
  }
  settings.shard = 0;
  settings.shards = 1;  // the report is that of one run
  CampaignResult result = conclude(std::move(settings), std::move(cases), std::move(shrunk), known);
  result.missing = std::move(missing);
  return result;
}

}  // namespace tetproof::corpus
