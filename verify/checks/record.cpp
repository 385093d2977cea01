// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/record.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/error.hpp"
#include "verify/checks/root_causes.hpp"

namespace tetproof::verify {

Record::Record(const Options& options, bool with_surface) : by_id_(!options.check.empty()) {
  const bool compared = with_surface && options.region != Region::none;
  constexpr const char* not_compared = "region none: the mesh is not compared with the surface";
  if (with_surface && !compared) report.left_out.push_back({"comparison with the surface", 1, not_compared});
  std::array<bool, check_count> named{}, skipped{};
  for (const std::string& id : options.check) named[static_cast<std::size_t>(check_of_id(id))] = true;
  for (const std::string& id : options.skip) skipped[static_cast<std::size_t>(check_of_id(id))] = true;

  for (const std::string& id : options.allow) {
    const Check check = check_of_id(id);
    if (check != Check::crack && check != Check::non_conforming_interface)
      throw InputError(
          fmt::format("findings of '{}' cannot be allowed, expected crack or non-conforming-interface", id));
    allowed_[static_cast<std::size_t>(check)] = true;
  }

  std::vector<Check> contradictory, not_applicable, missing_surface, unwanted;
  for (std::size_t i = 0; i < check_count; ++i) {
    const auto check = static_cast<Check>(i);
    report.checks.push_back({.check = check});
    const bool applies = compared || !info(check).needs_surface;
    if (named[i] && skipped[i])
      contradictory.push_back(check);
    else if (!applies)
      (named[i] ? missing_surface : not_applicable).push_back(check);
    else if (skipped[i] || (by_id_ && !named[i]))
      unwanted.push_back(check);
  }
  wanted_.fill(true);
  const char* const why = with_surface ? not_compared : "needs a surface";
  drop(contradictory, "asked for and skipped at once", &report.not_judged);
  drop(missing_surface, why, &report.not_judged);
  drop(not_applicable, why, nullptr);
  drop(unwanted, "not asked for", &report.left_out);
}

void Record::drop(const std::vector<Check>& checks, const std::string& why, std::vector<NotJudged>* list) {
  std::string names;
  std::int64_t count = 0;
  for (const Check check : checks) {
    if (!wants(check)) continue;
    wanted_[static_cast<std::size_t>(check)] = false;
    result(check).why = why;
    names += fmt::format("{}{}", count++ ? ", " : "", info(check).id);
  }
  if (list && count > 0) list->push_back({(count == 1 ? "check " : "checks ") + names, count, why});
}

void Record::blame(Cause cause, std::initializer_list<Check> but) {
  for (int i = 0; i < check_count; ++i) {
    const auto check = static_cast<Check>(i);
    if (check != cause.check && std::find(but.begin(), but.end(), check) == but.end())
      (*this)[check].cause = [cause](std::size_t) { return cause; };
  }
}

void Record::settle(const TetMesh& mesh, const Options& options) {
  const CheckCounts excused = separate_causes(mesh, suspects_, allowed_, report);
  const auto fails = [&](const CheckInfo& row) {
    if (row.severity == Severity::topology)
      return options.strict_topology || (report.surface && options.fidelity == 0);
    return row.severity == Severity::fail &&
           !(options.coarse && (row.check == Check::surface_to_mesh || row.check == Check::missing_region));
  };
  bool violated = false, open = false;
  for (CheckResult& result : report.checks) {
    const CheckInfo& row = info(result.check);
    const bool held = result.count + result.consequences == 0;
    // All that was found is meant, or follows from what is meant.
    const bool meant = (result.count == 0 || allows(result.check)) &&
                       result.consequences == excused[static_cast<std::size_t>(result.check)];
    if (allows(result.check) && result.count > 0) report.allowed.push_back({result.check, result.count});
    if (row.certificate) {
      violated = violated || !(held || meant);
      open = open || !wants(result.check);
    }
    if (!wants(result.check))
      result.verdict = Verdict::skipped;
    else if (!held)
      result.verdict = fails(row) && !meant ? Verdict::fail : Verdict::warning;
    else if (result.verdict != Verdict::undecided)
      result.verdict = Verdict::pass;
  }
  if (mesh.tets.empty())
    report.not_judged.push_back({"mesh", 1, "it has no tetrahedra"});
  else if (violated)
    report.certificate = false;
  else if (!open)
    report.certificate = true;
}

}  // namespace tetproof::verify
