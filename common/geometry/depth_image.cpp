// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/depth_image.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {

void DepthImage::Validate() const {
  intrinsics.Validate();
  if (!std::isfinite(depth_unit_m) || depth_unit_m <= 0)
    throw std::invalid_argument("depth_image: depth_unit_m is " + std::to_string(depth_unit_m) +
                                ", must be > 0 and finite");
  const auto pixels =
      static_cast<std::size_t>(intrinsics.width) * static_cast<std::size_t>(intrinsics.height);
  if (depth.size() != pixels)
    throw std::invalid_argument("depth_image: depth has " + std::to_string(depth.size()) +
                                " values, must have width * height = " + std::to_string(pixels));
}

}  // namespace fallen
