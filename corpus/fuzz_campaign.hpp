// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a mesher on many random surfaces, judges what it writes, groups and shrinks what is wrong.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/judgement.hpp"
#include "corpus/meshing/mesher.hpp"

namespace tetproof::corpus {

/// One case: one surface, one mesher, all repeats.
struct CaseResult {
  std::uint64_t index = 0;
  std::string mesher;  ///< name, with the variant
  std::string recipe;  ///< recipe_text
  std::int64_t triangles = 0;
  Outcome outcome = Outcome::sound;  ///< the worst of the repeats
  std::string signature;             ///< of `outcome`
  std::string what;
  int repeats = 1, failed = 0;    ///< "3 of 20"
  double cpu_s = 0, judge_s = 0;  ///< of all repeats
};

/// Cases that fail for the same cause, as far as one can tell from outside.
struct FailureGroup {
  std::string mesher;
  Outcome outcome{};
  std::string signature;
  std::vector<CaseResult> cases;  ///< the smallest surface first
  bool known = false;
  std::string id() const;  ///< "tetgen:crashed:insertpoint_cdt: ...": what a file of known groups lists
};

struct CampaignOptions {
  std::uint64_t seed = 1, cases = 100;
  std::uint64_t shard = 0, shards = 1;  ///< cases with index % shards == shard
  FuzzOptions surfaces{};
  Limits limits{};
  JudgeOptions judge{};
  int repeats = 0;                   ///< 0: as the mesher says
  int threads = 0;                   ///< cases at once; 0: one for each core
  double shrink_s = 0;               ///< for each group; 0: not shrunk
  std::string folder{};              ///< the journal and the findings; empty: nothing is kept
  std::vector<std::string> known{};  ///< ids of groups
  std::function<void(const CaseResult&)> progress{};  ///< called after each case, one at a time
};

struct CampaignResult {
  std::vector<CaseResult> cases;     ///< in the order of their indices, then meshers
  std::vector<FailureGroup> groups;  ///< findings only, most serious outcome first
  std::int64_t surfaces = 0;
};

/// Runs the cases that the journal in the folder does not have yet, and reports on all.
CampaignResult run_campaign(const std::vector<const Mesher*>& meshers, const CampaignOptions& options);

/// The groups of `cases`.
std::vector<FailureGroup> group_failures(const std::vector<CaseResult>& cases,
                                         const std::vector<std::string>& known = {});

}  // namespace tetproof::corpus
