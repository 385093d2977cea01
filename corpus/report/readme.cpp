// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/readme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

std::string with_thousands(std::int64_t n) {
  return n < 1000 ? fmt::format("{}", n) : fmt::format("{},{:03}", with_thousands(n / 1000), n % 1000);
}

// In Markdown's code quotes, on one line, cut where it is long.
std::string quoted(std::string text, std::size_t most = 300) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '`') c = c == '`' ? '\'' : ' ';
  if (text.size() > most) {
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80)
      --most;  // no half of a letter
    text.resize(most);
    text += " ...";
  }
  return fmt::format("`{}`", text);
}

}  // namespace

std::string readme(const ReadmeFacts& about) {
  const auto& [facts, statements, mesh, command, surface, files] = about;
  const Outcome outcome = facts.judgement.outcome;
  std::string text = fmt::format("# {}: {}\n\n", facts.mesher->name(), statements.headline);
  const std::string version = facts.mesher->version();
  text += fmt::format("- **Mesher**: {}, {}. Command, in this folder: {}\n", facts.mesher->name(),
                      version.empty() ? "of unknown version" : fmt::format("which says: {}", version),
                      command.empty() ? "a C++ function" : quoted(command));
  const std::string& what = facts.judgement.what.empty() ? facts.run.message : facts.judgement.what;
  text +=
      fmt::format("- **What is wrong**: {} ({}; group {}).{}\n", statements.headline, name_of(outcome),
                  quoted(facts.judgement.signature), what.empty() ? "" : fmt::format(" {}", quoted(what)));
  const std::string of = mesh.checked.empty() ? "" : fmt::format("In `{}`: ", mesh.checked);
  const bool without_surface = statements.list.size() > 1;
  std::string seen;
  for (std::size_t i = 0; i + (without_surface ? 1 : 0) < statements.list.size(); ++i)
    seen += fmt::format("{}{}", i == 0 ? "" : "; ", statements.list[i].at("text").get<std::string>());
  text += fmt::format("- **To see it without us**: {}{}.\n",
                      outcome == Outcome::wrong || outcome == Outcome::wrong_against_surface ? of : "", seen);
  if (without_surface)
    text += fmt::format("- **The surface**: {}.\n", statements.list.back().at("text").get<std::string>());
  const bool by_run = std::any_of(statements.list.begin(), statements.list.end(),
                                  [](const auto& one) { return one.at("kind") == "run"; });
  text += fmt::format(
      "- **Proof**: `python3 ../check.py .` (in this folder) {}, in exact fractions and by brute "
      "force, with Python's standard library and no code of the judge.{}\n",
      by_run ? "proves that the surface is valid" : "computes this anew from the files",
      by_run ? " How the command ends, only a run of the mesher shows." : "");
  std::string often = facts.repeats > 1
                          ? fmt::format("{} of {} runs of this surface; ", facts.failed, facts.repeats)
                          : std::string();
  text += fmt::format("- **How often**: {}in {} of {} random surfaces.\n", often, with_thousands(facts.cases),
                      with_thousands(facts.cases_run));
  const std::string recipe = recipe_text(facts.original.recipe);
  text += fmt::format(
      "- **Found with**: `tetproof-fuzz --mesher {}`, case {} of seed {}: {}, {}. Shrunk to {}{}{}.\n",
      facts.mesher->name(), facts.index, facts.seed, quoted(recipe),
      io::counted(facts.original.surface.triangles.size(), "triangles"), surface.triangles.size(),
      facts.shrunk_recipe.empty() ? "" : fmt::format(", {}", quoted(facts.shrunk_recipe)),
      facts.shrink_steps.empty() ? "" : fmt::format(" ({})", facts.shrink_steps));
  if (const auto& warnings = facts.run.warnings; !warnings.empty())
    text += fmt::format(
        "- **It warned**: {}{}.\n", quoted(warnings.front()),
        warnings.size() > 1 ? fmt::format(" and {}", io::counted(warnings.size() - 1, "further lines")) : "");
  if (!facts.since.empty()) text += fmt::format("- **Since**: {}\n", facts.since);
  std::string list;
  for (const std::string& file : files) list += fmt::format("{}`{}`", list.empty() ? "" : ", ", file);
  text += fmt::format(
      "- **Files**: {}.{}\n\n![The surface and the defect](picture.svg)\n", list,
      mesh.checked.ends_with("converted.msh")
          ? fmt::format(" `{}` is `{}` point for point, with numbers from 1.", mesh.checked, mesh.file)
          : "");
  return text;
}

}  // namespace tetproof::corpus
