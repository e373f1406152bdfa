// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Points of one image row: voxel, counted from the camera's, and offset from the voxel's centre
/// [m].
struct RowPoints {
  std::int32_t* voxel_x;  ///< kNoPoint where the pixel gives no point
  std::int32_t* voxel_y;
  std::int32_t* voxel_z;
  float* x;
  float* y;
  float* z;
};
inline constexpr std::int32_t kNoPoint = INT32_MIN;

/// Pixels are placed so many at a time: arrays of directions and points need room for the next
/// multiple of it.
inline constexpr int kRowPadding = 8;

/// Places the `count` pixels of a row; what the points hold beyond is no point. The same bits on
/// every processor.
void PlaceRow(const std::uint16_t* depth, int count, const RowDirections& directions,
              const RowGeometry& geometry, const RowPoints& points);

}  // namespace fallen
