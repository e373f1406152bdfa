// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <lcm/lcm-cpp.hpp>
#include <vector>

#include "fallen/depth_image_t.hpp"
#include "fallen/detection/pose_synchronizer.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "fallen/pose_t.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen {

/// DEPTH_<CAMERA> and ROBOT_POSE -> NDT_MAP_<CAMERA>: the ground-free map as each frame leaves it.
class NdtMappingService {
 public:
  /// @throws std::invalid_argument if a configuration is out of range.
  NdtMappingService(lcm::LCM& lcm, const StageOptions& options, const GroundConfig& ground,
                    const NdtConfig& ndt);

  StageLoop& loop() { return loop_; }

 private:
  void HandleDepth(const depth_image_t& message);
  void HandlePose(const pose_t& message);
  void MapAll(const std::vector<Frame>& frames);
  void Map(const Frame& frame);

  GroundConfig ground_;
  NdtMapper mapper_;
  PoseSynchronizer synchronizer_;
  StageLoop loop_;
};

}  // namespace fallen
