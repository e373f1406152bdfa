// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "fallen/geometry/depth_image.hpp"

namespace fallen {

/// What a camera could see in one image, coarsely: how far its rays went.
///
/// "Nobody was found there" says something only of places that were in view and not hidden. This is
/// the little of a depth image that tells, 32 blocks wide: small enough to go with each result.
struct CameraView {
  CameraIntrinsics intrinsics;  ///< pinhole model of the blocks; all 0: not known
  /// Median depth z of each block [mm], row-major; 0 where most of the block was not measured.
  std::vector<std::uint16_t> depth_mm;

  bool is_known() const { return !depth_mm.empty(); }

  /// Depth measured in the direction of `p_camera` [m]. Nothing behind the camera, outside the
  /// image, or where nothing was measured.
  std::optional<double> DepthTowards(const Eigen::Vector3d& p_camera) const;

  bool operator==(const CameraView&) const = default;
};

/// Depths beyond it are kept as it [mm]: what an int16 on the wire holds.
inline constexpr int kMaxViewDepth_mm = 32767;

/// Shrinks an image to at most 32 blocks a row; blocks are square.
/// @throws std::invalid_argument if the image is malformed.
/// Deterministic. Looks at 25 pixels a block.
CameraView MakeCameraView(const DepthImage& image);
/// Likewise, into memory that is there.
void MakeCameraView(const DepthImage& image, CameraView& view);

}  // namespace fallen
