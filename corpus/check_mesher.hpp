// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzz campaign in a user's own test suite, against his C++ function. For GoogleTest, about ten lines:
//
//   class MyMesher : public testing::TestWithParam<int> {};
//   TEST_P(MyMesher, MeshesHardSurfaces) {
//     const auto checked =
//         tetproof::corpus::check_mesher(my_mesher, {.cases = 2000, .slice = GetParam(), .slices = 8});
//     EXPECT_TRUE(checked.good) << checked.message;
//   }
//   INSTANTIATE_TEST_SUITE_P(Slices, MyMesher, testing::Range(0, 8));
#pragma once

#include <cstdint>
#include <string>

#include "corpus/fuzz_campaign.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/judgement.hpp"
#include "corpus/meshing/mesher.hpp"

namespace tetproof::corpus {

struct CheckOptions {
  std::uint64_t seed = 1, cases = 200;
  /// Only the cases with index % slices == slice. A test suite that is cut into shards runs whole tests, so a
  /// campaign is spread over them as several tests, one for each slice.
  int slice = 0, slices = 1;
  FuzzOptions surfaces{};
  JudgeOptions judge{};
  int threads = 0;       ///< calls of the function at once, so it must bear that; 0: one for each core
  double shrink_s = 10;  ///< wall time for each group of failures [s]
  /// Where the findings go, each a folder with surface.off; slices have folders of their own in it. Results
  /// of an earlier run are replaced: the function may be another one by now.
  std::string folder = "tetproof-fuzz";
  std::string name = "mesher";  ///< what the message calls the function
  int most_told = 3;            ///< groups whose findings the message has; the others are named
};

/// What a test suite asserts and prints.
struct MesherCheck {
  bool good = false;
  std::string message;  ///< several lines
};

/// Runs the campaign: the function meshes random closed surfaces that are hard and proved to be valid, each
/// mesh is judged, the failures are grouped, and each group's smallest surface is made smaller. Good: there
/// is no finding, everything was judged, and at least one mesh is sound, so that a function that throws on
/// all of them is not good. An exception is a refusal, and no finding.
///
/// The message has the counts and, of each group, the file with its smallest surface and the first findings
/// of the judge's report. If the function crashes, and this process with it, the surface that it was given
/// remains as running-*.off in the folder. InputError if the folder cannot be written or the slice is none.
MesherCheck check_mesher(const MeshFunction& function, const CheckOptions& options = {});

/// One surface, as a property of RapidCheck needs it: good unless there is a finding, or the mesh was not
/// judged. If not good, the surface is written to `file`, if that is not empty; the last one that RapidCheck
/// sees fail is the smallest.
MesherCheck check_mesher_on(const TriangleSurface& surface, const MeshFunction& function,
                            const std::string& file = "", const JudgeOptions& judge = {});

}  // namespace tetproof::corpus
