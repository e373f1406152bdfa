// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/distractors.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/dogs.hpp"
#include "tools/simulate/persons.hpp"
#include "tools/simulate/resting_person.hpp"

namespace fallen::sim {
namespace {

using DistractorsTest = WithAssets;

TEST_F(DistractorsTest, EveryKindRestsOnTheFloorAroundTheOriginAndIsNoLargerThanAPerson) {
  for (const std::string& kind : DistractorKinds()) {
    if (kind == kResting || kind == kSeated) continue;  // these need a room
    Random random(5);
    const Distractor distractor =
        MakeDistractor(kind, assets().furniture, assets().humans, FurniturePool::kAll, random);
    ASSERT_FALSE(distractor.mesh.empty()) << kind;
    EXPECT_EQ(distractor.category, kind);
    EXPECT_EQ(distractor.mesh.albedo.size(), distractor.mesh.triangles.size()) << kind;
    const Eigen::AlignedBox3f bounds = distractor.mesh.Bounds();
    EXPECT_NEAR(bounds.min().z(), 0, 0.002) << kind;
    EXPECT_NEAR(bounds.center().head<2>().norm(), 0, 0.01) << kind;
    EXPECT_LT(bounds.sizes().maxCoeff(), 2.6) << kind;
    EXPECT_GT(bounds.sizes().maxCoeff(), 0.15) << kind;
  }
}

TEST_F(DistractorsTest, WhoStoopsStandsOnFeetOrKneesAndStaysBelowStandingHeight) {
  const BodyShape shape = DrawBodyShape(3);
  for (const Stoop stoop : {Stoop::kKneeling, Stoop::kBending, Stoop::kCrouching}) {
    Random random(2);
    const Eigen::AlignedBox3f bounds =
        MakeStoopingPerson(assets().humans, shape, stoop, random).Bounds();
    EXPECT_NEAR(bounds.min().z(), 0, 0.03);
    EXPECT_GT(bounds.max().z(), 0.6);
    EXPECT_LT(bounds.max().z(), 0.9 * shape.height_m);
  }
}

TEST(Dogs, StandTallerThanTheySitAndLie) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random lying(seed), standing(seed);  // the same scale
    const double low = MakeLyingDog(lying).Bounds().max().z();
    const double high = MakeStandingDog(standing).Bounds().max().z();
    EXPECT_LT(low, 0.75);
    EXPECT_GT(high, low - 0.1);
    EXPECT_LT(high, 1.25);
  }
}

TEST_F(DistractorsTest, AnUnknownKindIsNamed) {
  Random random(1);
  EXPECT_THROW(
      MakeDistractor("unicorn", assets().furniture, assets().humans, FurniturePool::kAll, random),
      std::invalid_argument);
}

}  // namespace
}  // namespace fallen::sim
