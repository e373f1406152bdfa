// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/baseline_model.hpp"

#include <stdexcept>

#include "fallen/baseline/layer_features.hpp"

namespace fallen {

void BaselineModel::Validate() const {
  config.Validate();
  trees.Validate();
  calibration.Validate();
  if (trees.feature_count != LayerFeatureCount(config))
    throw std::invalid_argument("baseline: the trees take " + std::to_string(trees.feature_count) +
                                " features, must be " + std::to_string(LayerFeatureCount(config)));
}

}  // namespace fallen
