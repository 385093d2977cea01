// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the whole mesh: the first line of every report.
#include "verify/reports/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/words.hpp"
#include "verify/findings_text.hpp"

namespace tetproof::verify {
namespace {

// " except for what is allowed: 12 crack": the certificate does not cover it.
std::string allowed_text(const Report& report) {
  std::string text;
  for (const Consequence& meant : report.allowed)
    text += fmt::format("{}{} {}", text.empty() ? " except for what is allowed (" : ", ", meant.count,
                        info(meant.check).id);
  return text.empty() ? text : text + ")";
}

// What is known of the mesh by itself. refused: a check that the proof needs did not hold; open: one was not
// made.
enum Proof { certified = 1, refused = 2, open = 4, empty = 8 };
// What is known of the mesh against the surface. apart: it was not compared, or not by all checks.
enum Against { apart = 1, fills = 2, differs = 4 };
// Whether a check of the mesh by itself failed.
enum Own { holds = 1, fails = 2 };

// All first lines. A row is for sets of cases; the first one that fits counts. {own} and {surface} are the
// checks that failed, {certified} is "certified" or "certified by corners".
struct Line {
  std::string_view word;
  int proof, own, against;
  std::string_view text;
};
// clang-format off
constexpr Line lines[] = {
  {"sound", certified, holds, apart, "{certified}: {tets}, a valid triangulation of a solid"},
  {"sound", certified, holds, fills, "{certified}: {tets}, a valid triangulation of a solid that fills the surface"},
  {"sound", open, holds, apart, "only as far as asked: {tets} without a certificate"},
  {"sound", open, holds, fills, "only as far as asked: {tets} without a certificate, which fill the surface"},
  {"sound", refused, holds, apart | fills, "no certificate, but nothing is wrong that is not allowed: {tets}"},
  {"incomplete", certified, holds, apart, "{certified}: {tets}"},
  {"incomplete", certified, holds, fills, "{certified}: {tets} that fill the surface"},
  {"incomplete", open, holds, apart | fills, "no certificate, checks that it needs were not made: {tets}"},
  {"incomplete", refused, holds, apart | fills, "no certificate, but nothing was found that is not allowed: {tets}"},
  {"incomplete", empty, holds, apart | fills, "no certificate, the mesh is empty"},
  {"defective", refused, fails, apart | fills, "no certificate, no valid triangulation of a solid ({own})"},
  {"defective", refused, fails, differs, "no certificate, no valid triangulation of a solid ({own}); nor does it fill the surface ({surface})"},
  {"defective", refused, holds, differs, "the mesh does not fill the surface ({surface}); no certificate"},
  {"defective", certified, fails, apart | fills, "{own}, though by exact arithmetic the mesh is a valid triangulation ({certified}: {tets})"},
  {"defective", certified, fails, differs, "{own}, and the mesh does not fill the surface ({surface}), though by exact arithmetic it is a valid triangulation ({certified}: {tets})"},
  {"defective", certified, holds, differs, "the mesh does not fill the surface ({surface}); by itself it is a valid triangulation ({certified}: {tets})"},
  {"defective", open, fails, apart | fills, "{own}; no certificate, checks that it needs were not made"},
  {"defective", open, fails, differs, "{own}, and the mesh does not fill the surface ({surface}); no certificate, checks that it needs were not made"},
  {"defective", open, holds, differs, "the mesh does not fill the surface ({surface}); no certificate, checks that it needs were not made"},
  {"defective", empty, holds, differs, "the mesh does not fill the surface ({surface}): no certificate, it is empty"},
  {"defective", empty, fails, apart | fills | differs, "{own}; no certificate, the mesh is empty"},
};
// clang-format on

Proof proof_of(const Report& report) {
  if (report.certificate) return *report.certificate ? certified : refused;
  return report.mesh.tets == 0 ? empty : open;
}

// The ids of these checks; without those that are mere consequences of others, if there are any others.
std::string ids(const std::vector<const CheckResult*>& results) {
  std::string roots, all;
  for (const CheckResult* result : results)
    for (std::string* text : {&all, &roots})
      if (text == &all || result->count > 0)
        *text += (text->empty() ? "" : ", ") + std::string(info(result->check).id);
  return roots.empty() ? all : roots;
}

template <class Wanted>
std::vector<const CheckResult*> results(const Report& report, const Wanted& wanted) {
  std::vector<const CheckResult*> found;
  for (const CheckResult& result : report.checks)
    if (wanted(result)) found.push_back(&result);
  return found;
}

std::string failed(const Report& report, bool against_surface) {
  return ids(results(report, [=](const CheckResult& result) {
    return result.verdict == Verdict::fail && info(result.check).needs_surface == against_surface;
  }));
}

// Whether all checks that could show that the surface is not filled were made, and none did.
bool is_filled(const Report& report) {
  return std::all_of(report.checks.begin(), report.checks.end(), [](const CheckResult& result) {
    const CheckInfo& row = info(result.check);
    return !row.needs_surface || row.severity != Severity::fail || result.verdict == Verdict::pass;
  });
}

bool is_of_checks(const NotJudged& entry) {
  return entry.what.starts_with("check");
}

std::string full_name_of(const NotJudged& entry) {
  return is_of_checks(entry) ? entry.what : name_of(entry);
}

std::string list(const char* title, const std::vector<NotJudged>& entries) {
  std::string text;
  for (const NotJudged& entry : entries) text += (text.empty() ? title : ", ") + name_of(entry);
  return text;
}

}  // namespace

bool defective(const Report& report) {
  return std::any_of(report.checks.begin(), report.checks.end(),
                     [](const CheckResult& result) { return result.verdict == Verdict::fail; });
}

bool sound(const Report& report) {
  return !defective(report) && report.not_judged.empty();
}

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::warning:
      return "warning";
    case Verdict::fail:
      return "fail";
    case Verdict::undecided:
      return "undecided";
    case Verdict::skipped:
      return "skipped";
  }
  return "";
}

