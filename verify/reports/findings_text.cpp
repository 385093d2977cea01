// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/findings_text.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace tetproof::verify {
namespace {

constexpr std::size_t shown = 5;  // elements of a finding

// " (the 2nd with this number)"; empty for 0: no other has it.
std::string nth(std::int32_t n) {
  if (n == 0) return "";
  const char* const ending = n / 10 % 10 == 1 ? "th"
                             : n % 10 == 1    ? "st"
                             : n % 10 == 2    ? "nd"
                             : n % 10 == 3    ? "rd"
                                              : "th";
  return fmt::format(" (the {}{} with this number)", n, ending);
}

std::string place(const Finding& finding, const Numbering& numbering) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* many, const auto& name,
                       const char* of = "") {
    if (count == 0) return;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", count == 1 ? one : many);
    for (std::size_t i = 0; i < count && i < shown; ++i) text += (i ? ", " : " ") + name(i);
    if (count > shown) text += fmt::format(", ... ({}{} in all)", count, of);
  };
  if (!finding.tet_runs.empty())
    add(
        finding.tet_runs.size(), "tetrahedra", "tetrahedra",
        [&](std::size_t i) {
          const auto& [first, last] = finding.tet_runs[i];
          return first == last ? fmt::format("{}", numbering.tet(first))
                               : fmt::format("{}-{}", numbering.tet(first), numbering.tet(last));
        },
        " runs");
  else
    add(finding.tets.size(), "tetrahedron", "tetrahedra", [&](std::size_t i) {
      return fmt::format("{}{}", numbering.tet(finding.tets[i]), nth(numbering.nth_tet(finding.tets[i])));
    });
  add(finding.faces.size(), "face", "faces", [&](std::size_t i) {
    const auto& [a, b, c] = finding.faces[i];
    return fmt::format("({} {} {})", numbering.point(a), numbering.point(b), numbering.point(c));
  });
  add(finding.vertices.size(), "vertex", "vertices", [&](std::size_t i) {
    const Index v = finding.vertices[i];
    return fmt::format("{}{}", numbering.point(v), nth(numbering.nth_point(v)));
  });
  if (finding.point)
    text += fmt::format("{}at ({:.9g}, {:.9g}, {:.9g})", text.empty() ? "" : " ", finding.point->x(),
                        finding.point->y(), finding.point->z());
  return text;
}

}  // namespace

std::string region_text(const RegionTag& tag) {
  return (tag.kind.empty() ? "" : tag.kind + " ") + fmt::format("{}", tag.tag) +
         (tag.name.empty() ? "" : " (" + tag.name + ")");
}

std::string finding_text(const Finding& finding, const Numbering& numbering) {
  const std::string where = place(finding, numbering);
  std::string text = fmt::format("{}{}{}\n", where, where.empty() ? "" : ": ", finding.what);
  for (const Consequence& c : finding.consequences)
    text += fmt::format("  from this follows: {} {}\n", c.count, info(c.check).id);
  return text;
}

std::string findings_text(const CheckResult& result, const Numbering& numbering, std::size_t most) {
  std::string text;
  const std::size_t here = std::min(most, result.findings.size());
  for (std::size_t i = 0; i < here; ++i) {
    const std::string lines = finding_text(result.findings[i], numbering);
    for (std::size_t start = 0, end; start < lines.size(); start = end) {
      end = lines.find('\n', start) + 1;
      text += "  " + lines.substr(start, end - start);
    }
  }
  if (result.count > static_cast<std::int64_t>(here))
    text += fmt::format("  ... {} more\n", result.count - static_cast<std::int64_t>(here));
  return text;
}

std::string check_text(const CheckResult& result, const Numbering& numbering, std::size_t most) {
  std::string text =
      fmt::format("{} {}", result.verdict == Verdict::fail ? "FAIL" : "warning", info(result.check).id);
  if (result.count > 0) text += fmt::format(": {}", result.count);
  if (result.consequences > 0)
    text += fmt::format(
        "{} {} of what is found above", result.count > 0 ? ", and" : ":",
        result.consequences == 1 ? "1 consequence" : fmt::format("{} consequences", result.consequences));
  return text + "\n" + findings_text(result, numbering, most);
}

std::string if_mended_text(const Report& report, const Numbering& numbering, std::size_t most) {
  if (!report.if_mended) return {};
  const Mended& mended = *report.if_mended;
  std::string remains;
  for (const Verdict verdict : {Verdict::fail, Verdict::warning})
    for (const CheckResult& result : mended.checks)
      if (result.verdict == verdict) remains += check_text(result, numbering, most);
  std::string text = fmt::format("judged again with {}: {}; {}\n", mended.how,
                                 mended.certificate == true    ? "certified"
                                 : mended.certificate == false ? "no certificate"
                                                               : "no certificate, a check was not made",
                                 remains.empty() ? "nothing is wrong" : "this remains");
  for (std::size_t start = 0, end; start < remains.size(); start = end) {
    end = remains.find('\n', start) + 1;
    text += "  " + remains.substr(start, end - start);
  }
  return text;
}

std::string failure_text(const Report& report, const Numbering& numbering, std::size_t most) {
  std::string text = verdict_text(report) + "\n" + scope_text(report);
  for (const CheckResult& result : report.checks) {
    if (result.verdict != Verdict::fail) continue;
    text += check_text(result, numbering, most);
    most -= std::min(most, result.findings.size());
  }
  text += if_mended_text(report, numbering, most);
  return text;
}

}  // namespace tetproof::verify
