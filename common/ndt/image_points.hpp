// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/ndt/depth_row.hpp"
#include "fallen/ndt/grid_camera.hpp"

namespace fallen {

/// Brings the points of depth images into their voxels, image after image in the same memory.
class ImagePoints {
 public:
  /// Adds the points that are within range, extent and height limits to the incoming points of
  /// their voxels.
  /// @param horizontal_extent  True: `config.extent_m` is meant along x and y; false: in space.
  void AddTo(VoxelStore& store, const DepthImage& image, const GridCamera& camera,
             const HeightLimits& limits, bool horizontal_extent, const NdtConfig& config);

 private:
  // Where voxels were found a little while ago: depth that jumps to and fro between voxels, and the
  // next row, find them again without a search. An entry is a guess, to be checked.
  std::int32_t& RecentPosition(const VoxelIndex& local) {
    constexpr std::uint32_t kSlots = std::tuple_size_v<decltype(recent_)>;
    return recent_[static_cast<std::uint32_t>(local.x + 37 * local.y + 211 * local.z) % kSlots];
  }
  RowPoints Resize(std::size_t width);
  void FindColumnDirections(const CameraIntrinsics& pinhole, const Eigen::Matrix3d& R_map_camera);

  std::vector<float> column_x_, column_y_, column_z_;  // directions of the rays, column part
  std::vector<std::int32_t> voxel_x_, voxel_y_, voxel_z_;
  std::vector<float> offsets_;
  std::vector<std::int32_t> run_first_;
  std::vector<RunSums> run_sums_;
  std::array<std::int32_t, 16384> recent_{};  // as many as a room has voxels, in 64 kB
};

}  // namespace fallen
