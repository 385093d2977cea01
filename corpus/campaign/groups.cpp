// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "corpus/campaign/known_groups.hpp"
#include "corpus/campaign/settings.hpp"
#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {
namespace {

// A group's identity, worst outcomes first.
using Key = std::tuple<int, std::string, std::string>;  // minus severity, preset, signature

// The case as a member of the group of one of its failures.
CaseResult with_failure(const CaseResult& result, const FurtherFailure& failure) {
  CaseResult member = result;
  member.outcome = failure.outcome;
  member.signature = failure.signature;
  member.what = failure.what;
  member.failed = failure.failed;
  member.further = {};
  return member;
}

void sort_cases(FailureGroup& group) {
  std::sort(group.cases.begin(), group.cases.end(), [](const CaseResult& a, const CaseResult& b) {
    return std::tie(a.triangles, a.index, a.mesher) < std::tie(b.triangles, b.index, b.mesher);
  });
  std::set<std::string> variants;
  std::set<std::uint64_t> surfaces;
  for (const CaseResult& member : group.cases) {
    variants.insert(member.mesher);
    surfaces.insert(member.index);
  }
  group.variants.assign(variants.begin(), variants.end());
  group.surfaces = static_cast<std::int64_t>(surfaces.size());
}

}  // namespace

int severity(Outcome outcome) {
  static constexpr std::array order{Outcome::sound,         Outcome::not_compiled_in,
                                    Outcome::refused,       Outcome::out_of_memory,
                                    Outcome::slow,          Outcome::not_judged,
                                    Outcome::refused_valid, Outcome::no_output,
                                    Outcome::no_tetrahedra, Outcome::unreadable,
                                    Outcome::crashed,       Outcome::wrong_against_surface,
                                    Outcome::wrong};
  static_assert(order.size() == outcome_count);
  return static_cast<int>(std::find(order.begin(), order.end(), outcome) - order.begin());
}

bool is_unjudged(Outcome outcome) {
  return outcome == Outcome::slow || outcome == Outcome::out_of_memory ||
         outcome == Outcome::not_compiled_in || outcome == Outcome::not_judged;
}

std::string FailureGroup::id() const {
  return group_id(mesher, name_of(outcome), signature);
}

std::vector<FailureGroup> group_failures(const std::vector<CaseResult>& cases,
                                         const std::vector<std::string>& known) {
  std::map<Key, FailureGroup> groups;
  const auto add = [&](CaseResult member) {
    const std::string preset = preset_of(member.mesher);
    FailureGroup& group = groups[{-severity(member.outcome), preset, member.signature}];
    group.mesher = preset;
    group.outcome = member.outcome;
    group.signature = member.signature;
    group.cases.push_back(std::move(member));
  };
  for (const CaseResult& result : cases) {
    if (is_finding(result.outcome)) add(result);
    for (const FurtherFailure& failure : result.further)
      if (is_finding(failure.outcome)) add(with_failure(result, failure));
  }
  const std::set<std::string> known_ids(known.begin(), known.end());
  std::vector<FailureGroup> sorted;
  for (auto& [key, group] : groups) {
    sort_cases(group);
    group.known = known_ids.contains(group.id());
    sorted.push_back(std::move(group));
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const FailureGroup& a, const FailureGroup& b) {
    return std::tuple(-severity(a.outcome), -a.surfaces) < std::tuple(-severity(b.outcome), -b.surfaces);
  });
  return sorted;
}

}  // namespace tetproof::corpus
