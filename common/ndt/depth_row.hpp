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

/// Sums over points, by their offsets from the voxel's centre: x y z count, xx xy xz yy, yz zz and
/// two without meaning. Float suffices: 5 000 points of one image in a voxel leave variances good
/// to 1e-9 m^2.
using RunSums = std::array<float, 12>;

/// Neighbouring pixels of a row whose points lie in one voxel.
struct alignas(64) PointRun {
  RunSums sums;
  std::int32_t last;  ///< column of the last pixel
};

/// Pixels are placed so many at a time.
inline constexpr int kRowPadding = 8;

/// Places the `count` pixels of a row and sums them up in runs.
/// @param points  Is written: the voxel of a run is that of its last pixel.
/// @param runs    Room for one a pixel, and one more.
/// @return Number of runs.
/// The same bits on every processor.
int SumRowRuns(const std::uint16_t* depth, int count, const RowDirections& directions,
               const RowGeometry& geometry, const RowPoints& points, PointRun* runs);

}  // namespace fallen
