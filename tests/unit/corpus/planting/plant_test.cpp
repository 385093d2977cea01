// SPDX-License-Identifier: GPL-3.0-or-later
// The planting tool: the same seed plants the same defect, every promise is true, and every kind of defect
// finds a place.
#include "corpus/plant.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "corpus/block_mesh.hpp"
#include "io/error.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using namespace corpus;

TEST(Plant, KindsAreNamedOnceAndCallChecksByTheirIds) {
  EXPECT_GE(plant_kinds().size(), 55u);
  std::set<std::string> ids;
  for (const PlantKind& kind : plant_kinds()) {
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.id;
    EXPECT_FALSE(kind.flags.empty()) << kind.id;
    for (const auto* list : {&kind.needed, &kind.also})
      for (const char* id : *list) EXPECT_NO_THROW(verify::check_of_id(id)) << kind.id;
  }
  EXPECT_THROW(plant_kind("no-such-kind"), InputError);
}

// A mesh whose midpoints are exact and one whose midpoints are not. Both have cells well inside.
std::vector<Ground> some_grounds() {
  std::vector<Ground> grounds;
  grounds.emplace_back(block_mesh({6, 4, 4}));
  grounds.emplace_back(ball_mesh(5, 0.1));
  return grounds;
}

TEST(Plant, EveryKindFindsAPlaceAndChangesSomething) {
  const auto grounds = some_grounds();
  for (const PlantKind& kind : plant_kinds()) {
    bool found = false;
    for (const Ground& ground : grounds)
      for (std::uint64_t seed = 1; seed <= 6 && !found; ++seed) {
        const auto planted = plant(kind, ground, seed);
        if (!planted) continue;
        found = true;
        EXPECT_FALSE(planted->tets.empty() && planted->vertices.empty()) << kind.id;
        EXPECT_EQ(planted->expected == Expected::defective,
                  !planted->truth.valid() || kind.has("slit") ||
                      (kind.second && plant_kind(kind.second).has("slit")))
            << kind.id;
      }
    EXPECT_TRUE(found) << kind.id;
  }
}

TEST(Plant, TheSameSeedPlantsTheSame) {
  const Ground ground(block_mesh({3, 3, 3}, 0.1));
  const auto& kind = plant_kind("hanging-off-edge");
  const auto one = plant(kind, ground, 9), again = plant(kind, ground, 9), other = plant(kind, ground, 10);
  ASSERT_TRUE(one && again && other);
  EXPECT_EQ(one->mesh.tets, again->mesh.tets);
  EXPECT_EQ(one->mesh.points, again->mesh.points);
  EXPECT_NE(one->mesh.points, other->mesh.points);
}

TEST(Plant, NothingWhereThereIsNoPlace) {
  const Ground one(TetMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}});
  for (const char* id :
       {"inverted-inside", "hanging-on-edge", "missing-inside", "crossed-diagonals", "inverted-and-hanging"})
    EXPECT_FALSE(plant(plant_kind(id), one, 1)) << id;
  EXPECT_TRUE(plant(plant_kind("inverted-at-boundary"), one, 1));
}

}  // namespace
}  // namespace tetproof::test
