// SPDX-License-Identifier: GPL-3.0-or-later
// Runs meshers on many random surfaces, judges what they write, groups and shrinks what is wrong.
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

/// Another finding in the repeats of a case, beside the worst one.
struct FurtherFailure {
  Outcome outcome{};
  std::string signature, what;
  int failed = 0;  ///< of the repeats
};

/// One case: one surface, one mesher, all repeats.
struct CaseResult {
  std::uint64_t index = 0;
  std::string mesher;  ///< name, with the variant
  std::string recipe;  ///< recipe_text
  std::int64_t triangles = 0;
  Outcome outcome = Outcome::sound;  ///< the worst of the repeats
  std::string signature;             ///< of `outcome`
  std::string what;
  int repeats = 1, failed = 0;            ///< "3 of 20": the runs with this outcome and signature
  std::vector<FurtherFailure> further{};  ///< other findings among the repeats, and runs that were not judged
  double cpu_s = 0, judge_s = 0;          ///< of all repeats
};

/// Cases that fail for the same cause, as far as one can tell from outside: the same preset, outcome and
/// signature, whatever the variant. Where several variants fail on one surface, their cases are neighbours.
struct FailureGroup {
  std::string mesher;  ///< the preset: the name without the variant
  Outcome outcome{};
  std::string signature;
  std::vector<CaseResult> cases;        ///< the smallest surface first; with `outcome` and `signature`
  std::vector<std::string> variants{};  ///< the names of the meshers in `cases`, sorted
  std::int64_t surfaces = 0;            ///< the number of different ones in `cases`
  bool known = false;
  std::string id() const;  ///< "tetgen:crashed:insertpoint_cdt: ...": what a file of known groups lists
};

/// A mesher as reports name it.
struct MesherFacts {
  std::string name, command, version;
  int repeats = 1;
  /// The words of a command line of tetproof-fuzz that choose it: "--mesher", "tetgen,pq"; or options and
  /// "--", "COMMAND", ... Empty: a C++ function.
  std::vector<std::string> words{};
  bool operator==(const MesherFacts&) const = default;
};

/// What the results of a campaign depend on. A journal keeps it, and is continued with equal settings only.
struct CampaignSettings {
  std::uint64_t seed = 1, cases = 100;
  std::uint64_t shard = 0, shards = 1;
  FuzzOptions surfaces{};
  Limits limits{};
  JudgeOptions judge{};
  int repeats = 0;  ///< 0: as the mesher says
  std::vector<MesherFacts> meshers{};
  std::string version{};  ///< of the program
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
  std::function<void(std::uint64_t done)>
      started{};  ///< called first, with the results that are there already
  /// Called with a line when a group is being shrunk.
  std::function<void(const std::string&)> say{};
  std::vector<std::vector<std::string>> words{};  ///< of each mesher, for `MesherFacts`; empty: none
  std::string version{};                          ///< of the program
  /// Another source of surfaces than `fuzz_surface`: a pure function of the index.
  std::function<FuzzSurface(std::uint64_t index)> surface_of{};
};

/// The smallest case of a group, shrunk.
struct ShrunkCase {
  std::string group;  ///< its id
  std::uint64_t index = 0;
  std::string mesher;
  std::int64_t triangles = 0;     ///< after shrinking
  int repeats = 1, failed = 0;    ///< of the shrunk surface; failed 0: the failure did not occur again
  std::string steps{}, recipe{};  ///< what was done; the shrunk recipe if the surface is still what it builds
  std::string folder{};           ///< of the finding, inside the campaign's folder; empty: none
  std::int64_t calls = 0;         ///< of the mesher, for shrinking
  double seconds = 0;
  double asked_s =
      0;  ///< wall time that shrinking was allowed [s]; a campaign that allows more shrinks again
};

struct CampaignResult {
  std::vector<CaseResult> cases;     ///< in the order of their indices, then meshers
  std::vector<FailureGroup> groups;  ///< findings only, most serious outcome first
  std::int64_t surfaces = 0;
  CampaignSettings settings{};
  std::vector<ShrunkCase> shrunk{};         ///< in the order of the groups
  std::vector<std::string> known_unseen{};  ///< known ids that did not occur
  /// What is missing of merged shards, a line each: "shard 3 of 8 is missing", "shard 2 of 8 lacks 17 of 250
  /// cases". Empty: nothing.
  std::vector<std::string> missing{};
};

/// Runs the cases that the journal in the folder does not have yet, and reports on all. The result is the
/// same for any number of threads, and whether or not it was interrupted, except for times.
///
/// InputError if the journal is in use, was made with other settings, or cannot be written. std::logic_error,
/// with seed and index, if a surface cannot be built or is not what its recipe promises.
CampaignResult run_campaign(const std::vector<const Mesher*>& meshers, const CampaignOptions& options);

/// Reads the journals in the folders and reports as one run of all shards would. `missing` names what is not
/// there. InputError if there is no journal, if two have different settings, or the same shard twice.
CampaignResult merge_campaign(const std::vector<std::string>& folders,
                              const std::vector<std::string>& known = {});

/// The groups of `cases`.
std::vector<FailureGroup> group_failures(const std::vector<CaseResult>& cases,
                                         const std::vector<std::string>& known = {});

/// Whether an outcome says nothing about the mesher's answer, because there was none to look at: slow,
/// out_of_memory, not_compiled_in, not_judged. A campaign with such cases is not called sound.
bool is_unjudged(Outcome outcome);

/// How serious an outcome is: larger is worse. Wrong answers come before crashes, findings before the rest.
int severity(Outcome outcome);

/// The report for people: tables by mesher and by kind of surface, and the groups.
std::string campaign_text(const CampaignResult& result);
/// The report as JSON, without times: the same results give the same bytes.
std::string campaign_json(const CampaignResult& result);
/// The report as JUnit XML: a test suite for each mesher, a failure for each new group.
std::string campaign_junit(const CampaignResult& result);

}  // namespace tetproof::corpus
