// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one mesher on one surface as often as asked, and judges each run. Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/fuzz_campaign.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {

/// A folder that is removed with all that is in it.
class ScratchFolder {
 public:
  /// Makes the folder `path`, empty, or one in the system's folder for temporary files if `path` is empty.
  /// InputError if that is not possible.
  explicit ScratchFolder(std::string path);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }  ///< absolute
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// One run with its verdict.
struct JudgedRun {
  MesherRun run;
  Judgement judgement;
};

/// Runs in `folder`, which exists, and judges.
JudgedRun run_and_judge(const Mesher& mesher, const verify::JudgedSurface& surface, const std::string& folder,
                        const Limits& limits, const JudgeOptions& judge);

/// What several runs of one case amount to: the worst outcome with its most frequent signature, and the other
/// findings.
void add_up(CaseResult& result, const std::vector<Judgement>& judgements);

/// How often a mesher runs on each surface.
int repeats_of(const Mesher& mesher, int asked);

/// Case `index`: all repeats, each in a folder of its own inside `scratch`.
CaseResult run_case(const Mesher& mesher, const verify::JudgedSurface& surface, std::uint64_t index,
                    const std::string& scratch, const CampaignOptions& options);

}  // namespace tetproof::corpus
