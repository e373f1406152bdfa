// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// All that training produces.
struct Model {
  CellModel cells;
  ClusterModel clusters;
  SegmentationConfig segmentation;  ///< the settings under which the clusters were trained
  std::string description;          ///< data, seed and date of the training, for people

  /// @throws std::invalid_argument if a part is out of range, or the parts do not fit together.
  void Validate() const;
};

}  // namespace fallen
