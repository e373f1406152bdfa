// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "fallen/detection/pose_synchronizer.hpp"
#include "fallen/messages/recording.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

/// Frames of one camera of an LCM log.
class LogSource : public FrameSource {
 public:
  /// @throws std::runtime_error as OpenFrameSource.
  LogSource(const std::filesystem::path& log, const std::optional<std::string>& camera);

  std::optional<Frame> Next() override;
  /// The first call reads the log for its ground truth, which may stand anywhere in it.
  std::optional<GroundTruth> Truth(const Frame& frame) override;
  const std::string& camera() const override { return recording_.camera(); }
  double share_done() const override { return recording_.progress(); }
  Damage damage() const override;

 private:
  void Take(RecordedInput input);
  void ReadTruths();

  std::filesystem::path log_;
  Recording recording_;
  PoseSynchronizer synchronizer_;
  std::deque<Frame> ready_;
  std::optional<std::map<std::int64_t, ground_truth_t>> truths_;  // by utime
  bool is_at_end_ = false;
};

}  // namespace fallen
