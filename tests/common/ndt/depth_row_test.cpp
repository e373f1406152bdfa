// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/depth_row.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

constexpr int kMostPixels = 203;
constexpr double kFocalLength = 525;

// A row that looks along x, level, 1 m above a floor; everything up to 10 m is taken.
RowGeometry Geometry() {
  RowGeometry g = {};
  g.depth_unit_m = 0.001F;
  g.min_depth = 400;
  g.max_depth = 5000;
  g.camera_x = 0.0107F;  // so that no pixel lies on the side of a voxel
  g.camera_y = 0.0203F;
  g.camera_z = 0.03005F;
  g.up_z = 1;
  g.up_offset = 0.97F;
  g.max_height_m = 10;
  g.sq_extent = 100;
  g.cell_size_m = 0.05F;
  g.inverse_cell_size = 20;
  return g;
}

struct Row {
  std::vector<std::uint16_t> depth;
  std::vector<float> direction_y = std::vector<float>(kMostPixels + kRowPadding);
  std::vector<float> zeros = std::vector<float>(kMostPixels + kRowPadding);

  // Depth in steps and with gaps, as of a sensor, that jumps to and fro between voxels.
  Row(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0, 20);
    for (int u = 0; u < count; ++u) {
      direction_y[u] = static_cast<float>((u - 100) / kFocalLength);
      const bool is_gap = u % 37 > 30 || (u > 90 && u < 120);
      const float depth_mm = 1500 + 3 * static_cast<float>(u) + noise(random);
      depth.push_back(is_gap ? 0 : static_cast<std::uint16_t>(depth_mm));
    }
  }
  RowDirections directions() const {
    return {zeros.data(), direction_y.data(), zeros.data(), 1, 0, 0.1F};
  }
};

struct FoundRun {
  std::array<std::int32_t, 3> voxel;
  std::array<float, 16> sums;
  bool operator==(const FoundRun&) const = default;
};

std::vector<FoundRun> RunsOf(const Row& row) {
  constexpr int kRoom = kMostPixels + kRowPadding + 1;
  std::vector<std::int32_t> x(kRoom), y(kRoom), z(kRoom);
  std::vector<float> offsets(4 * kRoom);
  std::vector<std::int32_t> first(kRoom + kRowPadding);
  std::vector<RunSums> sums(kRoom);
  const int count = SumRowRuns(
      row.depth.data(), static_cast<int>(row.depth.size()), row.directions(), Geometry(),
      {x.data() + 1, y.data() + 1, z.data() + 1, offsets.data()}, {first.data(), sums.data()});
  std::vector<FoundRun> found;
  for (int r = 0; r < count; ++r) {
    const int at = 1 + first[r];
    found.push_back({{x[at], y[at], z[at]}, sums[r]});
  }
  return found;
}

// One pixel after the other, in double precision.
std::vector<FoundRun> PlainRunsOf(const Row& row) {
  const RowGeometry g = Geometry();
  std::vector<FoundRun> runs;
  bool goes_on = false;
  for (std::size_t u = 0; u < row.depth.size(); ++u) {
    if (row.depth[u] < g.min_depth || row.depth[u] > g.max_depth) {
      goes_on = false;
      continue;
    }
    const double depth_m = 0.001 * row.depth[u];
    const std::array<double, 3> p = {depth_m + g.camera_x,
                                     depth_m * row.direction_y[u] + g.camera_y,
                                     0.1 * depth_m + g.camera_z};
    std::array<std::int32_t, 3> voxel;
    std::array<double, 3> o;
    for (int k = 0; k < 3; ++k) {
      voxel[k] = static_cast<std::int32_t>(std::floor(p[k] / 0.05));
      o[k] = p[k] - (voxel[k] + 0.5) * 0.05;
    }
    if (!goes_on || runs.back().voxel != voxel) runs.push_back({voxel, {}});
    goes_on = true;
    const std::array<double, 4> point = {o[0], o[1], o[2], 1}, factors = {1, o[0], o[1], o[2]};
    for (std::size_t k = 0; k < runs.back().sums.size(); ++k)
      runs.back().sums[k] += static_cast<float>(point[k % 4] * factors[k / 4]);
  }
  return runs;
}

TEST(SumRowRuns, GivesThePlainSumsAndTheSameBitsAtEveryLevel) {
  for (const int count : {0, 1, 7, 8, 9, 15, 16, 17, 32, kMostPixels}) {
    const Row row(count, 1);
    const std::vector<FoundRun> expected = PlainRunsOf(row);
    if (count == kMostPixels) {
      ASSERT_GT(expected.size(), 40u) << "runs are to be short";
    }
    std::vector<FoundRun> portable;
    test::AtEverySimdLevel([&](SimdLevel level) {
      const std::vector<FoundRun> runs = RunsOf(row);
      if (level == SimdLevel::kPortable) portable = runs;
      EXPECT_EQ(runs, portable);
      ASSERT_EQ(runs.size(), expected.size());
      for (std::size_t r = 0; r < runs.size(); ++r) {
        EXPECT_EQ(runs[r].voxel, expected[r].voxel);
        EXPECT_EQ(runs[r].sums[3], expected[r].sums[3]);
        // Places are good to a step of float at 5 m, 0.5 um; a run has up to a few dozen points.
        for (std::size_t k = 0; k < expected[r].sums.size(); ++k)
          EXPECT_NEAR(runs[r].sums[k], expected[r].sums[k], 1e-5);
      }
    });
  }
}

}  // namespace
}  // namespace fallen
