// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"

/// Cell normals and IRON descriptors (the paper, Sec. III-C).
///
/// [Schmiedel15] Schmiedel, Einhorn, Gross: IRON: A fast interest point descriptor for robust
///               NDT-map matching and its application to robot localization. IROS 2015.
namespace fallen {

struct IronConfig {
  double radius_m = 0.5;          ///< neighbourhood, the paper Sec. III-C
  int distance_bins = 3;          ///< rows, of the squared distance
  int angle_bins = 8;             ///< columns, 0 to 90 degrees (see NormalSigns)
  double max_ball_ratio = 0.9;    ///< lambda0/lambda1 above it: a ball, no normal
  double min_needle_ratio = 0.1;  ///< lambda1/lambda2 below it: a needle, no normal
  int min_neighbors = 5;          ///< fewer: no descriptor

  /// Values in a descriptor: two histograms of rows x columns.
  int dimension() const { return 2 * distance_bins * angle_bins; }
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("radius_m", radius_m);
    visit("distance_bins", distance_bins);
    visit("angle_bins", angle_bins);
    visit("max_ball_ratio", max_ball_ratio);
    visit("min_needle_ratio", min_needle_ratio);
    visit("min_neighbors", min_neighbors);
  }
  bool operator==(const IronConfig&) const = default;
};

/// Surface normal of a cell, from the eigenvectors of its covariance.
struct CellNormal {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();       ///< unit; its sign is arbitrary
  Eigen::Vector3f eigenvalues = Eigen::Vector3f::Zero();  ///< ascending [m^2]
  bool usable = false;  ///< false for balls and needles: no descriptor, nobody's neighbour
};

/// What the signs of normals say, and so which angles a descriptor tells apart.
enum class NormalSigns : std::int32_t {
  kArbitrary = 0,  ///< nothing: angles are folded to 90 degrees
  kOriented = 1,   ///< out of the surface, see OrientNormals: angles up to 180 degrees
};

/// One normal a cell. Deterministic, and the same bits at every SimdLevel.
/// @throws std::invalid_argument if `config` is out of range.
std::vector<CellNormal> ComputeNormals(std::span<const NdtCell> cells,
                                       const IronConfig& config = {});
/// Likewise, into memory that is there.
void ComputeNormals(std::span<const NdtCell> cells, const IronConfig& config,
                    std::vector<CellNormal>& normals);
/// @param normals  As many as there are cells. @throws std::invalid_argument if they are not.
void ComputeNormals(std::span<const NdtCell> cells, const IronConfig& config,
                    std::span<CellNormal> normals);

/// Turns each normal, where it is not so, to the side of its cell on which `eye` is: out of the
/// surface, if it was seen from there. What sign it had makes no difference, but for normals at
/// right angles to the line of sight, which stay.
/// @param eye  Where the sensor is, frame of the cells [m].
/// @throws std::invalid_argument if sizes disagree.
void OrientNormals(std::span<const NdtCell> cells, const Eigen::Vector3f& eye,
                   std::span<CellNormal> normals);

/// Descriptors of all cells, one row each.
struct IronDescriptors {
  using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// cells x dimension: histogram 1 (normal against normal) row-major, then histogram 2 (normal
  /// against connecting line). Each sums to 1 in a valid row; invalid rows are zero. May have more
  /// rows than there are cells; those mean nothing.
  Matrix values;
  std::vector<std::int32_t> neighbor_counts;  ///< 0: filtered out or too few neighbours

  bool valid(std::size_t i) const { return neighbor_counts[i] > 0; }
};

/// Gives `matrix` at least `rows` rows, and some to spare where it must grow: frame after frame it
/// stays where it is. What it held is lost then.
template <class Matrix>
void GrowRows(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  if (matrix.rows() < rows || matrix.cols() != columns) matrix.resize(rows + rows / 4, columns);
}

/// Computes the descriptor of each cell for which `wanted` is non-zero (all, if it is empty).
/// Every cell of `cells` counts as neighbour, wanted or not.
///
/// @param wanted  Empty, or one flag a cell.
/// @param signs   With NormalSigns::kOriented the columns are of 0 to 180 degrees, and as many; the
///                line of histogram 2 goes from the neighbour to the cell, so that neighbours below
///                the surface come first.
/// @throws std::invalid_argument if sizes disagree or `config` is out of range.
/// Deterministic; a cell's descriptor does not depend on `wanted`. O(pairs within the radius).
IronDescriptors ComputeIronDescriptors(std::span<const NdtCell> cells,
                                       std::span<const CellNormal> normals,
                                       std::span<const std::uint8_t> wanted = {},
                                       const IronConfig& config = {},
                                       NormalSigns signs = NormalSigns::kArbitrary);

}  // namespace fallen
