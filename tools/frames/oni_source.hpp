// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "services/depth_capture/oni_file.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

/// Frames of an OpenNI2 recording, as fallen-depth-capture sends them; it knows no poses.
class OniSource : public FrameSource {
 public:
  /// @param T_robot_camera  Mounting, which the file does not know.
  /// @throws std::runtime_error if the file is not whole.
  OniSource(const std::filesystem::path& file, const std::string& camera,
            const std::optional<Eigen::Isometry3d>& T_robot_camera);

  std::optional<Frame> Next() override;
  std::optional<GroundTruth> Truth(const Frame&) override { return std::nullopt; }
  const std::string& camera() const override { return camera_; }
  double share_done() const override;
  Damage damage() const override { return damage_; }

 private:
  OniFile file_;
  std::string camera_;
  Damage damage_;
  bool is_at_end_ = false;
};

}  // namespace fallen
