// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/record.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/error.hpp"
#include "verify/checks/root_causes.hpp"

namespace tetproof::verify {

Record::Record(const Options& options, bool with_surface) {
  wanted_.fill(options.check.empty());
  for (const std::string& id : options.check) wanted_[static_cast<std::size_t>(check_of_id(id))] = true;
  for (const std::string& id : options.skip) wanted_[static_cast<std::size_t>(check_of_id(id))] = false;
  for (const std::string& id : options.allow) {
    const Check check = check_of_id(id);
    if (check != Check::crack && check != Check::non_conforming_interface)
      throw InputError(
          fmt::format("findings of '{}' cannot be allowed, expected crack or non-conforming-interface", id));
    allowed_[static_cast<std::size_t>(check)] = true;
  }
  for (int i = 0; i < check_count; ++i) {
    const auto check = static_cast<Check>(i);
    if (info(check).needs_surface && (!with_surface || options.region == Region::none)) leave_out({check});
    report.checks.push_back({.check = check});
  }
}

void Record::leave_out(std::initializer_list<Check> checks) {
  for (const Check check : checks) wanted_[static_cast<std::size_t>(check)] = false;
}

void Record::could_not_run(std::initializer_list<Check> checks, const std::string& why) {
  std::string names;
  std::int64_t count = 0;
  for (const Check check : checks)
    if (wants(check)) names += fmt::format("{}{}", count++ ? ", " : "", info(check).id);
  if (count > 0) report.not_judged.push_back({(count == 1 ? "check " : "checks ") + names, count, why});
  leave_out(checks);
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
