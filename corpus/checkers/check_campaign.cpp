// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/checkers/check_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/campaign/share_work.hpp"
#include "corpus/checkers/held_exactly.hpp"
#include "corpus/checkers/planted_case.hpp"
#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/end_class.hpp"
#include "corpus/meshing/surface_input.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;

class Campaign {
 public:
  Campaign(const std::vector<Checker>& checkers, const JudgingOptions& options)
      : checkers_(checkers), options_(options), kinds_(checked_kinds(options.kinds)), scratch_("") {
    for (const Checker& checker : checkers) readers_.emplace_back(checker.rule);
  }

  CheckResult run() {
    share_work({.end = case_count(options_)}, options_.threads,
               [this](std::uint64_t index, const std::atomic<bool>& stop) { ask_all(index, stop); });
    CheckResult result{.seed = options_.seed, .each = options_.each, .checkers = checkers_, .kinds = kinds_};
    for (auto& [key, one] : cases_) result.cases.push_back(std::move(one));
    return result;
  }

 private:
  void ask_all(std::uint64_t index, const std::atomic<bool>& stop) {
    const PlantedCase mesh = planted_case(kinds_, options_.seed, index);
    for (std::size_t c = 0; c < checkers_.size() && !stop; ++c) {
      CheckedCase one = ask(c, mesh);
      const std::lock_guard lock(mutex_);
      if (options_.progress) options_.progress(one);
      cases_.emplace(std::pair(index, c), std::move(one));
    }
  }

  CheckedCase ask(std::size_t c, const PlantedCase& mesh) {
    const Checker& checker = checkers_[c];
    CheckedCase one{.index = mesh.index,
                    .checker = checker.name,
                    .kind = mesh.kind,
                    .ground = mesh.ground,
                    .tets = static_cast<std::int64_t>(mesh.mesh.tets.size()),
                    .expected = mesh.expected,
                    .grade = Grade::not_planted,
                    .what = "no place for it was found"};
    if (!mesh.planted) return one;
    const std::string folder = fmt::format("{}/{}-{}", scratch_.path(), mesh.index, c);
    fs::create_directories(folder);
    const std::string path = folder + "/mesh" + checker.mesh_ending;
    one.what = write_exactly(path, checker.format, mesh.mesh);
    if (!one.what.empty()) {
      one.grade = Grade::not_held;
    } else {
      Placeholders values{{"{mesh}", path}};
      if (has_part(checker.words, "{surface}")) {
        values.emplace_back("{surface}", write_surface_input(folder + "/surface", checker.surface_ending,
                                                             boundary_of(mesh.before))
                                             .files[0]);
        if (one.expected != Expected::defective && !same_boundary(mesh.mesh, mesh.before))
          one.expected = Expected::debatable;
      }
      const CheckerRun run = ask_program(c, replaced(checker.words, values), folder);
      one.grade = grade_of(one.expected, run.answer);
      if (one.grade == Grade::crashed) one.signature = run.signature;
      one.what = replaced(run.message, {{folder + "/", ""}});
    }
    fs::remove_all(folder);
    return one;
  }

  CheckerRun ask_program(std::size_t c, const std::vector<std::string>& command,
                         const std::string& folder) const {
    const ProcessOptions options{.folder = folder, .limits = options_.limits};
    const ProcessEnd end = run_process(command, options);
    if (!end.started) throw InputError(end.output.substr(0, end.output.find('\n')));
    CheckerRun run = readers_[c].read(end);
    if (run.answer == Answer::crashed)
      if (EndClass ended = classify_end(end); ended.wants_backtrace) {
        add_backtrace(command, options, ended);
        run.signature = ended.signature;
      }
    return run;
  }

  const std::vector<Checker>& checkers_;
  const JudgingOptions& options_;
  std::vector<std::string> kinds_;
  std::vector<AnswerReader> readers_;
  ScratchFolder scratch_;
  std::mutex mutex_;
  std::map<std::pair<std::uint64_t, std::size_t>, CheckedCase> cases_;
};

