// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

/// Bounds of what a message may say: far beyond what makes sense, near enough that no arithmetic on
/// accepted values overflows. Internal to this folder.
namespace fallen::limits {

/// Times [us] and sequence numbers: exact in a double, and their differences in an int64 (year
/// 2255).
inline constexpr std::int64_t kMaxTime = std::int64_t{1} << 53;
inline constexpr std::size_t kMaxNameBytes = 63;     ///< a channel name's limit
inline constexpr std::size_t kMaxTextBytes = 65536;  ///< descriptions
inline constexpr int kMaxImageSide = 8192;           ///< [px], CameraIntrinsics
/// Coordinates [m]: at the smallest cell size still whole numbers of cells in an int32.
inline constexpr double kMaxCoordinate_m = 1e6;
/// Cells of a local map lie this near the camera along each axis [m]: twice NdtConfig's largest
/// extent.
inline constexpr double kMaxLocalDistance_m = 2000;
/// A camera is mounted this near the origin of its robot along each axis [m].
inline constexpr double kMaxMounting_m = 100;
inline constexpr double kMinCellSize_m = 1e-3;
inline constexpr double kMaxCellSize_m = 10;
inline constexpr std::int64_t kMaxObjects = 4096;  ///< labelled objects, hypotheses, in one frame
inline constexpr std::int64_t kMaxLabel = 255;     ///< label images have 8 bits

}  // namespace fallen::limits
