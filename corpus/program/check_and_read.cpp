// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/check_and_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "corpus/campaign/known_groups.hpp"
#include "corpus/checkers/check_campaign.hpp"
#include "corpus/checkers/planted_case.hpp"
#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/program_path.hpp"
#include "corpus/program/split_words.hpp"
#include "corpus/program/status_line.hpp"
#include "corpus/readers/damage.hpp"
#include "corpus/readers/read_campaign.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

// The words of a COMMAND, its program found; `part`: what it must have a place for.
std::vector<std::string> command(std::vector<std::string> words, const char* option, const char* part) {
  if (words.empty() || !has_part(words, part))
    throw InputError(fmt::format("{}: expected a COMMAND with {} among its words, found '{}'", option, part,
                                 command_line(words)));
  const std::string path = program_path(words[0]);
  if (path.empty()) throw InputError(fmt::format("{}: {}: there is no such program", option, words[0]));
  words[0] = path;
  return words;
}

std::string name_of_program(const std::vector<std::string>& words, const std::string& name) {
  return name.empty() ? words[0].substr(words[0].find_last_of('/') + 1) : name;
}

Checker checker_of(const std::vector<std::string>& words, const FuzzArguments& a) {
  Checker checker{.words = command(words, "--judge", "{mesh}"),
                  .format = {},
                  .mesh_ending = a.mesher.mesh_ending,
                  .surface_ending = format_named(a.mesher.surface_format).endings.front(),
                  .rule = {.defective = a.others.says, .sound = a.others.says_sound}};
  checker.name = name_of_program(checker.words, a.mesher.name);
  if (!checker.mesh_ending.starts_with('.'))
    throw InputError(
        fmt::format("--mesh-ending: expected a dot first, as in .msh, found '{}'", checker.mesh_ending));
  const std::string file = "mesh" + checker.mesh_ending;
  const Format& format = a.others.formats.empty() ? format_of(file) : format_named(a.others.formats.front());
  if (a.others.formats.size() > 1)
    throw InputError("--formats: --judge takes the name of one format, that of {mesh}");
  checker.format = format.name;
  const MesherArguments usual;
  if (checker.mesh_ending == usual.mesh_ending && !a.others.formats.empty())
    checker.mesh_ending = format.name == "tetgen" ? ".ele" : format.endings.front();
  AnswerReader{checker.rule};  // throws for a wrong expression
  return checker;
}

std::vector<Checker> checkers_of(const FuzzArguments& a) {
  std::vector<Checker> all;
  for (const std::string& text : a.others.judge) {
    const std::vector<std::string> words = split_words(text);
    if (words.size() == 1 && !has_part(words, "{mesh}")) {
      if (!a.others.says.empty() || !a.others.says_sound.empty() || !a.others.formats.empty())
        throw InputError("--says, --says-sound and --formats are for a COMMAND: a preset has its own");
      all.push_back(preset_checker(words[0]));
    } else {
      all.push_back(checker_of(words, a));
    }
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      if (all[k].name == all.back().name)
        throw InputError(fmt::format("--judge: '{}' is there twice", all.back().name));
  }
  return all;
}

struct Reports {
  std::string text, json, junit, html;
};

// Writes what was asked for, and the same into the folder of --out.
void report(const Reports& reports, const FuzzArguments& a, const program::Common& common,
            const program::FilesInUse& files) {
  if (!a.out.empty()) {
    program::write_text(a.out + "/report.txt", reports.text);
    program::write_text(a.out + "/report.json", reports.json);
  }
  if (!common.json.empty()) program::write_text(common.json, reports.json);
  if (!a.junit.empty()) program::write_text(a.junit, reports.junit);
  if (!a.html.empty()) program::write_text(a.html, reports.html);
  if (!files.standard_output_is_taken()) program::write_text("-", reports.text);
}

// A folder that cannot be made is said before the work begins.
void make_folder(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InputError(fmt::format("{}: cannot make this folder", folder));
  if (std::filesystem::exists(folder + "/findings"))
    throw InputError(fmt::format("{}: it has findings of an earlier run: give another folder", folder));
}

