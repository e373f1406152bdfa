// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/ndt_mapping/ndt_mapping_service.hpp"

#include <string>
#include <utility>

#include "fallen/detection/map_update.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

void ReportGround(ServiceReporter& reporter, const GroundEstimate& ground) {
  if (ground.ok()) return reporter.SetState(ServiceState::kRunning, "");
  reporter.SetState(ServiceState::kDegraded,
                    "ground: " + std::string(EnumName(ground.status)) + ", no floor taken away");
}

}  // namespace

NdtMappingService::NdtMappingService(lcm::LCM& lcm, const StageOptions& options,
                                     const GroundConfig& ground, const NdtConfig& ndt)
    : ground_(ground), mapper_(ndt), loop_(lcm, options) {
  ground_.Validate();
  loop_.OnFrame<depth_image_t>(
      options.depth_channel.empty() ? channels::Depth(options.camera) : options.depth_channel,
      [this](const depth_image_t& depth) { HandleDepth(depth); });
  loop_.OnMessage<pose_t>(options.pose_channel, [this](const pose_t& pose) { HandlePose(pose); });
  loop_.OnIdle([this] { MapAll(synchronizer_.Flush()); });
}

void NdtMappingService::HandleDepth(const depth_image_t& message) {
  StampedDepthImage depth = FromMessage(message);
  Frame frame;
  frame.utime = depth.header.utime;
  frame.seq = depth.header.seq;
  frame.sensor_name = std::move(depth.header.sensor_name);
  frame.image = std::move(depth.image);
  frame.T_robot_camera = depth.T_robot_camera;
  MapAll(synchronizer_.AddFrame(std::move(frame)));
}

void NdtMappingService::HandlePose(const pose_t& message) {
  const StampedPose pose = FromMessage(message);
  MapAll(synchronizer_.AddPose(pose.utime, pose.translation, pose.rotation));
}

void NdtMappingService::MapAll(const std::vector<Frame>& frames) {
  for (const Frame& frame : frames) loop_.RunGuarded([&] { Map(frame); });
}

void NdtMappingService::Map(const Frame& frame) {
  const NdtMap map = UpdateMap(mapper_, frame, ground_);
  loop_.Publish(channels::NdtMap(loop_.options().camera),
                ToMessage(Header{frame.utime, frame.seq, frame.sensor_name}, map));
  ReportGround(loop_.reporter(), map.ground);
}

}  // namespace fallen
