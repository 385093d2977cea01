// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/case_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "corpus/campaign/scratch_folder.hpp"

namespace tetproof::corpus {

JudgedRun run_and_judge(const Mesher& mesher, const verify::JudgedSurface& surface, const std::string& folder,
                        const Limits& limits, const JudgeOptions& judge) {
  JudgedRun judged;
  judged.run = mesher.run(surface.surface(), folder, limits);
  judged.judgement = judge_run(judged.run, mesher, surface, judge);
  return judged;
}

int repeats_of(const Mesher& mesher, int asked) {
  return std::max(1, asked > 0 ? asked : mesher.repeats());
}

void add_up(CaseResult& result, const std::vector<Judgement>& judgements) {
  // Sorted so that the first is the worst; of several signatures of one outcome the most frequent one.
  struct Kind {
    int failed = 0;
    const Judgement* first = nullptr;
  };
  std::map<std::tuple<int, std::string>, Kind> kinds;
  for (const Judgement& judgement : judgements) {
    Kind& kind = kinds[{-severity(judgement.outcome), judgement.signature}];
    ++kind.failed;
    if (!kind.first) kind.first = &judgement;
  }
  const Kind* worst = nullptr;
  for (const auto& [key, kind] : kinds)
    if (!worst || (kind.first->outcome == worst->first->outcome && kind.failed > worst->failed))
      worst = &kind;
  result.outcome = worst->first->outcome;
  result.signature = worst->first->signature;
  result.what = worst->first->what;
  result.repeats = static_cast<int>(judgements.size());
  result.failed = result.outcome == Outcome::sound ? 0 : worst->failed;
  for (const auto& [key, kind] : kinds)
    if (&kind != worst && (is_finding(kind.first->outcome) || is_unjudged(kind.first->outcome)))
      result.further.push_back({.outcome = kind.first->outcome,
                                .signature = kind.first->signature,
                                .what = kind.first->what,
                                .failed = kind.failed});
}

CaseResult run_case(const Mesher& mesher, const verify::JudgedSurface& surface, std::uint64_t index,
                    const std::string& scratch, const CampaignOptions& options) {
  CaseResult result{.index = index, .mesher = mesher.name()};
  result.triangles = static_cast<std::int64_t>(surface.surface().triangles.size());
  std::vector<Judgement> judgements;
  for (int r = 0; r < repeats_of(mesher, options.repeats); ++r) {
    const ScratchFolder folder(fmt::format("{}/{}-{}", scratch, index, r));
    JudgedRun judged = run_and_judge(mesher, surface, folder.path(), options.limits, options.judge);
    result.cpu_s += judged.run.cpu_s;
    result.judge_s += judged.judgement.seconds;
    judged.judgement.report.reset();
    judgements.push_back(std::move(judged.judgement));
  }
  add_up(result, judgements);
  return result;
}

}  // namespace tetproof::corpus
