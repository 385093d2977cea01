// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/program/replay_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "corpus/campaign/journal.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

CampaignOptions options_of(const FuzzArguments& a) {
  return {.seed = a.seed,
          .cases = a.cases,
          .surfaces = a.surfaces,
          .limits = a.limits,
          .judge = a.judge,
          .repeats = a.repeats};
}

// Takes over what the campaign was run with. `mesher`: the one of the case; empty: all.
void follow(const CampaignSettings& settings, const std::string& mesher, const FuzzArguments& a,
            ReplayCase& found) {
  found.options.seed = settings.seed;
  found.options.cases = settings.cases;
  found.options.surfaces = settings.surfaces;
  found.options.limits = settings.limits;
  found.options.judge = settings.judge;
  found.options.repeats = settings.repeats;
  if (!a.mesher.command.empty() || !a.mesher.presets.empty()) {
    found.meshers = choose_meshers(a.mesher);
    return;
  }
  for (const MesherFacts& facts : settings.meshers) {
    if (!mesher.empty() && facts.name != mesher) continue;
    if (facts.words.empty())
      throw InputError(fmt::format("the journal does not say how to run '{}': name it by --mesher or COMMAND",
                                   facts.name));
    std::vector<ChosenMesher> chosen = choose_meshers(facts.words);
    std::move(chosen.begin(), chosen.end(), std::back_inserter(found.meshers));
  }
}

void check_index(const CampaignSettings& settings, std::uint64_t index, const std::string& folder) {
  if (index >= settings.cases)
    throw InputError(fmt::format("{}: has the cases 0 to {}, not {}", folder, settings.cases - 1, index));
}

// DIR/findings/NAME: the surface of the folder. A journal in DIR that knows it says with which mesher;
// without one, as where the folder was moved, the command line must.
ReplayCase finding(const fs::path& folder, const FuzzArguments& a) {
  ReplayCase found{.options = options_of(a)};
  found.surface_file = (folder / "surface.off").string();
  if (!fs::exists(found.surface_file))
    throw InputError(fmt::format("{}: expected the folder of a finding, with surface.off", folder.string()));
  const fs::path campaign = fs::absolute(folder).parent_path().parent_path();
  for (const std::string& path : journals_in(campaign.string())) {
    const JournalContent journal = read_journal(path);
    for (const ShrunkCase& one : journal.shrunk)
      if (fs::path(one.folder).filename() == folder.filename()) {
        follow(journal.settings, one.mesher, a, found);
        found.index = one.index;
        return found;
      }
  }
  if (a.mesher.command.empty() && a.mesher.presets.empty())
    throw InputError(
        fmt::format("{}: no journal in {} names this finding: name the mesher by --mesher or COMMAND",
                    folder.string(), campaign.string()));
  found.meshers = choose_meshers(a.mesher);
  return found;
}

ReplayCase case_of_folder(const fs::path& path, std::uint64_t index, const FuzzArguments& a) {
  const std::string folder = path.parent_path().string();
  const CampaignSettings settings = merge_campaign({folder}).settings;
  check_index(settings, index, folder);
  ReplayCase found{.options = options_of(a), .index = index};
  follow(settings, "", a, found);
  return found;
}

ReplayCase case_of_group(const FuzzArguments& a) {
  if (a.out.empty())
    throw InputError(
        fmt::format("--replay: expected SEED:INDEX, DIR/INDEX, the folder of a finding, or a group's id "
                    "with --out DIR, found '{}'",
                    a.replay));
  const CampaignResult result = merge_campaign({a.out});
  const auto group = std::find_if(result.groups.begin(), result.groups.end(),
                                  [&](const FailureGroup& one) { return one.id() == a.replay; });
  if (group == result.groups.end()) throw InputError(fmt::format("{}: has no group '{}'", a.out, a.replay));
  ReplayCase found{.options = options_of(a), .index = group->cases.front().index};
  follow(result.settings, group->cases.front().mesher, a, found);
  return found;
}

}  // namespace

ReplayCase find_replay_case(const FuzzArguments& a) {
  const std::size_t colon = a.replay.find(':');
  if (colon != std::string::npos) {
    const auto seed = number(std::string_view(a.replay).substr(0, colon));
    const auto index = number(std::string_view(a.replay).substr(colon + 1));
    if (seed && index) {
      ReplayCase found{.options = options_of(a), .index = *index, .meshers = choose_meshers(a.mesher)};
      found.options.seed = *seed;
      return found;
    }
  }
  fs::path path(a.replay);
  if (path.filename().empty()) path = path.parent_path();  // a slash at the end
  if (fs::is_directory(path)) return finding(path, a);
  const auto index = number(path.filename().string());
  if (index && path.has_parent_path() && fs::is_directory(path.parent_path()))
    return case_of_folder(path, *index, a);
  return case_of_group(a);
}

}  // namespace tetproof::corpus
