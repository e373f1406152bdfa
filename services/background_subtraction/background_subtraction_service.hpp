// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <lcm/lcm-cpp.hpp>

#include "fallen/ndt_map_t.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen {

/// NDT_MAP_<CAMERA> -> FOREGROUND_<CAMERA>: the same map, cells flagged that are not known
/// background.
class BackgroundSubtractionService {
 public:
  BackgroundSubtractionService(lcm::LCM& lcm, const StageOptions& options,
                               BackgroundSubtractor background);

  StageLoop& loop() { return loop_; }

 private:
  ndt_map_t Subtract(const ndt_map_t& message);

  BackgroundSubtractor background_;
  StageLoop loop_;
};

}  // namespace fallen
