// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/furniture_catalogue.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"

namespace fallen::sim {
namespace {

using FurnitureTest = WithAssets;

// But for beds: of seven, the hash puts none into the test pool.
TEST_F(FurnitureTest, EveryRoleHasModelsInEveryPool) {
  for (const FurnitureRole role :
       {FurnitureRole::kSofa, FurnitureRole::kArmchair, FurnitureRole::kChair,
        FurnitureRole::kTable, FurnitureRole::kDesk, FurnitureRole::kCabinet, FurnitureRole::kPlant,
        FurnitureRole::kSmall, FurnitureRole::kDog, FurnitureRole::kCat})
    for (const FurniturePool pool :
         {FurniturePool::kTrain, FurniturePool::kValidation, FurniturePool::kTest})
      EXPECT_FALSE(assets().furniture.Select(role, pool).empty())
          << "role " << static_cast<int>(role) << " pool " << EnumName(pool);
}

TEST_F(FurnitureTest, PoolsDoNotShareModels) {
  for (const FurnitureModel* model :
       assets().furniture.Select(FurnitureRole::kChair, FurniturePool::kTrain))
    EXPECT_EQ(PoolOf(model->name), FurniturePool::kTrain);
}

TEST_F(FurnitureTest, MeshesHaveTheCataloguesSizeAndStandOnTheFloor) {
  for (const char* name :
       {"KatorLegaz/futon-couch", "BlendSwap-CC-BY/bulldog", "BlendSwap-CC-0/oakTable"}) {
    const auto found =
        std::find_if(assets().furniture.models.begin(), assets().furniture.models.end(),
                     [&](const FurnitureModel& model) { return model.name == name; });
    ASSERT_NE(found, assets().furniture.models.end()) << name;
    const TriangleMesh mesh = LoadFurnitureMesh(*found);
    const Eigen::AlignedBox3f bounds = mesh.Bounds();
    EXPECT_TRUE(bounds.sizes().cast<double>().isApprox(found->size, 1e-4)) << name;
    EXPECT_NEAR(bounds.min().z(), 0, 1e-4) << name;
    EXPECT_EQ(mesh.albedo.size(), mesh.triangles.size());
  }
}

TEST_F(FurnitureTest, ASofasBackIsBehind) {
  // The back is the high half: it must be at +y, where walls are.
  for (const FurnitureModel* model :
       assets().furniture.Select(FurnitureRole::kSofa, FurniturePool::kAll)) {
    const TriangleMesh mesh = LoadFurnitureMesh(*model);
    double behind = 0, in_front = 0;
    for (const Eigen::Vector3f& vertex : mesh.vertices) {
      double& highest = vertex.y() > 0 ? behind : in_front;
      if (std::abs(vertex.x()) < 0.2 * model->size.x())
        highest = std::max<double>(highest, vertex.z());
    }
    EXPECT_GT(behind, in_front) << model->name;
  }
}

TEST(FurnitureCatalogue, WhatHasNoPlaceInAHomeHasNoRole) {
  EXPECT_FALSE(RoleOf("KatorLegaz/VW-new-beetle"));
  EXPECT_TRUE(RoleOf("KatorLegaz/futon-couch"));
}

TEST(FurnitureCatalogue, PoolsAreFixedForEver) {
  // Recordings made with one version must stay comparable with those of the next.
  EXPECT_EQ(PoolOf("KatorLegaz/futon-couch"), PoolOf("KatorLegaz/futon-couch"));
  int train = 0;
  for (int i = 0; i < 1000; ++i)
    train += PoolOf("model-" + std::to_string(i)) == FurniturePool::kTrain;
  EXPECT_NEAR(train, 600, 50);
}

TEST(FurnitureCatalogue, MissingAssetsAreNamed) {
  EXPECT_THROW(LoadFurnitureCatalogue("/nowhere"), std::runtime_error);
  EXPECT_THROW(LoadHumanModel("/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace fallen::sim
