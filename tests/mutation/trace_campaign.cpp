// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-trace-campaign: changes traces at random and counts how often the comparison with the original,
// and the check against the method, find the change and blame the right file and line.
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/generate.hpp"
#include "tests/mutation/trace_meaning.hpp"
#include "tests/mutation/trace_mutants.hpp"
#include "verify/compare_traces.hpp"
#include "verify/program/check_trace.hpp"

namespace {

using namespace tetproof;
using mutation::Mutant;
using reference::AdaptOptions;
using reference::Criterion;
using reference::Options;

// A trace to change. `options`: of a trace that is made; otherwise it is shipped.
struct Original {
  std::string name, surface{};
  std::optional<Options> options{};
};

// The shipped traces, and small ones for the options that they leave out.
std::vector<Original> originals(const std::string& shipped) {
  std::vector<Original> all;
  std::ifstream list(shipped + "/list.txt");
  for (std::string line; std::getline(list, line);)
    if (!line.starts_with('#')) all.push_back({line.substr(0, line.find(' '))});
  const std::vector<Original> made{
      {"past-dilution", "sphere:r=1,n=96",
       Options{
           .cells = {3, 3, 3},
           .parametric = false,
           .adapt =
               AdaptOptions{
                   .points = 40, .v0 = {0.5}, .v1 = {0.9}, .past_dilution = true, .improve_below = 0.02}}},
      {"e-avg", "random:seed=3,n=96",
       Options{.cells = {3, 3, 3},
               .parametric = false,
               .adapt = AdaptOptions{.v0 = {0.1},
                                     .v1 = {1},
                                     .p = 2,
                                     .e_avg = {0.35},
                                     .curvature = true,
                                     .improve_below = 0.01}}},
      {"automatic", "torus:R=1,r=0.4,n=150",
       Options{.cells = {4, 4, 2}, .adapt = AdaptOptions{.v0 = {0.6}, .v1 = {1}, .d1 = 0.3}}},
      {"parametric-outside", "torus:R=1,r=0.4,n=150",
       Options{.region = reference::Region::outside,
               .cells = {3, 3, 2},
               .diagonals = reference::Diagonals::shortest,
               .adapt = AdaptOptions{.points = 30,
                                     .v0 = {0.1},
                                     .v1 = {1},
                                     .curvature = true,
                                     .improve = Criterion::aspect_ratio,
                                     .improve_below = 0.02}}},
      {"literal", "terrain:seed=5,m=3",
       Options{.cells = {3, 3, 3},
               .box_scale = 4.0 / 3,
               .literal = true,
               .adapt = AdaptOptions{.points = 40, .v0 = {0.1}, .v1 = {1}, .improve_below = 0.01}}},
      {"mended", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4",
       Options{.cells = {6, 6, 6},
               .box_scale = 1.5,
               .on_surface = 0,
               .adapt = AdaptOptions{.points = 25, .v0 = {0.1}, .v1 = {1}, .improve = Criterion::none}}},
      {"not-adapted", "torus:R=1,r=0.4,n=150", Options{.cells = {5, 5, 2}}},
      {"empty", "sphere:r=1,n=96", Options{.cells = {2, 1, 1}, .adapt = AdaptOptions{}}}};
  all.insert(all.end(), made.begin(), made.end());
  return all;
}

void make(const Original& original, const std::string& path) {
  std::ofstream file(path);
  const auto write = [&](const trace::Record& record) { file << trace::to_line(record) << '\n'; };
  const TriangleSurface surface = corpus::make_surface(original.surface);
  trace::Settings settings = reference::settings_of(*original.options, static_cast<bool>(surface.evaluate));
  settings.program = "tetproof-mesh";
  settings.surface = original.surface;
  write(settings);
  Options options = *original.options;
  options.listener.record = write;
  reference::generate(surface, options);
}

// What one of the two ways to look at a mutant says of it.
struct Answer {
  bool found = false, right_file = false, right_line = false;
  std::string says;
  bool good() const { return found && right_file && right_line; }
};

// An InputError that names the mutant and a line, or another one.
Answer answer_of(const InputError& error, const std::string& path, const Mutant& mutant) {
  Answer answer{.found = true, .says = error.what()};
  answer.right_file = answer.says.starts_with(path + ":");
  if (answer.right_file)
    answer.right_line = mutant.lines.contains(std::atoll(answer.says.c_str() + path.size() + 1));
  return answer;
}

class Campaign {
 public:
  Campaign(std::string original, const std::string& mutant)
      : original_(std::move(original)),
        mutant_(mutant),
        records_(mutation::canonical_records(original_)),
        options_(verify::options_of_trace(original_)) {
    std::ifstream file(original_);
    for (std::string line; std::getline(file, line);) lines_.push_back(line);
    const auto first = trace::Reader(original_).next();
    surface_ = corpus::open_surface(std::get<trace::Settings>(*first).surface);
    checked_original_ = verify::check_trace(original_, "");
    if (!checked_original_.admissible || !checked_original_.cannot.empty())
      throw InputError(original_ + " is not admissible: " + checked_original_.what +
                       checked_original_.cannot);
  }

