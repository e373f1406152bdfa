// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/model.hpp"

#include <stdexcept>

namespace fallen {

void Model::Validate() const {
  cells.Validate();
  clusters.Validate();
  segmentation.Validate();
  // The segmentation computes descriptors once; the classifier of clusters is fed the same ones.
  if (!(cells.iron == clusters.iron))
    throw std::invalid_argument(
        "model: descriptors of the cell classifier and of the cluster classifier differ, must be "
        "the same");
}

}  // namespace fallen
