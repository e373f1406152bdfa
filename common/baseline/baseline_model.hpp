// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/baseline/baseline_config.hpp"
#include "fallen/classification/calibration.hpp"
#include "fallen/segmentation/boosted_trees.hpp"

namespace fallen {

/// All that training the baseline produces.
struct BaselineModel {
  BaselineConfig config;    ///< that the trees were trained for
  BoostedTrees trees;       ///< judge ComputeLayerFeatures
  Calibration calibration;  ///< of the trees' score
  std::string description;  ///< data, seed and date of the training, for people

  /// @throws std::invalid_argument if a part is out of range, or the parts do not fit together.
  void Validate() const;
};

}  // namespace fallen
