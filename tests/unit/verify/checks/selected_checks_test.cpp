// SPDX-License-Identifier: GPL-3.0-or-later
// Options that leave out checks: without all of its checks there is no certificate.
#include <gmock/gmock.h>

#include <optional>
#include <stdexcept>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;

TEST(PlantedDefects, SkippedChecksLeaveTheCertificateOpen) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  EXPECT_EQ(verify::verify(mesh, {.skip = {"overlap"}}).certificate, std::nullopt);
  EXPECT_EQ(verify::verify(mesh, {.skip = {"unused-point"}}).certificate, true);
  const Report some = verify::verify(mesh, {.check = {"inverted", "flat"}});
  EXPECT_EQ(some.certificate, std::nullopt);
  EXPECT_EQ(some[Check::inverted].verdict, Verdict::pass);
  EXPECT_EQ(some[Check::duplicate_tet].verdict, Verdict::skipped);
  TetMesh bad = mesh;
  std::swap(bad.tets[0][0], bad.tets[0][1]);
  EXPECT_EQ(verify::verify(bad, {.skip = {"overlap"}}).certificate, false) << "one failure suffices";
  EXPECT_THROW(verify::verify(mesh, {.check = {"no-such-check"}}), std::runtime_error);
}

}  // namespace
}  // namespace tetproof::test
