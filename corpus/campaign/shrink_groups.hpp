// SPDX-License-Identifier: GPL-3.0-or-later
// Shrinks the smallest case of each new group and writes it as a finding. Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/campaign/journal.hpp"
#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// Whether a run fails as the group does. The group's signature comes from the journal, which replaces bytes
/// that are no UTF-8 and cuts long text.
bool belongs_to(const Judgement& judgement, const FailureGroup& group);

/// How often a case that failed in `failed` of `repeats` runs must run so that it fails at least once with a
/// probability of 99 %; at most 50.
int runs_to_fail(int failed, int repeats);

/// The folder of a finding inside the campaign's: the group in letters that every file system takes, and a
/// checksum that tells it from others.
std::string finding_folder(const std::string& group, const CaseResult& smallest, std::uint64_t seed);

/// For each group that is not known, and whose smallest case is not in `shrunk` yet: shrinks the case within
/// `options.shrink_s` (0: leaves it as it is), writes its finding, keeps the record in the journal and in
/// `shrunk`.
void shrink_groups(const std::vector<const Mesher*>& meshers, const CampaignOptions& options,
                   const std::vector<FailureGroup>& groups, Journal& journal, const std::string& scratch,
                   std::int64_t cases_run, std::vector<ShrunkCase>& shrunk);

}  // namespace tetproof::corpus
