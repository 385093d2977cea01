// SPDX-License-Identifier: GPL-3.0-or-later
// The judge and the scale: the zoo multiplied by powers of two, which changes no digit, along all axes or
// one, and judged with any set of the checks that the certificate does not need. Nothing of that may change
// what is proved.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "corpus/bad_meshes.hpp"
#include "corpus/generators/random.hpp"
#include "scaled.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

const std::vector<corpus::BadMesh>& zoo() {
  static const std::vector<corpus::BadMesh> all = corpus::bad_meshes();
  return all;
}

using Powers = std::array<int, 3>;

std::string name_of(const Powers& power) {
  return "2^" + std::to_string(power[0]) + ", 2^" + std::to_string(power[1]) + ", 2^" +
         std::to_string(power[2]);
}

// What a report found, check by check. `where`: with the first finding's elements.
std::string found(const verify::Report& report) {
  std::string text = report.certificate == true ? "certified" : "refused";
  for (const verify::CheckResult& result : report.checks) {
    if (result.count + result.consequences == 0) continue;
    text += std::string("; ") + info(result.check).id + " " + std::to_string(result.count) + "+" +
            std::to_string(result.consequences);
    if (result.findings.empty()) continue;
    for (const Index t : result.findings[0].tets) text += " t" + std::to_string(t);
    for (const Index v : result.findings[0].vertices) text += " v" + std::to_string(v);
  }
  return text;
}

bool holds(const verify::Report& report, verify::Check check) {
  return report[check].count + report[check].consequences == 0;
}

// Judges each mesh of the zoo with each of these powers, and collects what `objection` says.
template <class Objection>
void judge_all(const std::vector<Powers>& powers, int least, const Objection& objection) {
  std::mutex saying;
  std::string said;
  int judged = 0;
  tbb::parallel_for(std::size_t{0}, zoo().size(), [&](std::size_t i) {
    const corpus::BadMesh& bad = zoo()[i];
    const verify::Report before = verify::verify(bad.planted.mesh, {.quality = false});
    for (const Powers& power : powers) {
      const auto mesh = scaled(bad.planted.mesh, power);
      if (!mesh) continue;
      const std::string text = objection(bad, before, verify::verify(*mesh, {.quality = false}));
      const std::lock_guard lock(saying);
      ++judged;
      if (!text.empty()) said += bad.name + " times " + name_of(power) + ": " + text + "\n";
    }
  });
  EXPECT_EQ(said, "");
  EXPECT_GE(judged, least);
}

TEST(Scales, TheVerdictOfTheZooIsTheSameAtEveryPowerOfTwo) {
  std::vector<Powers> powers;
  for (const int k : {-1000, -890, -777, -640, -531, -520, -410, -300, -173, -40, 40, 175, 260, 340, 505, 513,
                      620, 777, 950})
    powers.push_back({k, k, k});
  judge_all(powers, 2000,
            [](const corpus::BadMesh&, const verify::Report& before, const verify::Report& after) {
              return found(before) == found(after) ? "" : found(after) + ", expected " + found(before);
            });
}

// Along one axis the shapes change, and so what is near. What is exact stays.
TEST(Scales, WhatIsExactIsTheSameWhenOneOrTwoAxesAreScaled) {
  std::vector<Powers> powers;
  for (const int k : {-900, -500, -260, -90, -40, -17, 17, 40, 90, 260, 500, 900})
    for (int axis = 0; axis < 3; ++axis) {
      Powers one{}, two{k, k, k};
      one[axis] = k, two[axis] = 0;
      powers.push_back(one);
      powers.push_back(two);
    }
  judge_all(powers, 5000,
            [](const corpus::BadMesh& bad, const verify::Report& before,
               const verify::Report& after) -> std::string {
              if (before.certificate != after.certificate)
                return found(after) + ", expected " + found(before);
              if (!bad.kind && !sound(after)) return "a sound mesh: " + found(after);
              for (int c = 0; c < verify::check_count; ++c)
                if (const auto check = static_cast<verify::Check>(c);
                    info(check).all_exact && !info(check).needs_surface &&
                    holds(before, check) != holds(after, check))
                  return found(after) + ", expected " + found(before);
              return "";
            });
}

TEST(Scales, TheCertificateDoesNotDependOnTheOtherChecks) {
  std::vector<std::string> others;
  for (int c = 0; c < verify::check_count; ++c)
    if (const auto& row = verify::info(static_cast<verify::Check>(c)); !row.certificate && !row.needs_surface)
      others.emplace_back(row.id);
  std::mutex saying;
  std::string said;
  tbb::parallel_for(std::size_t{0}, zoo().size(), [&](std::size_t i) {
    const corpus::BadMesh& bad = zoo()[i];
    corpus::Random random(i);
    for (const int k : {0, -520, 500}) {
      const auto mesh = scaled(bad.planted.mesh, {k, k, k});
      if (!mesh) continue;
      // None of the others, each alone left out, and some at random.
      for (std::size_t n = 0; n < others.size() + 5; ++n) {
        verify::Options options{.quality = false};
        for (std::size_t o = 0; o < others.size(); ++o)
          if (n == others.size() || n == o || (n > others.size() && random.below(2) == 1))
            options.skip.push_back(others[o]);
        const verify::Report report = verify::verify(*mesh, options);
        if (report.certificate == bad.planted.truth.valid()) continue;
        const std::lock_guard lock(saying);
        said += bad.name + " times 2^" + std::to_string(k) + ", set " + std::to_string(n) + ": " +
                found(report) + "\n";
      }
    }
  });
  EXPECT_EQ(said, "");
}

}  // namespace
}  // namespace tetproof::test