  Mutant write_mutant(std::mt19937_64& random) const {
    Mutant made = mutation::mutate(lines_, random);
    std::ofstream(mutant_, std::ios::binary) << made.text;
    return made;
  }

  bool means_the_same() const {
    try {
      return mutation::same_meaning(records_, mutation::canonical_records(mutant_));
    } catch (const InputError&) {
      return false;
    }
  }

  Answer compare(const Mutant& mutant, bool as_reference) const {
    try {
      const verify::TraceComparison result = verify::compare_traces(
          as_reference ? original_ : mutant_, as_reference ? mutant_ : original_, 1e-9,
          [&](const std::string& path) {
            return path == original_ ? checked_original_ : verify::check_trace(path, "");
          });
      Answer answer{.says = verify::comparison_text(result)};
      if (result.verdict == verify::TraceComparison::Verdict::diverges) {
        // Runs that were asked for different things: neither is wrong, and the records that ask are named.
        const verify::TraceSide& side = !result.wrong.file.empty() ? result.wrong
                                        : as_reference             ? result.reference
                                                                   : result.other;
        answer.found = true;
        answer.right_file = side.file == mutant_;
        answer.right_line = mutant.lines.contains(side.line) || (side.line == 0 && mutant.left_out);
      } else if (mutant.left_out && !result.not_compared.empty()) {
        answer.found = answer.right_file = answer.right_line = true;
      }
      return answer;
    } catch (const InputError& error) {
      return answer_of(error, mutant_, mutant);
    }
  }

  // What the two say of a mutant that means the same; empty if they accept it. They may tell a point that is
  // written with other bits than before, although it is within the tolerance.
  std::string told_of() const {
    try {
      const verify::TraceComparison result = verify::compare_traces(mutant_, original_);
      if (result.verdict != verify::TraceComparison::Verdict::equal) return verify::comparison_text(result);
      Options options = options_;
      options.follow = mutant_;
      const reference::Follow outcome = *reference::generate(surface_, options).follow;
      return outcome.admissible ? "" : fmt::format("line {}: {}", outcome.line, outcome.what);
    } catch (const InputError& error) {
      return error.what();
    }
  }

  Answer follow(const Mutant& mutant) const {
    try {
      Options options = options_;
      options.follow = mutant_;
      const reference::Follow outcome = *reference::generate(surface_, options).follow;
      if (outcome.admissible) {
        const bool told = mutant.left_out && !outcome.not_checked.empty();
        return {told, told, told, "admissible"};
      }
      return {true, true, mutant.lines.contains(outcome.line),
              fmt::format("line {}: {}", outcome.line, outcome.what)};
    } catch (const InputError& error) {
      return answer_of(error, mutant_, mutant);
    }
  }

 private:
  std::string original_, mutant_;
  std::vector<trace::Record> records_;
  Options options_;
  std::vector<std::string> lines_;
  TriangleSurface surface_;
  verify::CheckedTrace checked_original_;
};

struct Score {
  int made = 0, same = 0, told = 0;
  int found = 0, file = 0, line = 0;    // by the comparison
  int followed = 0, followed_line = 0;  // by the check

