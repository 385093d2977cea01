// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/replay.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "corpus/campaign/case_run.hpp"
#include "corpus/campaign/certified_surface.hpp"
#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/program/replay_case.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/surface_files.hpp"
#include "verify/findings_text.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

// The surface of a finding's folder; it was valid when it was written.
verify::JudgedSurface judged_file(const TriangleSurface& surface, const std::string& path) {
  verify::JudgedSurface judged(surface);
  if (!judged.report().fault.empty()) throw InputError(path + ": " + judged.report().fault);
  return judged;
}

std::string run_text(const Mesher& mesher, const JudgedRun& one, int number, int repeats) {
  const Judgement& j = one.judgement;
  std::string text = fmt::format("{}{}: {}", mesher.name(),
                                 repeats > 1 ? fmt::format(", run {}", number) : "", name_of(j.outcome));
  if (!j.signature.empty()) text += ": " + j.signature;
  text += "\n";
  if (!j.what.empty() && j.what != j.signature) text += "  " + j.what + "\n";
  return text;
}

Json run_json(const Mesher& mesher, const JudgedRun& one) {
  return {{"mesher", mesher.name()},
          {"command", mesher.command()},
          {"outcome", name_of(one.judgement.outcome)},
          {"signature", one.judgement.signature},
          {"what", one.judgement.what}};
}

class Replay {
 public:
  Replay(const ReplayCase& found, const verify::JudgedSurface& surface, std::string scratch)
      : found_(found), surface_(surface), scratch_(std::move(scratch)) {}

  void run(const Mesher& mesher) {
    const int repeats = repeats_of(mesher, found_.options.repeats);
    for (int r = 0; r < repeats; ++r) {
      const std::string folder = fmt::format("{}/{}-{}", scratch_, number_++, r);
      std::filesystem::create_directories(folder);
      const JudgedRun one =
          run_and_judge(mesher, surface_, folder, found_.options.limits, found_.options.judge);
      finding_ = finding_ || is_finding(one.judgement.outcome);
      unjudged_ = unjudged_ || is_unjudged(one.judgement.outcome);
      text += run_text(mesher, one, r + 1, repeats);
      if (one.judgement.report && one.judgement.outcome != Outcome::sound)
        text += verify::report_text(*one.judgement.report, one.run.numbering);
      json.push_back(run_json(mesher, one));
    }
  }
  int exit_code() const {
    return finding_ ? program::wrong : unjudged_ ? program::incomplete : program::sound;
  }

  std::string text;
  Json json = Json::array();

 private:
  const ReplayCase& found_;
  const verify::JudgedSurface& surface_;
  std::string scratch_;
  int number_ = 0;
  bool finding_ = false, unjudged_ = false;
};

}  // namespace

int replay(const FuzzArguments& a, const program::Common& common) {
  const ReplayCase found = find_replay_case(a);
  std::optional<CertifiedSurface> made;
  std::optional<TriangleSurface> read;
  std::optional<verify::JudgedSurface> judged;
  std::string head;
  if (found.surface_file.empty()) {
    made.emplace(found.options, found.index);
    judged = made->judged();
    head = fmt::format("case {} of seed {}, ", found.index, found.options.seed);
  } else {
    read = read_surface(found.surface_file);
    judged = judged_file(*read, found.surface_file);
    head = found.surface_file + ", ";
  }
  head += io::counted(judged->report().triangles, "triangles");
  if (made && !made->recipe().empty()) head += ", " + made->recipe();

  // With --out the files stay, for a look at them.
  std::optional<ScratchFolder> temporary;
  std::string scratch;
  if (a.out.empty()) {
    temporary.emplace("");
    scratch = temporary->path();
  } else {
    scratch = std::filesystem::absolute(a.out + "/replay").string();
    std::filesystem::remove_all(scratch);
    std::filesystem::create_directories(scratch);
    head += "\nfiles: " + scratch;
  }
  Replay runs(found, *judged, scratch);
  {
    program::Progress progress(common);
    for (const ChosenMesher& one : found.meshers) {
      progress.enter(one.mesher->name());
      runs.run(*one.mesher);
    }
  }
  if (!common.json.empty())
    program::write_json(common.json,
                        {{"seed", found.options.seed}, {"case", found.index}, {"runs", runs.json}});
  if (common.json != "-") program::write_text("-", head + "\n" + runs.text);
  return runs.exit_code();
}

}  // namespace tetproof::corpus
