// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/cell_labels.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

// A wall 1 m ahead; the left half of the image is labelled as a person.
struct LabelledWall {
  DepthImage image{{64, 48, 60, 60, 31.5, 23.5}, 0.001, std::vector<std::uint16_t>(64 * 48, 1010)};
  std::vector<std::uint8_t> labels = std::vector<std::uint8_t>(64 * 48, 0);
  LabelledWall() {
    for (int i = 0; i < 64 * 48; ++i) labels[i] = i % 64 < 32 ? 7 : 3;
  }
};

NdtMap MapWithCellsAt(std::initializer_list<float> xs) {
  NdtMap map;
  for (const float x : xs) {
    NdtCell cell;
    cell.mean = {x, 0.02f, 1.01f};
    map.cells.push_back(cell);
  }
  return map;
}

TEST(CellLabels, FollowTheLabelImage) {
  const LabelledWall wall;
  CellLabeller labeller;
  labeller.Add(wall.image, wall.labels, 7, Eigen::Isometry3d::Identity());
  EXPECT_EQ(labeller.Label(MapWithCellsAt({-0.2f, 0.2f, 3.0f})),
            (std::vector<CellLabel>{CellLabel::kPerson, CellLabel::kOther, CellLabel::kUnknown}));
}

TEST(CellLabels, WithoutAPersonNothingIsOne) {
  const LabelledWall wall;
  CellLabeller labeller;
  labeller.Add(wall.image, wall.labels, 0, Eigen::Isometry3d::Identity());
  EXPECT_EQ(labeller.Label(MapWithCellsAt({-0.2f})), std::vector<CellLabel>{CellLabel::kOther});
}

TEST(CellLabels, RefuseALabelImageOfAnotherSize) {
  LabelledWall wall;
  wall.labels.pop_back();
  CellLabeller labeller;
  EXPECT_THROW(labeller.Add(wall.image, wall.labels, 7, Eigen::Isometry3d::Identity()),
               std::invalid_argument);
}

TEST(CellLabels, FollowABoxWhereThereIsNoImage) {
  const OrientedBox box{{0, 0, 1}, {1, 1, 1}, 0};
  EXPECT_EQ(LabelByBox(MapWithCellsAt({0.45f, 0.55f, 0.65f}), box),
            (std::vector<CellLabel>{CellLabel::kPerson, CellLabel::kUnknown, CellLabel::kOther}));
  EXPECT_EQ(LabelByBox(MapWithCellsAt({0.45f}), std::nullopt),
            (std::vector<CellLabel>{CellLabel::kOther}));
}

}  // namespace
}  // namespace fallen
