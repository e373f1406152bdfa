// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fallen/iron/iron_descriptor.hpp"
#include "random_cells.hpp"

namespace fallen {
namespace {

// A flat cell whose normal is z, turned by `degrees` about y: to x at 90.
NdtCell FlatCell(const Eigen::Vector3f& mean, float degrees) {
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(degrees * std::numbers::pi_v<float> / 180, Eigen::Vector3f::UnitY())
          .toRotationMatrix();
  const Eigen::Vector3f eigenvalues(2e-4f, 1e-4f, 1e-6f);
  return MakeCell(mean, turn * eigenvalues.asDiagonal() * turn.transpose());
}

std::vector<CellNormal> Oriented(const std::vector<NdtCell>& cells, const Eigen::Vector3f& eye,
                                 std::vector<CellNormal> normals) {
  OrientNormals(cells, eye, normals);
  return normals;
}

IronDescriptors DescribeSeenFrom(const std::vector<NdtCell>& cells, const Eigen::Vector3f& eye) {
  return ComputeIronDescriptors(cells, Oriented(cells, eye, ComputeNormals(cells)), {}, {},
                                NormalSigns::kOriented);
}

TEST(OrientNormals, TurnsThemToTheEyeWhateverTheirSign) {
  const std::vector<NdtCell> cells = RandomCells(300, 1.5f, {3, -2, 1}, 1);
  const Eigen::Vector3f eye(3.1f, -2.2f, 1.3f);  // among them
  const std::vector<CellNormal> normals = ComputeNormals(cells);
  std::vector<CellNormal> flipped = normals;
  for (CellNormal& normal : flipped) normal.normal *= -1;
  const auto oriented = Oriented(cells, eye, normals), others = Oriented(cells, eye, flipped);
  int turned = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_GE(oriented[i].normal.dot(eye - cells[i].mean), 0) << "cell " << i;
    EXPECT_EQ(oriented[i].normal, others[i].normal) << "cell " << i;
    EXPECT_EQ(oriented[i].eigenvalues, normals[i].eigenvalues);
    turned += oriented[i].normal != normals[i].normal ? 1 : 0;
  }
  EXPECT_GT(turned, 50);
  EXPECT_LT(turned, 250);
}

TEST(OrientNormals, RefusesSizesThatDisagree) {
  const std::vector<NdtCell> cells = RandomCells(3, 1, {0, 0, 0}, 2);
  std::vector<CellNormal> normals(2);
  EXPECT_THROW(OrientNormals(cells, {0, 0, 0}, normals), std::invalid_argument);
}

// Seen from above and aside: columns of 22.5 degrees.
TEST(OrientedDescriptor, HandWorkedCase) {
  const std::vector<NdtCell> cells = {
      FlatCell({0, 0, 0}, 0),
      FlatCell({0.2f, 0, 0}, 0),      // d^2 0.04: row 0; normals 0 deg, line 90 deg
      FlatCell({0, -0.05f, 0}, 0),    // d^2 0.0025: row 0; 0 deg, 90 deg
      FlatCell({0, 0.1f, 0.09f}, 0),  // d^2 0.0181: row 0; 0 deg, above the surface: 132 deg
      FlatCell({0, 0, 0.3f}, 120),    // d^2 0.09: row 1; overhangs by 120 deg, 180 deg
      FlatCell({0, 0, -0.3f}, 60),    // d^2 0.09: row 1; 60 deg, below the surface: 0 deg
  };
  const IronDescriptors iron = DescribeSeenFrom(cells, {2, 0, 1});
  ASSERT_EQ(iron.neighbor_counts[0], 5);
  std::vector<float> expected(48, 0.0f);
  expected[0] = 3.0f / 6;
  expected[8 + 5] = 1.0f / 4;
  expected[8 + 2] = 1.0f / 4;
  expected[24 + 4] = 2.0f / 6;
  expected[24 + 5] = 1.0f / 6;
  expected[24 + 8 + 7] = 1.0f / 4;
  expected[24 + 8 + 0] = 1.0f / 4;
  for (int k = 0; k < 48; ++k) EXPECT_NEAR(iron.values(0, k), expected[k], 1e-6) << "bin " << k;
}

TEST(OrientedDescriptor, CellsOnOneSpotAreNeighboursAtNinetyDegrees) {
  const std::vector<NdtCell> cells(6, FlatCell({1, 1, 1}, 0));
  const IronDescriptors iron = DescribeSeenFrom(cells, {1, 1, 3});
  ASSERT_EQ(iron.neighbor_counts[0], 5);
  EXPECT_FLOAT_EQ(iron.values(0, 0), 1);
  EXPECT_FLOAT_EQ(iron.values(0, 24 + 4), 1);
}

// Twice as many columns over twice the angles, folded by hand, are the folded descriptor.
TEST(OrientedDescriptor, FoldedIsTheOtherDescriptor) {
  const std::vector<NdtCell> cells = RandomCells(500, 1.5f, {5, 5, 0}, 3);
  const std::vector<CellNormal> normals = ComputeNormals(cells);
  IronConfig half;
  const IronDescriptors folded = ComputeIronDescriptors(cells, normals, {}, half);
  IronConfig full = half;
  full.angle_bins = 2 * half.angle_bins;
  const IronDescriptors both =
      ComputeIronDescriptors(cells, normals, {}, full, NormalSigns::kOriented);
  ASSERT_EQ(both.neighbor_counts, folded.neighbor_counts);
  double beyond_ninety = 0;
  for (Eigen::Index i = 0; i < folded.values.rows(); ++i)
    for (int row = 0; row < 2 * half.distance_bins; ++row)
      for (int k = 0; k < half.angle_bins; ++k) {
        const Eigen::Index begin = row * full.angle_bins;
        const float low = both.values(i, begin + k);
        const float high = both.values(i, begin + full.angle_bins - 1 - k);
        EXPECT_NEAR(low + high, folded.values(i, row * half.angle_bins + k), 1e-6);
        beyond_ninety += high;
      }
  EXPECT_GT(beyond_ninety, 100);
}

// A floor that ends in a wall going down, as the edge of a table: the same cells are convex from
// outside and a corner from inside.
TEST(OrientedDescriptor, TellsAnEdgeFromACorner) {
  std::vector<NdtCell> cells;
  for (int i = 0; i < 8; ++i)
    for (int j = -4; j < 4; ++j) {
      const float along = 0.025f + 0.05f * static_cast<float>(i);
      const float aside = 0.05f * static_cast<float>(j);
      cells.push_back(FlatCell({-along, aside, 0}, 0));
      cells.push_back(FlatCell({0, aside, -along}, 90));
    }
  const IronDescriptors edge = DescribeSeenFrom(cells, {2, 0.01f, 2});
  const IronDescriptors corner = DescribeSeenFrom(cells, {-2, 0.01f, -2});
  const IronDescriptors neither = ComputeIronDescriptors(cells, ComputeNormals(cells));
  for (Eigen::Index i = 0; i < edge.values.rows(); ++i) {
    float edge_below = 0, edge_above = 0, corner_below = 0, corner_above = 0, folded_aside = 0;
    for (int row = 3; row < 6; ++row) {  // of histogram 2
      edge_below += edge.values.row(i).segment(row * 8, 4).sum();
      edge_above += edge.values.row(i).segment(row * 8 + 5, 3).sum();
      corner_below += corner.values.row(i).segment(row * 8, 4).sum();
      corner_above += corner.values.row(i).segment(row * 8 + 5, 3).sum();
      folded_aside += neither.values.row(i).segment(row * 8, 6).sum();
    }
    EXPECT_GT(folded_aside, 0.02) << "cell " << i;
    EXPECT_GE(edge_below, folded_aside) << "cell " << i;
    EXPECT_EQ(edge_above, 0) << "cell " << i;
    EXPECT_EQ(corner_below, 0) << "cell " << i;
    EXPECT_GT(corner_above, 0.02) << "cell " << i;
  }
}

}  // namespace
}  // namespace fallen
