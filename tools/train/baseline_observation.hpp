// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "fallen/baseline/baseline_detector.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "tools/train/recording_split.hpp"

namespace fallen {

/// A frame as the training of the baseline sees it.
struct BaselineFrame {
  DescribedClusters clusters;
  std::optional<OrientedBox> person_box;  ///< frame of the clusters
  int cells_in_box = 0;                   ///< of the local NDT map; 0 where they are not counted
};

/// One recording, cut into clusters.
struct BaselineRecording {
  RecordingOrigin origin;
  std::vector<BaselineFrame> frames;
  std::int64_t damaged = 0;  ///< messages that could not be read
};

/// What BaselineFrame is made by.
struct BaselineObservation {
  GroundConfig ground;
  NdtConfig ndt;
  BaselineConfig baseline;
  int frame_stride = 1;  ///< every so many frames are kept, >= 1
  /// Maps all frames too, to say if a person counts as present (the paper, Sec. IV-B).
  bool counts_cells = true;
};

/// Cuts the frames of a log with ground truth into clusters. Frames with a person somewhere, but no
/// pose that would say where, are left out.
/// @throws std::runtime_error if the log cannot be read or holds no frame with ground truth.
BaselineRecording ObserveForBaseline(const std::filesystem::path& log,
                                     const BaselineObservation& observation);

}  // namespace fallen
