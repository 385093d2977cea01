// SPDX-License-Identifier: GPL-3.0-or-later
#include "score.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;

bool has(const std::vector<Index>& sorted, Index i) {
  return std::binary_search(sorted.begin(), sorted.end(), i);
}

bool names(const verify::Finding& finding, const corpus::PlantedRoot& planted) {
  const auto vertex = [&](Index v) { return has(planted.vertices, v); };
  return std::any_of(finding.tets.begin(), finding.tets.end(),
                     [&](Index t) { return has(planted.tets, t); }) ||
         std::any_of(finding.vertices.begin(), finding.vertices.end(), vertex) ||
         std::any_of(finding.faces.begin(), finding.faces.end(),
                     [&](const auto& face) { return std::any_of(face.begin(), face.end(), vertex); });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string roots(const verify::Report& report) {
  std::vector<std::string> ids;
  for (const verify::CheckResult& result : report.checks)
    if (result.count > 0) ids.push_back(fmt::format("{} {}", info(result.check).id, result.count));
  return ids.empty() ? "no roots" : "roots: " + joined(ids);
}

}  // namespace

std::string objection(const corpus::Planted& planted, const verify::Report& report) {
  const std::string found = "; " + roots(report);
  const bool defective = planted.expected == corpus::Expected::defective;
  if (sound(report) == defective)
    return std::string("verdict ") + (defective ? "sound, it is defective" : "defective, it is sound") +
           found;
  if (report.certificate != planted.truth.valid())
    return std::string("certificate ") +
           (planted.truth.valid() ? "refused, it is valid" : "given, it is not valid") + found;
  for (const verify::CheckResult& result : report.checks)
    if (result.count > 0 &&
        std::count(planted.admissible.begin(), planted.admissible.end(), info(result.check).id) == 0)
      return std::string("root ") + info(result.check).id + " (" +
             (result.findings.empty() ? "" : result.findings[0].what) +
             "), admissible: " + joined(planted.admissible) + found;
  for (const corpus::PlantedRoot& root : planted.needed) {
    const bool named = std::any_of(root.ids.begin(), root.ids.end(), [&](const std::string& id) {
      const auto& findings = report[verify::check_of_id(id)].findings;
      return std::any_of(findings.begin(), findings.end(),
                         [&](const verify::Finding& f) { return names(f, root); });
    });
    if (!named) return "no root at the planted place, expected one of: " + joined(root.ids) + found;
  }
  for (const auto& [check, list] :
       {std::pair{Check::inverted, &planted.truth.negative}, {Check::flat, &planted.truth.flat}})
    for (const verify::Finding& finding : report[check].findings)  // of several, if nearly all are
      if (finding.tets.empty() ||
          !std::all_of(finding.tets.begin(), finding.tets.end(), [&](Index t) { return has(*list, t); }))
        return std::string(info(check).id) + ": one that is not" + found;
  return {};
}

std::string objection_to_sound(const corpus::Truth& truth, const verify::Report& report) {
  for (const verify::CheckResult& result : report.checks)
    if (result.count + result.consequences > 0 &&
        !(result.verdict == verify::Verdict::warning && truth.confirms(info(result.check).id)))
      return roots(report);
  return report.certificate == true ? "" : "no certificate";
}

}  // namespace tetproof::test
