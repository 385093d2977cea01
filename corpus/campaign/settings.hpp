// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a campaign as JSON, and in what two of them differ. Not installed.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

nlohmann::ordered_json settings_json(const CampaignSettings& settings);
/// Throws what nlohmann-json throws, or InputError, if it is none.
CampaignSettings settings_of(const nlohmann::ordered_json& json);

/// More shards than anyone has machines: what names them one by one must end.
inline constexpr std::uint64_t most_shards = 1'000'000;

/// InputError if the shard is none, or if there are more than `most_shards`.
void check_shard(std::uint64_t shard, std::uint64_t shards);

/// "seed: 1, not 2; cpu_s: 5.0, not 10.0": where `there` is not what is wanted. Empty: nowhere. The shard
/// counts only with `with_shard`.
std::string differences(const CampaignSettings& there, const CampaignSettings& wanted, bool with_shard);

/// The command line of tetproof-fuzz that runs one case again.
std::string replay_command(const CampaignSettings& settings, std::uint64_t index, const std::string& mesher);

/// What a group names as its mesher: the preset without the variant.
std::string preset_of(const std::string& mesher);

}  // namespace tetproof::corpus