  int counted() const { return made - same; }
};

void print(const char* title, const std::map<std::string, Score>& scores) {
  fmt::print("\n{:<18} {:>6} {:>6} {:>6} {:>8} | {:>7} {:>6} {:>6} | {:>7} {:>6}\n", title, "made", "same",
             "told", "counted", "compare", "file", "line", "follow", "line");
  for (const auto& [name, s] : scores)
    fmt::print("{:<18} {:>6} {:>6} {:>6} {:>8} | {:>7} {:>6} {:>6} | {:>7} {:>6}\n", name, s.made, s.same,
               s.told, s.counted(), s.found, s.file, s.line, s.followed, s.followed_line);
}

}  // namespace

int main(int argc, char** argv) {
  int mutants = 5000;
  std::uint64_t seed = 1;
  std::vector<std::string> only;
  std::string folder, shipped = TETPROOF_SOURCE_DIR "/corpus/vectors/traces";
  CLI::App app("Changes traces at random; tetproof-compare and the check of a trace must find each change.");
  app.add_option("--mutants", mutants, "how many to make");
  app.add_option("--seed", seed, "of the random numbers");
  app.add_option("--trace", only, "names of traces; all if not given");
  app.add_option("--keep", folder, "a folder for the traces, and for every mutant that is not found");
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);

  const bool keep = !folder.empty();
  if (!keep)
    folder = (std::filesystem::temp_directory_path() / fmt::format("trace-campaign-{}", ::getpid())).string();
  std::filesystem::create_directories(folder);
  std::vector<std::pair<std::string, Campaign>> campaigns;
  for (const Original& original : originals(shipped)) {
    if (!only.empty() && std::find(only.begin(), only.end(), original.name) == only.end()) continue;
    std::string path = shipped + "/" + original.name + ".jsonl";
    if (original.options) make(original, path = folder + "/" + original.name + ".jsonl");
    try {
      campaigns.emplace_back(original.name, Campaign(path, folder + "/mutant.jsonl"));
    } catch (const InputError& error) {
      fmt::print("left out: {}\n", error.what());
    }
  }
  if (campaigns.empty()) return 2;

  std::map<std::string, Score> by_operation, by_kind, by_trace, all;
  int bad = 0;
  for (int number = 0; number < mutants; ++number) {
    const auto& [name, campaign] = campaigns[static_cast<std::size_t>(number) % campaigns.size()];
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>(number));
    const Mutant mutant = campaign.write_mutant(random);
    const bool same = campaign.means_the_same();
    const bool as_reference = random() % 2;
    const std::string told = same ? campaign.told_of() : "";
    if (!told.empty())
      fmt::print("SAME, BUT TOLD: mutant {} of {} ({}): {}: {}\n  {}\n", number, name, seed,
                 name_of(mutant.operation), mutant.what, told);
    const Answer compared = same ? Answer{} : campaign.compare(mutant, as_reference);
    const Answer followed = same ? Answer{} : campaign.follow(mutant);
    for (Score* score :
         {&by_operation[name_of(mutant.operation)], &by_kind[mutant.kind], &by_trace[name], &all["all"]}) {
      ++score->made;
      score->same += same;
      score->told += !told.empty();
      score->found += compared.found;
      score->file += compared.right_file;
      score->line += compared.right_line;
      score->followed += followed.found;
      score->followed_line += followed.right_line;
    }
    if (same || (compared.good() && followed.good())) continue;
    ++bad;
    std::string lines;
    for (const std::int64_t line : mutant.lines) lines += fmt::format(" {}", line);
    fmt::print("NOT FOUND: mutant {} of {} ({}, as {}): {}: {}; lines{}\n", number, name, seed,
               as_reference ? "reference" : "other", name_of(mutant.operation), mutant.what, lines);
    if (!compared.good()) fmt::print("  compare: {}\n", compared.says);
    if (!followed.good()) fmt::print("  follow: {}\n", followed.says);
    std::fflush(stdout);
    if (keep)
      std::ofstream(fmt::format("{}/missed-{}.jsonl", folder, number), std::ios::binary) << mutant.text;
  }
  if (!keep) std::filesystem::remove_all(folder);

  print("change", by_operation);
  print("record", by_kind);
  print("trace", by_trace);
  print("", all);
  fmt::print("\n{} of {} mutants that mean something else were found by both, with the right file and line\n",
             all["all"].counted() - bad, all["all"].counted());
  return bad ? 1 : 0;
}