int judge(const FuzzArguments& a, const program::Common& common, const program::FilesInUse& files) {
  const std::vector<Checker> checkers = checkers_of(a);
  JudgingOptions options{.seed = a.seed,
                         .kinds = a.surfaces.kinds,
                         .limits = a.limits,
                         .threads = common.threads,
                         .folder = a.out};
  if (a.cases_given) options.each = a.cases;
  const std::uint64_t cases = case_count(options) * checkers.size();
  make_folder(a.out);
  StatusLine status(common, cases);
  options.progress = [&](const CheckedCase& one) { status.add(is_finding(one.grade)); };
  const CheckResult result = run_checkers(checkers, options);
  status.clear();
  report({check_text(result), check_json(result), check_junit(result), check_page(result, a.out)}, a, common,
         files);
  if (!result.findings.empty()) return program::wrong;
  return std::any_of(result.cases.begin(), result.cases.end(),
                     [](const CheckedCase& one) { return is_unasked(one.grade); })
             ? program::incomplete
             : program::sound;
}

int read(const FuzzArguments& a, const program::Common& common, const program::FilesInUse& files) {
  const std::string& text = a.others.reader.front();
  const std::vector<std::string> words = split_words(text);
  Reader reader{.words = command(words, "--reader", has_part(words, "{stem}") ? "{stem}" : "{file}")};
  reader.name = name_of_program(reader.words, a.mesher.name);
  DamageOptions options{.seed = a.seed,
                        .formats = a.others.formats,
                        .damages = a.surfaces.kinds,
                        .limits = a.limits,
                        .threads = common.threads,
                        .shrink_s = a.shrink_s,
                        .folder = a.out};
  if (a.cases_given) options.cases = a.cases;
  if (!a.known.empty()) options.known = read_known_groups(a.known);
  make_folder(a.out);
  std::optional<StatusLine> status;
  options.started = [&](std::uint64_t cases) { status.emplace(common, cases); };
  options.progress = [&](const ReadCase& one) { status->add(is_finding(one.run.reading)); };
  const ReadResult result = run_reader_campaign(reader, options);
  status.reset();
  report({read_text(result), read_json(result), read_junit(result), read_page(result, a.out)}, a, common,
         files);
  if (std::any_of(result.groups.begin(), result.groups.end(),
                  [](const ReadGroup& group) { return !group.known; }))
    return program::wrong;
  return refused_valid_files(result).empty() && result.not_applied.empty() ? program::sound
                                                                           : program::incomplete;
}

void check_use(const FuzzArguments& a) {
  const bool judges = !a.others.judge.empty();
  const char* option = judges ? "--judge" : "--reader";
  const auto refuse = [&](bool given, const char* other) {
    if (given) throw InputError(fmt::format("{} is not for {}", other, option));
  };
  if (judges && !a.others.reader.empty()) throw InputError("expected --judge or --reader, found both");
  if (a.others.reader.size() > 1) throw InputError("--reader: expected one COMMAND");
  refuse(!a.mesher.presets.empty(), "--mesher");
  refuse(!a.mesher.command.empty(), "COMMAND after --");
  refuse(!a.mesher.program.empty(), "--program");
  refuse(!a.shard.empty() || !a.shards.empty(), "--shard");
  refuse(!a.merge.empty(), "--merge");
  refuse(!a.replay.empty(), "--replay");
  refuse(!a.judge.check.empty(), "--check");
  refuse(a.repeats != 0, "--repeat");
  refuse(!a.surfaces.modifiers.empty(), "--modifiers");
  refuse(a.surfaces.extreme_sizes, "--extreme-sizes");
  refuse(a.surfaces.most_triangles != FuzzOptions{}.most_triangles, "--most-triangles");
  refuse(judges && !a.known.empty(), "--known");
  refuse(judges && a.shrink_s > 0, "--shrink");
  refuse(!judges && (!a.others.says.empty() || !a.others.says_sound.empty()), "--says");
  if (a.shrink_s > 0 && a.out.empty()) throw InputError("--shrink needs --out DIR");
}

}  // namespace

bool asks_for_other_programs(const FuzzArguments& a) {
  const OtherArguments& others = a.others;
  if (others.judge.empty() && others.reader.empty()) {
    if (!others.says.empty() || !others.says_sound.empty() || !others.formats.empty())
      throw InputError("--says, --says-sound and --formats are for --judge and --reader");
    return false;
  }
  check_use(a);
  return true;
}

std::string list_kinds_of_others() {
  std::string text = "\ndefects, for --judge:\n";
  text += fmt::format("{:<36} {}\n", "sound", "nothing is planted: a finding is a false alarm");
  for (const PlantKind& kind : plant_kinds()) text += fmt::format("{:<36} {}\n", kind.id, kind.comment);
  return text + "\ndamage, for --reader:\n" + list_damage_kinds();
}

int check_or_read(const FuzzArguments& a, const program::Common& common, const program::FilesInUse& files) {
  return a.others.judge.empty() ? read(a, common, files) : judge(a, common, files);
}

}  // namespace tetproof::corpus