std::vector<CheckFinding> findings_of(const CheckResult& result) {
  const auto position = [](const auto& all, const auto& is) {
    return std::find_if(all.begin(), all.end(), is) - all.begin();
  };
  std::map<std::tuple<std::ptrdiff_t, int, std::ptrdiff_t, std::string>, CheckFinding> groups;
  for (const CheckedCase& one : result.cases) {
    if (!is_finding(one.grade)) continue;
    const bool crash = one.grade == Grade::crashed;
    const auto c = position(result.checkers, [&](const Checker& x) { return x.name == one.checker; });
    const auto row = position(result.kinds, [&](const std::string& x) { return x == one.kind; });
    CheckFinding& group =
        groups[{c, static_cast<int>(one.grade), crash ? 0 : row, crash ? one.signature : ""}];
    group.checker = one.checker;
    group.grade = one.grade;
    group.subject = crash ? one.signature : one.kind;
    group.cases.push_back(one);
  }
  std::vector<CheckFinding> all;
  for (auto& [key, group] : groups) {
    std::stable_sort(group.cases.begin(), group.cases.end(),
                     [](const CheckedCase& a, const CheckedCase& b) { return a.tets < b.tets; });
    all.push_back(std::move(group));
  }
  return all;
}

// A mesh for each finding, and what is known about it.
void keep_meshes(CheckResult& result, const std::string& folder) {
  int number = 0;
  for (CheckFinding& finding : result.findings) {
    const CheckedCase& first = finding.cases.front();
    const Checker& checker = *std::find_if(result.checkers.begin(), result.checkers.end(),
                                           [&](const Checker& one) { return one.name == first.checker; });
    std::string name = fmt::format("{}-{}-{}-{}", ++number, first.checker, name_of(first.grade), first.kind);
    std::replace(name.begin(), name.end(), '/', '-');
    const fs::path place = fs::path(folder) / "findings" / name;
    fs::remove_all(place);
    fs::create_directories(place);
    const PlantedCase mesh = planted_case(result.kinds, result.seed, first.index);
    finding.file = fmt::format("findings/{}/mesh{}", name, checker.mesh_ending);
    write_exactly((fs::path(folder) / finding.file).string(), checker.format, mesh.mesh);
    Placeholders values{{"{mesh}", "mesh" + checker.mesh_ending}};
    if (has_part(checker.words, "{surface}"))
      values.emplace_back("{surface}",
                          fs::path(write_surface_input((place / "surface").string(), checker.surface_ending,
                                                       boundary_of(mesh.before))
                                       .files[0])
                              .filename()
                              .string());
    AtomicFile text((place / "README.txt").string());
    text.write(fmt::format("{}: the mesh is {}, and {} {}.\nplanted: {}, in {}\n{}\nit said: {}\nagain: {}\n",
                           name_of(first.grade), name_of(first.expected), checker.name,
                           first.grade == Grade::missed        ? "calls it sound"
                           : first.grade == Grade::false_alarm ? "calls it defective"
                           : first.grade == Grade::crashed     ? "crashes on it: " + first.signature
                                                               : "gives no verdict",
                           first.kind, first.ground,
                           first.kind == "sound" ? "" : plant_kind(first.kind).comment, first.what,
                           command_line(replaced(checker.words, values))));
    text.commit();
  }
}

}  // namespace

std::uint64_t case_count(const JudgingOptions& options) {
  return options.each * checked_kinds(options.kinds).size();
}

CheckResult run_checkers(const std::vector<Checker>& checkers, const JudgingOptions& options) {
  CheckResult result = Campaign(checkers, options).run();
  result.findings = findings_of(result);
  if (!options.folder.empty()) keep_meshes(result, options.folder);
  return result;
}

}  // namespace tetproof::corpus
