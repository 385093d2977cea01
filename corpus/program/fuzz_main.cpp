// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-fuzz [options] -- COMMAND: runs any mesher on random closed surfaces and judges what it writes.
#include <fmt/format.h>

#include <CGAL/version.h>

#include <optional>

#include "corpus/campaign/journal.hpp"
#include "corpus/campaign/known_groups.hpp"
#include "corpus/campaign/shards.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/campaign_page.hpp"
#include "corpus/checkers/checker.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "corpus/program/check_and_read.hpp"
#include "corpus/program/fuzz_options.hpp"
#include "corpus/program/replay.hpp"
#include "corpus/program/status_line.hpp"
#include "io/error.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "verify/report.hpp"

namespace {

using namespace tetproof;
using namespace tetproof::corpus;

constexpr const char* examples =
    "  tetproof-fuzz --mesher tetgen --cases 500 --out tetgen-bugs --shrink 60\n"
    "  tetproof-fuzz --cases 200 -- ./my-mesher {surface} -o {mesh}\n"
    "  tetproof-fuzz --surface-format smesh --mesh-ending .1.ele -- tetgen -pq {surface}\n"
    "  tetproof-fuzz --mesher gmsh,delaunay --known known.txt --junit fuzz.xml     for a CI system\n"
    "  tetproof-fuzz --mesher hxt --shard 3/8 --cases 100000 --out shards          on one of 8 machines\n"
    "  tetproof-fuzz --merge shards --json report.json\n"
    "  tetproof-fuzz --replay 1:17 --mesher tetgen,pq\n"
    "  tetproof-fuzz --judge 'my-checker {mesh}' --judge gmsh --judge tetgen       who misses what\n"
    "  tetproof-fuzz --judge 'my-checker {mesh}' --says '[Ee]rror' --formats vtk --out missed\n"
    "  tetproof-fuzz --reader 'my-reader {file}' --formats msh41,vtu --out crashes --shrink 30\n";

int exit_code(const CampaignResult& result) {
  if (new_groups(result) > 0) return program::wrong;
  return is_incomplete(result) ? program::incomplete : program::sound;
}

// Writes what was asked for, and the same into the campaign's folder.
void report(const CampaignResult& result, const FuzzArguments& a, const program::Common& common,
            const program::FilesInUse& files) {
  const std::string text = campaign_text(result), json = campaign_json(result);
  if (!a.out.empty()) {
    const CampaignSettings& s = result.settings;
    const std::string name =
        a.out + "/report" + (s.shards > 1 ? fmt::format("-{}-of-{}", s.shard, s.shards) : "");
    program::write_text(name + ".txt", text);
    program::write_text(name + ".json", json);
  }
  if (!common.json.empty()) program::write_text(common.json, json);
  if (!a.junit.empty()) program::write_text(a.junit, campaign_junit(result));
  if (!a.html.empty())
    write_campaign_pages(result, {.path = a.html,
                                  .folders = a.merge.empty() ? std::vector<std::string>{a.out} : a.merge,
                                  .write = program::write_text,
                                  .say = [&](const std::string& line) { program::say(common, line); }});
  if (!files.standard_output_is_taken()) program::write_text("-", text);
}

CampaignResult run(const FuzzArguments& a, const program::Common& common) {
  const std::vector<ChosenMesher> chosen = choose_meshers(a.mesher);
  std::vector<const Mesher*> meshers;
  CampaignOptions options{.seed = a.seed,
                          .cases = a.cases,
                          .surfaces = a.surfaces,
                          .limits = a.limits,
                          .judge = a.judge,
                          .repeats = a.repeats,
                          .threads = common.threads,
                          .shrink_s = a.shrink_s,
                          .folder = a.out,
                          .version = TETPROOF_VERSION};
  for (const ChosenMesher& one : chosen) {
    meshers.push_back(one.mesher.get());
    options.words.push_back(one.words);
  }
  const Shard shard = find_shard(a.shard, a.shards, process_environment);
  options.shard = shard.shard;
  options.shards = shard.shards;
  if (shard.shards > 1 && a.out.empty())
    throw InputError(
        fmt::format("{}: a shard needs --out DIR, or its results cannot be merged", shard.source));
  if (shard.shards > 1)
    program::say(common, fmt::format("shard {} of {}, from {}", shard.shard, shard.shards, shard.source));
  if (!a.known.empty()) options.known = read_known_groups(a.known);

  const std::uint64_t surfaces = a.cases > shard.shard ? (a.cases - shard.shard - 1) / shard.shards + 1 : 0;
  StatusLine status(common, surfaces * meshers.size());
  options.started = [&](std::uint64_t done) {
    status.skip(done);
    if (done > 0) program::say(common, fmt::format("{} results are in the journal", done));
  };
  options.progress = [&](const CaseResult& result) { status.add(is_finding(result.outcome)); };
  std::optional<program::Progress> shrinking;
  options.say = [&](const std::string& line) {
    status.clear();
    shrinking.reset();
    program::say(common, line);
    shrinking.emplace(common).enter("shrinking");
  };
  return run_campaign(meshers, options);
}

void check_usage(const FuzzArguments& a) {
  for (const std::string& id : a.judge.check) verify::check_of_id(id);
  random_recipe(a.seed, 0, a.surfaces);  // throws for unknown kinds and modifiers
  if (!a.merge.empty() && (!a.replay.empty() || !a.mesher.command.empty() || !a.mesher.presets.empty()))
    throw InputError("--merge runs nothing: leave --replay, --mesher and COMMAND out");
  if (!a.merge.empty() &&
      (a.shrink_s > 0 || !a.shard.empty() || !a.shards.empty() || !a.judge.check.empty() || a.repeats != 0))
    throw InputError("--merge runs nothing: leave --shrink, --shard, --check and --repeat out");
  if (a.shrink_s > 0 && a.out.empty()) throw InputError("--shrink needs --out DIR");
  if (!a.replay.empty() && (!a.junit.empty() || !a.html.empty() || a.shrink_s > 0 || !a.known.empty()))
    throw InputError("--junit, --html, --shrink and --known are not for --replay");
}

int work(const FuzzArguments& a, const program::Common& common) {
  if (a.list_kinds || a.print_preset) {
    program::write_text(
        "-", a.list_kinds ? list_fuzz_kinds() + list_kinds_of_others() : list_presets() + list_checkers());
    return program::sound;
  }
  const bool others = asks_for_other_programs(a);
  if (!others) check_usage(a);
  program::FilesInUse files(common);
  if (!a.known.empty()) files.reads("--known", a.known);
  files.writes("--junit", a.junit);
  files.writes("--html", a.html);
  if (others) return check_or_read(a, common, files);
  if (!a.replay.empty()) return replay(a, common);
  CampaignResult result;
  if (a.merge.empty())
    result = run(a, common);
  else
    result =
        merge_campaign(a.merge, a.known.empty() ? std::vector<std::string>{} : read_known_groups(a.known));
  for (const std::string& line : result.missing) program::say(common, line);
  report(result, a, common, files);
  return exit_code(result);
}

}  // namespace

