// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the whole mesh.
#include "verify/reports/verdict.hpp"

#include <fmt/core.h>

#include <algorithm>

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

}  // namespace

bool defective(const Report& report) {
  return std::any_of(report.checks.begin(), report.checks.end(),
                     [](const CheckResult& result) { return result.verdict == Verdict::fail; });
}

bool sound(const Report& report) {
  return !defective(report) && report.not_judged.empty();
}

const char* verdict_word(const Report& report) {
  return defective(report) ? "defective" : sound(report) ? "sound" : "incomplete";
}

std::string not_judged_text(const NotJudged& entry) {
  return fmt::format("{} ({})", io::counted(entry.count, entry.what), entry.why);
}

std::string verdict_text(const Report& report) {
  const bool incomplete = !defective(report) && !sound(report);
  std::string text = incomplete ? "incomplete" : sound(report) ? "sound" : "DEFECTIVE";
  if (!report.certificate && report.mesh.tets > 0)
    text += ": no certificate, a check that it needs was skipped";
  else if (!report.certificate || !*report.certificate)
    text += ": no certificate";
  else if (incomplete)
    text += ": certified" + allowed_text(report) + ": " + io::counted(report.mesh.tets, "tetrahedra");
  else
    text += ": certified" + (report.allowed.empty() ? ", " : allowed_text(report) + ": apart from that, ") +
            "the tetrahedra are a valid triangulation of a solid";
  for (std::size_t i = 0; i < report.not_judged.size(); ++i)
    text += (i == 0 ? "; not judged: " : ", ") + not_judged_text(report.not_judged[i]);
  return text;
}

}  // namespace tetproof::verify
