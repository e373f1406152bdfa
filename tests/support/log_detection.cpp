// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/log_detection.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "fallen/detection/pose_synchronizer.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"

namespace fallen::testing_support {
namespace {

Frame FrameOf(const depth_image_t& message) {
  StampedDepthImage depth = FromMessage(message);
  Frame frame;
  frame.utime = depth.header.utime;
  frame.seq = depth.header.seq;
  frame.sensor_name = depth.header.sensor_name;
  frame.image = std::move(depth.image);
  frame.T_robot_camera = depth.T_robot_camera;
  return frame;
}

}  // namespace

void DetectInLog(const std::filesystem::path& path, const Model& model, const std::string& camera,
                 const std::function<void(const Frame&, const FrameResult&)>& visit) {
  DetectorConfig config;
  config.segmentation = model.segmentation;
  Detector detector(model, config, BackgroundSubtractor(config.background));
  PoseSynchronizer synchronizer;
  const auto detect = [&](const std::vector<Frame>& frames) {
    for (const Frame& frame : frames) visit(frame, detector.Detect(frame));
  };
  LogReader log(path);
  while (const auto event = log.Next()) {
    if (event->channel == channels::kRobotPose) {
      const StampedPose pose = FromMessage(*DecodeMessage<pose_t>(event->data).message);
      detect(synchronizer.AddPose(pose.utime, pose.translation, pose.rotation));
    }
    if (event->channel == channels::Depth(camera))
      detect(synchronizer.AddFrame(FrameOf(*DecodeMessage<depth_image_t>(event->data).message)));
  }
  detect(synchronizer.Flush());
}

void WriteStageLog(const std::filesystem::path& input, const Model& model,
                   const std::filesystem::path& output, const std::string& camera) {
  std::vector<LogEvent> events;
  std::map<std::int64_t, std::int64_t> logged_at;  // utime of a frame -> of its event
  LogReader source(input);
  while (auto event = source.Next()) {
    const bool is_depth = event->channel == channels::Depth(camera);
    if (is_depth)
      logged_at[DecodeMessage<depth_image_t>(event->data).message->header.utime] = event->utime;
    if (is_depth || event->channel == channels::kRobotPose) events.push_back(std::move(*event));
  }
  DetectInLog(input, model, camera, [&](const Frame& frame, const FrameResult& result) {
    const Header header{frame.utime, frame.seq, frame.sensor_name};
    const auto add = [&](const std::string& channel, std::vector<std::uint8_t> data) {
      events.push_back({0, logged_at.at(frame.utime), channel, std::move(data)});
    };
    add(channels::NdtMap(camera), EncodeMessage(ToMessage(header, result.foreground.map)));
    add(channels::Foreground(camera), EncodeMessage(ToMessage(header, result.foreground)));
    add(channels::Clusters(camera), EncodeMessage(ToMessage(header, result.segmented)));
    add(channels::FallenPersons(camera), EncodeMessage(ToMessage(header, result.decision)));
  });
  // A player keeps the events' times: results belong beside their frames.
  std::stable_sort(events.begin(), events.end(),
                   [](const LogEvent& a, const LogEvent& b) { return a.utime < b.utime; });
  LogWriter log(output);
  for (const LogEvent& event : events) log.Write(event.utime, event.channel, event.data);
  log.Close();
}

std::vector<std::vector<std::uint8_t>> BytesInLog(const std::filesystem::path& path,
                                                  const std::string& channel) {
  std::vector<std::vector<std::uint8_t>> messages;
  LogReader log(path);
  while (auto event = log.Next())
    if (event->channel == channel) messages.push_back(std::move(event->data));
  return messages;
}

}  // namespace fallen::testing_support
