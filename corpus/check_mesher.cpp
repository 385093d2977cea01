// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/check_mesher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <system_error>
#include <vector>

#include "corpus/campaign/case_run.hpp"
#include "corpus/campaign/journal.hpp"
#include "corpus/campaign/shrink_groups.hpp"
#include "corpus/campaign/tallies.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/surface_files.hpp"
#include "verify/findings_text.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;

// Removes what an earlier run left, and only that: the folder may be the user's.
void remove_results(const std::string& folder, const CheckOptions& o) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", folder, error.message()));
  fs::remove(folder + "/" +
             journal_name(static_cast<std::uint64_t>(o.slice), static_cast<std::uint64_t>(o.slices)));
  fs::remove_all(folder + "/findings");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        name.starts_with("running-") && name.ends_with(".off"))
      fs::remove(entry.path());
}

// The function, with its surface in a file while it runs.
MeshFunction recorded(const MeshFunction& function, const std::string& folder) {
  return [&function, folder,
          calls = std::make_shared<std::atomic<std::uint64_t>>(0)](const TriangleSurface& surface) {
    struct Record {
      std::string path;
      ~Record() {
        std::error_code ignored;
        fs::remove(path, ignored);
      }
    };
    const Record record{fmt::format("{}/running-{}.off", folder, calls->fetch_add(1))};
    write_surface(record.path, surface);
    return function(surface);
  };
}

std::string indented(const std::string& text) {
  std::string result = "   ";
  for (const char c : text) {
    result += c;
    if (c == '\n') result += "   ";
  }
  while (!result.empty() && (result.back() == ' ' || result.back() == '\n')) result.pop_back();
  return result + "\n";
}

// What is wrong, in as much detail as there is; with the indices of the TetMesh that the function gave.
std::string words_of(const JudgedRun& judged) {
  const Judgement& judgement = judged.judgement;
  std::string text = fmt::format("{}: {}", name_of(judgement.outcome), judgement.signature);
  if (!judgement.report) return text + (judgement.what == judgement.signature ? "" : "\n" + judgement.what);
  return text + "\n" + verify::failure_text(*judgement.report);
}

// The findings on a group's smallest surface; those of the campaign if it does not fail again.
std::string findings_of(const Mesher& mesher, const FailureGroup& group, const std::string& file,
                        const JudgeOptions& judge) {
  const TriangleSurface surface = read_surface(file);
  const JudgedRun again = run_and_judge(mesher, verify::JudgedSurface(surface), "", {}, judge);
  if (belongs_to(again.judgement, group)) return words_of(again);
  return fmt::format("{}: {}\nnot seen again on this surface: does the function depend on more than it?",
                     name_of(group.outcome), group.cases.front().what);
}

std::string group_words(const Mesher& mesher, const CampaignResult& result, const FailureGroup& group,
                        const std::string& folder, const JudgeOptions& judge) {
  const CaseResult& first = group.cases.front();
  std::string text;
  if (const ShrunkCase* shrunk = shrunk_of_group(result, group); shrunk && !shrunk->folder.empty()) {
    const std::string file = fmt::format("{}/{}/surface.off", folder, shrunk->folder);
    text += fmt::format("{}: {}\n", io::counted(shrunk->triangles, "triangles"), file);
    text += findings_of(mesher, group, file, judge);
  } else {
    text +=
        fmt::format("fuzz:{} ({}): {}\nnot seen again: does the function depend on more than the surface?",
                    first.recipe, io::counted(first.triangles, "triangles"), first.what);
  }
  return indented(text);
}

}  // namespace

MesherCheck check_mesher(const MeshFunction& function, const CheckOptions& o) {
  if (o.slices < 1 || o.slice < 0 || o.slice >= o.slices)
    throw InputError(fmt::format("slice {} of {}: there is no such slice", o.slice, o.slices));
  if (o.cases < static_cast<std::uint64_t>(o.slices))
    throw InputError(
        fmt::format("{} in {} slices: some would be empty", io::counted(o.cases, "cases"), o.slices));
  const std::string folder =
      o.slices == 1 ? o.folder : fmt::format("{}/slice-{}-of-{}", o.folder, o.slice, o.slices);
  remove_results(folder, o);
  const auto mesher = function_mesher(recorded(function, folder), o.name);
  const CampaignResult result = run_campaign({mesher.get()}, {.seed = o.seed,
                                                              .cases = o.cases,
                                                              .shard = static_cast<std::uint64_t>(o.slice),
                                                              .shards = static_cast<std::uint64_t>(o.slices),
                                                              .surfaces = o.surfaces,
                                                              .judge = o.judge,
                                                              .threads = o.threads,
                                                              .shrink_s = o.shrink_s,
                                                              .folder = folder});
  const Tally all = tally_of_all(result);
  MesherCheck check{.good = all.findings() == 0 && all.unjudged() == 0 && all.count(Outcome::sound) > 0,
                    .message = summary_line(result) + "\n"};
  int told = 0;
  for (const FailureGroup& group : result.groups) {
    check.message +=
        fmt::format("{}. {}: {}\n", told + 1, group.id(), io::counted(group.cases.size(), "cases"));
    if (told++ < o.most_told) check.message += group_words(*mesher, result, group, folder, o.judge);
  }
  if (all.count(Outcome::sound) == 0) check.message += "not one mesh is sound\n";
  // What was refused or not judged, by its words: the first case of each.
  std::vector<std::string> seen;
  for (const CaseResult& one : result.cases) {
    if (one.outcome == Outcome::sound || is_finding(one.outcome)) continue;
    const std::string words = fmt::format("{}: {}", name_of(one.outcome), one.signature);
    if (std::find(seen.begin(), seen.end(), words) != seen.end()) continue;
    seen.push_back(words);
    if (static_cast<int>(seen.size()) > o.most_told) continue;
    check.message += fmt::format("{}, first on fuzz:{}\n", words, one.recipe);
  }
  if (static_cast<int>(seen.size()) > o.most_told)
    check.message += fmt::format("and {} further reasons\n", static_cast<int>(seen.size()) - o.most_told);
  return check;
}

MesherCheck check_mesher_on(const TriangleSurface& surface, const MeshFunction& function,
                            const std::string& file, const JudgeOptions& judge) {
  const auto mesher = function_mesher(function, "mesher");
  const JudgedRun judged = run_and_judge(*mesher, verify::JudgedSurface(surface), "", {}, judge);
  const Outcome outcome = judged.judgement.outcome;
  MesherCheck check{.good = !is_finding(outcome) && !is_unjudged(outcome), .message = words_of(judged)};
  if (!check.good && !file.empty()) {
    write_surface(file, surface);
    check.message =
        fmt::format("{}: {}\n{}", io::counted(surface.triangles.size(), "triangles"), file, check.message);
  }
  return check;
}

}  // namespace tetproof::corpus
