// SPDX-License-Identifier: GPL-3.0-or-later
// The report as JUnit XML, the form in which CI systems take test results. Written by hand, without a library
// for XML: it is flat, and characters that XML cannot hold (most control characters, bytes that are no UTF-8)
// would have to be replaced all the same.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "io/bytes/xml_text.hpp"
#include "verify/findings_text.hpp"
#include "verify/reports/verdict.hpp"

namespace tetproof::verify {
namespace {

using io::xml_escaped;

std::string as_text(std::string_view text) {
  return xml_escaped(text, io::XmlLines::keep);
}

std::string property(const char* name, std::string_view value) {
  return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, xml_escaped(value));
}

// The body of a test case; empty if the check passed.
std::string outcome(const CheckResult& result, const Numbering& numbering) {
  const CheckInfo& row = info(result.check);
  switch (result.verdict) {
    case Verdict::pass:
      return {};
    case Verdict::skipped:
      return fmt::format("      <skipped message=\"{}\"/>\n", xml_escaped(result.why));
    case Verdict::undecided:
      return fmt::format(
          "      <system-out>undecided: measured {:.6g}, allowed {:.6g}, the difference is inside the stated "
          "error\n</system-out>\n",
          result.measured.value_or(0), result.allowed.value_or(0));
    case Verdict::warning:
      return "      <system-out>" + as_text(check_text(result, numbering)) + "</system-out>\n";
    case Verdict::fail:
      break;
  }
  const std::string text = check_text(result, numbering);
  const std::string first = result.findings.empty() ? "follows from what another check found"
                                                    : finding_text(result.findings[0], numbering);
  return fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n", row.id,
                     xml_escaped(first.substr(0, first.find('\n'))), as_text(text));
}

}  // namespace

std::string report_junit(const Report& report, const std::string& mesh, const Numbering& numbering) {
  const auto with = [&](Verdict verdict) {
    return std::count_if(report.checks.begin(), report.checks.end(),
                         [&](const CheckResult& result) { return result.verdict == verdict; });
  };
  const std::array scope{std::pair{&report.not_judged, "not judged"},
                         std::pair{&report.left_out, "left out"}};
  const std::size_t entries = report.not_judged.size() + report.left_out.size();
  double total = 0;
  for (const auto& [phase, seconds] : report.seconds) total += seconds;
  const std::string time = report.seconds.empty() ? "" : fmt::format(" time=\"{:.3f}\"", total);
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"{}",
                                         report.checks.size() + entries, with(Verdict::fail),
                                         static_cast<std::size_t>(with(Verdict::skipped)) + entries, time);

  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format("<testsuites name=\"tetproof-verify\" {}>\n", counts);
  xml += fmt::format("  <testsuite name=\"{}\" {}>\n    <properties>\n", xml_escaped(mesh), counts);
  xml += property("verdict", verdict_word(report));
  xml += property("certificate", !report.certificate ? "unknown" : *report.certificate ? "true" : "false");
  xml += property("points", fmt::format("{}", report.mesh.points));
  xml += property("tetrahedra", fmt::format("{}", report.mesh.tets));
  xml += property("boundary_faces", fmt::format("{}", report.mesh.boundary_faces));
  for (const auto& [phase, seconds] : report.seconds)
    xml += property(("seconds of " + phase).c_str(), fmt::format("{:.3f}", seconds));
  xml += "    </properties>\n";
  for (const CheckResult& result : report.checks) {
    const std::string inside = outcome(result, numbering);
    xml += fmt::format("    <testcase classname=\"{}\" name=\"{}\"{}\n", xml_escaped(mesh),
                       info(result.check).id, inside.empty() ? "/>" : ">");
    if (!inside.empty()) xml += inside + "    </testcase>\n";
  }
  for (const auto& [list, is] : scope)
    for (const NotJudged& entry : *list)
      xml += fmt::format(
          "    <testcase classname=\"{}\" name=\"{}: {}\">\n      <skipped message=\"{}: {}\"/>\n    "
          "</testcase>\n",
          xml_escaped(mesh), is, xml_escaped(entry.what), xml_escaped(name_of(entry)),
          xml_escaped(entry.why));
  xml += "    <system-out>" + as_text(report_text(report, numbering)) + "</system-out>\n";
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace tetproof::verify