int main(int argc, char** argv) {
  const program::Description description{
      "Runs a mesher on random closed surfaces that are valid, proved exactly, and hard; judges each mesh as "
      "tetproof-verify does; groups what fails by its cause and makes it small. Exit code 0: the meshes are "
      "sound or fail in a known way; some may be refused, but not all; 1: new findings; 2: bad usage; 3: own "
      "failure; 4: no finding, but there were runs of which nothing can be said: slow, out of memory, not "
      "judged, not compiled in; or not one mesh was judged, or shards are missing. The same for checkers on "
      "planted meshes (1: a defect missed, a sound mesh called defective, a crash; 4: no verdict on a mesh, "
      "or "
      "a format that cannot hold its defect) and for readers of damaged files (1: a crash, a hang, all "
      "memory "
      "taken; 4: it refuses valid files too, or a kind of damage applied to none).",
      examples,
      {"CGAL " CGAL_VERSION_STR},
      {{"--check", verify::check_ids()}, {"--formats", program::format_list()}}};
  return program::run(argc, argv, description,
                      [](CLI::App& app, program::Common& common) -> std::function<int()> {
                        auto arguments = std::make_shared<FuzzArguments>();
                        declare_options(app, *arguments);
                        return [arguments, &app, &common] {
                          arguments->cases_given = app.count("--cases") > 0;
                          return work(*arguments, common);
                        };
                      });
}
