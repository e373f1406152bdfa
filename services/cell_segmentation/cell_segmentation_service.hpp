// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <lcm/lcm-cpp.hpp>

#include "fallen/clusters_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/segmentation/cell_segmenter.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen {

/// FOREGROUND_<CAMERA> -> CLUSTERS_<CAMERA>: cells with scores, and clusters of those like a
/// person.
class CellSegmentationService {
 public:
  /// @throws std::invalid_argument if the model or the configuration is out of range.
  CellSegmentationService(lcm::LCM& lcm, const StageOptions& options, const CellModel& model,
                          const SegmentationConfig& config);

  StageLoop& loop() { return loop_; }

 private:
  clusters_t Segment(const ndt_map_t& message);

  CellSegmenter segmenter_;
  StageLoop loop_;
};

}  // namespace fallen
