// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <lcm/lcm-cpp.hpp>

#include "fallen/classification/cluster_classifier.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen {

/// CLUSTERS_<CAMERA> -> FALLEN_PERSONS_<CAMERA>: every cluster judged, one decision a frame.
class ClusterClassificationService {
 public:
  /// @throws std::invalid_argument if the model or the configuration is out of range.
  ClusterClassificationService(lcm::LCM& lcm, const StageOptions& options, ClusterModel model,
                               const ClassificationConfig& config);

  StageLoop& loop() { return loop_; }

 private:
  fallen_persons_t Classify(const clusters_t& message);

  ClusterClassifier classifier_;
  ClassificationConfig config_;
  Decision decision_;  // of the newest frame, for its memory
  StageLoop loop_;
};

}  // namespace fallen
