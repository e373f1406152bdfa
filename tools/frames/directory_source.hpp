// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "fallen/detection/pose_synchronizer.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/import/tum_directory.hpp"

namespace fallen {

/// Frames of an import directory, bit for bit those of the log that fallen-import makes of it. An
/// image that cannot be read counts as damage.
class DirectorySource : public FrameSource {
 public:
  /// @throws InputError as ReadTumDirectory.
  DirectorySource(const std::filesystem::path& directory, std::string camera);

  std::optional<Frame> Next() override;
  std::optional<GroundTruth> Truth(const Frame& frame) override {
    return directory_.TruthOf(static_cast<std::size_t>(frame.seq));  // counts the images
  }
  const std::string& camera() const override { return camera_; }
  double share_done() const override;
  Damage damage() const override { return damage_; }

 private:
  void Take(const TumMessages& messages);

  TumDirectory directory_;
  std::string camera_;
  PoseSynchronizer synchronizer_;
  std::deque<Frame> ready_;
  std::size_t next_ = 0;
  Damage damage_;
};

}  // namespace fallen