const char* verdict_word(const Report& report) {
  return defective(report) ? "defective" : sound(report) ? "sound" : "incomplete";
}

std::string name_of(const NotJudged& entry) {
  if (is_of_checks(entry)) return entry.count <= 3 ? entry.what : fmt::format("{} checks", entry.count);
  return io::singular(entry.what) == entry.what ? entry.what : io::counted(entry.count, entry.what);
}

std::string verdict_text(const Report& report) {
  const std::string_view word = verdict_word(report);
  const std::string own = failed(report, false), surface = failed(report, true);
  const Against against = !surface.empty() ? differs : is_filled(report) ? fills : apart;
  const Line* const line = std::find_if(std::begin(lines), std::end(lines), [&](const Line& row) {
    return row.word == word && (row.proof & proof_of(report)) && (row.own & (own.empty() ? holds : fails)) &&
           (row.against & against);
  });
  if (line == std::end(lines)) throw std::logic_error("a verdict without a line");
  std::string text =
      fmt::format("{}: ", word == "defective" ? "DEFECTIVE" : word) +
      fmt::format(fmt::runtime(line->text), fmt::arg("own", own), fmt::arg("surface", surface),
                  fmt::arg("certified",
                           (report.by_corners ? "certified by corners" : "certified") + allowed_text(report)),
                  fmt::arg("tets", io::counted(report.mesh.tets, "tetrahedra")));
  for (const auto& [title, verdict] :
       {std::pair{"; undecided: ", Verdict::undecided}, {"; warnings: ", Verdict::warning}})
    if (const auto found = results(report, [v = verdict](const CheckResult& r) { return r.verdict == v; });
        !found.empty() && word != "defective")
      text += title + ids(found);
  return text + list("; not judged: ", report.not_judged) + list("; left out: ", report.left_out);
}

std::string scope_text(const Report& report) {
  std::string text;
  for (const NotJudged& entry : report.not_judged)
    text += fmt::format("unjudged  {}: {}\n", full_name_of(entry), entry.why);
  for (const NotJudged& entry : report.left_out)
    text += fmt::format("left out  {}: {}\n", name_of(entry), entry.why);
  return text;
}

}  // namespace tetproof::verify
