// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one mesher on one surface as often as asked, and judges each run. Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/fuzz_campaign.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {

/// One run with its verdict.
struct JudgedRun {
  MesherRun run;
  Judgement judgement;
};

/// Runs in `folder`, which exists, and judges.
JudgedRun run_and_judge(const Mesher& mesher, const verify::JudgedSurface& surface, const std::string& folder,
                        const Limits& limits, const JudgeOptions& judge);

/// What several runs of one case amount to: the worst outcome with its most frequent signature, the other
/// findings, and runs that were not judged.
void add_up(CaseResult& result, const std::vector<Judgement>& judgements);

/// How often a mesher runs on each surface.
int repeats_of(const Mesher& mesher, int asked);

/// Case `index`: all repeats, each in a folder of its own inside `scratch`.
CaseResult run_case(const Mesher& mesher, const verify::JudgedSurface& surface, std::uint64_t index,
                    const std::string& scratch, const CampaignOptions& options);

}  // namespace tetproof::corpus
