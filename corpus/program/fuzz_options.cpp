// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/fuzz_options.hpp"

#include <limits>

namespace tetproof::corpus {
namespace {

void declare_campaign(CLI::App& app, FuzzArguments& a) {
  app.add_option("--cases", a.cases,
                 "the number of surfaces; each mesher gets all of them. With --judge: of meshes of each "
                 "kind, usually 3; "
                 "with --reader: of damaged files, usually 2000")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40));
  app.add_option("--seed", a.seed, "case k of seed S is the same on every machine")->type_name("S");
  app.add_option(
         "--kinds", a.surfaces.kinds,
         "only these kinds of surfaces, of defects with --judge, of damage with --reader (--list-kinds)")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--modifiers", a.surfaces.modifiers, "only these modifiers; none: no modifier")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--most-triangles", a.surfaces.most_triangles, "the largest surfaces")
      ->type_name("N")
      ->check(CLI::Range(4, std::numeric_limits<int>::max()));
  app.add_flag("--extreme-sizes", a.surfaces.extreme_sizes,
               "also sizes of 1e-60 and 1e60, which hardly any mesher supports");
  app.add_flag("--list-kinds", a.list_kinds,
               "print the kinds of surfaces and modifiers with their parameters, of defects and of damage");
}

void declare_runs(CLI::App& app, FuzzArguments& a) {
  app.add_option("--cpu", a.limits.cpu_s, "CPU time allowed to a run, with all its processes [s]")
      ->type_name("S")
      ->check(CLI::Range(0.01, 1e6));
  app.add_option("--wall", a.limits.wall_s, "wall time allowed to a run [s]")
      ->type_name("S")
      ->check(CLI::Range(0.01, 1e6));
  app.add_option("--memory", a.limits.memory_mb,
                 "memory allowed to a run, with all its processes [10^6 bytes]")
      ->type_name("MB")
      ->check(CLI::Range(std::int64_t{10}, std::int64_t{1} << 30));
  app.add_option("--repeat", a.repeats,
                 "runs of each mesher on each surface, the worst of which counts; 0: as the preset says")
      ->type_name("K")
      ->check(CLI::Range(0, 10000));
  app.add_option("--check", a.judge.check, "judge by these checks only, by id, as tetproof-verify does")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void declare_results(CLI::App& app, FuzzArguments& a) {
  app.add_option("--out", a.out,
                 "a folder for the journal, the report and a folder for each finding. With the same options "
                 "a campaign that was interrupted goes on there")
      ->type_name("DIR")
      ->always_capture_default(false);
  app.add_option("--shrink", a.shrink_s,
                 "seconds spent on making the smallest surface of each new group smaller; needs --out")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--known", a.known,
                 "ids of groups that are known, one a line: they are counted, and are no failure")
      ->type_name("FILE")
      ->always_capture_default(false);
  app.add_option("--html", a.html,
                 "write the report as a page for any browser, and a page in the folder of each finding; - is "
                 "standard output")
      ->type_name("FILE.html")
      ->always_capture_default(false);
  app.add_option("--junit", a.junit, "write the report as JUnit XML; - is standard output")
      ->type_name("FILE.xml")
      ->always_capture_default(false);
  app.add_option("--shard", a.shard,
                 "run only the cases with index = I modulo N. Without it: GTEST_SHARD_INDEX and "
                 "GTEST_TOTAL_SHARDS; SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT (and _MIN, _STEP); "
                 "JOB_COMPLETION_INDEX and JOB_COMPLETIONS or --shards, if they are set")
      ->type_name("I/N")
      ->always_capture_default(false);
  app.add_option("--shards", a.shards,
                 "the number of shards, where the environment says only which one this is")
      ->type_name("N")
      ->always_capture_default(false);
  app.add_option("--merge", a.merge,
                 "run nothing: report on the shards whose journals are in these folders, as one run would")
      ->type_name("DIR...")
      ->expected(1, std::numeric_limits<int>::max())
      ->always_capture_default(false);
  app.add_option("--replay", a.replay,
                 "run one case again and show what the judge says: SEED:INDEX; DIR/INDEX, a case of the "
                 "campaign in DIR; DIR/findings/NAME, a finding's surface; or a group's id, with --out DIR")
      ->type_name("CASE")
      ->always_capture_default(false);
}

void declare_others(CLI::App& app, OtherArguments& a) {
  const auto command = [&](const char* name, std::vector<std::string>& values, const char* what) {
    app.add_option(name, values, what)
        ->type_name("COMMAND")
        ->allow_extra_args(false)
        ->always_capture_default(false);
  };
  command(
      "--judge", a.judge,
      "put meshes with planted defects, and sound ones, to a checker, with {mesh} and, if it compares, "
      "{surface}: a command in quotes, or a preset (--print-preset). Its exit code 0 means sound, another "
      "one defective. May be repeated");
  app.add_option("--says", a.says,
                 "a regular expression: a line of a checker's output that means defective, too")
      ->type_name("REGEX")
      ->always_capture_default(false);
  app.add_option(
         "--says-sound", a.says_sound,
         "a line of a checker's output without which nothing is called sound, in place of its exit code")
      ->type_name("REGEX")
      ->always_capture_default(false);
  command("--reader", a.reader,
          "hand damaged and odd files to a reader: a command in quotes, with {file}, or {stem} without the "
          "ending");
  app.add_option(
         "--formats", a.formats,
         "the formats of a reader's files, usually all that tetproof-convert writes; of --judge's {mesh}: "
         "one, usually that of --mesh-ending")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->always_capture_default(false);
}

}  // namespace

void declare_mesher_options(CLI::App& app, MesherArguments& a) {
  app.add_option(
         "COMMAND", a.command,
         "after --: the mesher to run, with {surface} and {mesh} in place of its files; {size} and {box} "
         "are a length that suits the surface, and its diagonal")
      ->always_capture_default(false);
  app.add_option("--mesher", a.presets,
                 "a preset in place of COMMAND, with the variants that are named, or all; may be repeated")
      ->type_name("NAME[,VARIANT...]")
      ->allow_extra_args(false)
      ->always_capture_default(false);
  app.add_option("--program", a.program, "where the preset's program is")
      ->type_name("PATH")
      ->always_capture_default(false);
  app.add_option("--surface-format", a.surface_format,
                 "the format that COMMAND reads: off, stl, smesh, poly, obj, ply, ...")
      ->type_name("FORMAT");
  app.add_option("--mesh-ending", a.mesh_ending, "the ending of the file that COMMAND writes, as in .1.ele")
      ->type_name("ENDING");
  app.add_option("--name", a.name, "what reports call COMMAND; else its program's name")
      ->type_name("NAME")
      ->always_capture_default(false);
}

void declare_options(CLI::App& app, FuzzArguments& a) {
  declare_mesher_options(app, a.mesher);
  app.add_flag("--print-preset", a.print_preset,
               "print the presets of meshers and checkers with their variants and commands");
  declare_campaign(app, a);
  declare_runs(app, a);
  declare_results(app, a);
  declare_others(app, a.others);
}

}  // namespace tetproof::corpus
