// SPDX-License-Identifier: GPL-3.0-or-later
// What is common to a campaign that ran and one that was merged: order, groups, counts. Not installed.
#pragma once

#include <string>
#include <vector>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// Sorts the cases by index and mesher, groups them, counts the surfaces, names known groups that did not
/// occur (only of all shards together), and keeps those of `shrunk` that are of a group's smallest case.
CampaignResult conclude(CampaignSettings settings, std::vector<CaseResult> cases,
                        std::vector<ShrunkCase> shrunk, const std::vector<std::string>& known);

}  // namespace tetproof::corpus
