// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/column_grid.hpp"

#include <gtest/gtest.h>

namespace fallen::sim {
namespace {

// A table top of 1 x 0.6 m at 0.7 m height, 4 cm thick, in the middle of a room of 4 x 3 m.
ColumnGrid TableTop() {
  ColumnGrid grid({4, 3});
  TriangleMesh top = MakeBox({1, 0.6, 0.04});
  top.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.72f)));
  grid.Add(top);
  return grid;
}

TEST(ColumnGrid, UnderATableThereIsRoom) {
  const ColumnGrid grid = TableTop();
  EXPECT_FALSE(grid.Taken({0.2, 0.1, 0.3}));
  EXPECT_TRUE(grid.Covered({0.2, 0.1, 0.3}));
  EXPECT_TRUE(grid.Taken({0.2, 0.1, 0.72}));
  EXPECT_FALSE(grid.Taken({0.2, 0.1, 0.8}));
  EXPECT_FALSE(grid.Covered({0.2, 0.1, 0.8}));
  EXPECT_FALSE(grid.Covered({0.8, 0.1, 0.3}));
}

TEST(ColumnGrid, OutsideTheRoomAllIsTaken) {
  const ColumnGrid grid = TableTop();
  EXPECT_TRUE(grid.Taken({2.1, 0, 0.3}));
  EXPECT_TRUE(grid.Blocked(0, -1.6, 0, 1));
  EXPECT_FALSE(grid.Taken({1.9, -1.4, 0.3}));
}

TEST(ColumnGrid, BlocksWhatIsAsHighAsTheObstacle) {
  const ColumnGrid grid = TableTop();
  EXPECT_TRUE(grid.Blocked(0.1, 0.1, 0.04, 1.3));
  EXPECT_FALSE(grid.Blocked(0.1, 0.1, 0.04, 0.6));
}

TEST(ColumnGrid, LeavesNoHoleInALargeTriangle) {
  const ColumnGrid grid = TableTop();
  for (double x = -0.49; x < 0.49; x += 0.007)
    for (double y = -0.29; y < 0.29; y += 0.007)
      EXPECT_TRUE(grid.Taken({x, y, 0.72})) << x << " " << y;
}

}  // namespace
}  // namespace fallen::sim
