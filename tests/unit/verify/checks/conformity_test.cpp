// SPDX-License-Identifier: GPL-3.0-or-later
// Sound meshes, at several places and in several sizes, have no hanging nodes, crossed diagonals, cracks or
// near contacts.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "tests/unit/verify/checks/places.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

TEST(Conformity, SoundMeshesHaveNone) {
  const auto hollow = [](Cell c) { return !(c[0] == 1 && c[1] == 1); };
  for (const auto& [shift, size] : places) {
    for (const TetMesh& mesh : {lattice_mesh({4, 3, 3}, {}, {shift, shift, shift}, size),
                                lattice_mesh({3, 3, 4}, hollow, {shift, shift, shift}, size)})
      EXPECT_EQ(roots(verify::verify(mesh)), Ids{});
  }
}

}  // namespace
}  // namespace tetproof::test
