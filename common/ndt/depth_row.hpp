// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace fallen {

/// What places the pixels of a depth image in the voxel grid.
///
/// Coordinates are those of the map, but counted from the corner of the voxel that the camera is
/// in, so that float suffices. Plain numbers, so that the kernel below may be compiled for wider
/// processors than its callers.
struct RowGeometry {
  float depth_unit_m;
  std::uint16_t min_depth, max_depth;     ///< units; pixels outside are left out
  float camera_x, camera_y, camera_z;     ///< [m]
  float up_x, up_y, up_z, up_offset;      ///< height over the floor = up . p + up_offset [m]
  float clearance_m, clearance_per_sq_m;  ///< lower than clearance + per_sq * depth^2: floor
  float max_height_m;
  float sq_extent;        ///< squared distance from the camera beyond which points are left out
  float vertical_weight;  ///< 0: that distance is horizontal, along x and y; 1: in space
  float cell_size_m, inverse_cell_size;
};

/// Directions of the pixels' rays, per metre of depth: column part plus row part.
struct RowDirections {
  const float* x;  ///< one a column
  const float* y;
  const float* z;
  float row_x, row_y, row_z;
};

/// Points of one image row: voxel, counted from the camera's, and offset from the voxel's centre.
///
/// Memory for the next multiple of kRowPadding points, and of the voxels for one before the first.
struct RowPoints {
  std::int32_t* voxel_x;  ///< kNoPoint where the pixel gives no point
  std::int32_t* voxel_y;
  std::int32_t* voxel_z;
  float* offset;  ///< x, y, z [m] and 1
};
inline constexpr std::int32_t kNoPoint = INT32_MIN;

/// Sums over the points of a run, by their offsets from the voxel's centre: x y z count, xx xy xz
/// x, yx yy yz y, zx zy zz z. Float suffices: 5 000 points of one image in a voxel leave variances
/// good to 1e-9 m^2.
struct alignas(64) RunSums : std::array<float, 16> {};

/// Runs of neighbouring pixels of a row whose points lie in one voxel, in the row's order.
///
/// Memory for the next multiple of kRowPadding pixels of a row, and one more.
struct RowRuns {
  std::int32_t* first;  ///< column of a run's first pixel
  RunSums* sums;
};

/// Pixels are placed so many at a time.
inline constexpr int kRowPadding = 16;

/// Places the `count` pixels of a row and sums them up in runs.
/// @param points  Is written: voxels where a run begins; the rest is scratch memory.
/// @return Number of runs.
/// The same bits on every processor, but for the sign of a zero.
int SumRowRuns(const std::uint16_t* depth, int count, const RowDirections& directions,
               const RowGeometry& geometry, const RowPoints& points, const RowRuns& runs);

/// The variant for the widest registers.
int SumRowRunsAvx512(const std::uint16_t* depth, int count, const RowDirections& directions,
                     const RowGeometry& geometry, const RowPoints& points, const RowRuns& runs);

}  // namespace fallen
