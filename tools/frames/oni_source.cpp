// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/frames/oni_source.hpp"

#include <stdexcept>
#include <utility>

#include "tools/frames/frame_from_message.hpp"

namespace fallen {
namespace {

/// A mounting as it arrives at the other end of a channel: rotations travel as quaternions, which
/// costs the last bits.
std::optional<Eigen::Isometry3d> AsSent(const std::optional<Eigen::Isometry3d>& T_robot_camera) {
  StampedDepthImage carrier;
  carrier.image.intrinsics = {1, 1, 1, 1, 0, 0};
  carrier.image.depth = {0};
  carrier.T_robot_camera = T_robot_camera;
  return FromMessage(ToMessage(carrier)).T_robot_camera;
}

}  // namespace

OniSource::OniSource(const std::filesystem::path& file, const std::string& camera,
                     const std::optional<Eigen::Isometry3d>& T_robot_camera)
    : file_(file, {.sensor_name = camera, .T_robot_camera = AsSent(T_robot_camera)}),
      camera_(camera) {}

std::optional<Frame> OniSource::Next() {
  if (is_at_end_) return std::nullopt;
  try {
    if (std::optional<StampedDepthImage> depth = file_.Next()) return ToFrame(std::move(*depth));
  } catch (const std::exception& error) {
    damage_.Add(error.what());  // the player does not go on behind it
  }
  is_at_end_ = true;
  return std::nullopt;
}

double OniSource::share_done() const {
  return static_cast<double>(file_.position()) / static_cast<double>(file_.frame_count());
}

}  // namespace fallen
