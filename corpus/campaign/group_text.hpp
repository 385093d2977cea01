// SPDX-License-Identifier: GPL-3.0-or-later
// What is known about a group of failures, for people. Internal.
#pragma once

#include <string>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// Lines: the group's name with its number, its cases, what the mesher or the judge says, the smallest case,
/// what it was shrunk to, and the command that runs it again.
std::string group_text(const CampaignResult& result, const FailureGroup& group, std::size_t number);

}  // namespace tetproof::corpus
