// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fallen/alarm/fall_alarm.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/depth_image_t.hpp"
#include "fallen/detection/detector.hpp"
#include "fallen/environment_map_t.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/ground_truth_t.hpp"
#include "fallen/messages/depth_codec.hpp"
#include "fallen/model_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/pose_t.hpp"

/// Message <-> domain value, without loss but where said.
///
/// `ToMessage` wants valid values (it checks, and throws std::invalid_argument).
/// `FromMessage` trusts nothing: std::invalid_argument names field, got and expected.
namespace fallen {

/// Which measurement a value is about.
struct Header {
  std::int64_t utime = 0;
  std::int64_t seq = 0;
  std::string sensor_name;

  bool operator==(const Header&) const = default;
};
header_t ToMessage(const Header& value);
Header FromMessage(const header_t& message);

/// A depth image as it travels.
struct StampedDepthImage {
  Header header;
  DepthImage image;
  std::optional<Eigen::Isometry3d> T_robot_camera;
};
/// Lossless but for the mounting's rotation, which travels as a quaternion (1e-15).
depth_image_t ToMessage(const StampedDepthImage& value,
                        DepthCompression compression = kDefaultDepthCompression);
StampedDepthImage FromMessage(const depth_image_t& message);

/// Pose of the robot in the world, as the message has it; its velocities are not kept.
struct StampedPose {
  std::int64_t utime = 0;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};
pose_t ToMessage(const StampedPose& value);
StampedPose FromMessage(const pose_t& message);

ndt_map_t ToMessage(const Header& header, const NdtMap& map);
ndt_map_t ToMessage(const Header& header, const ForegroundMap& foreground);
NdtMap NdtMapFromMessage(const ndt_map_t& message);
/// @throws std::invalid_argument also for a map without flags.
ForegroundMap ForegroundFromMessage(const ndt_map_t& message);

clusters_t ToMessage(const Header& header, const SegmentedMap& segmented);
SegmentedMap FromMessage(const clusters_t& message);

fallen_persons_t ToMessage(const Header& header, const Decision& decision);
Decision FromMessage(const fallen_persons_t& message);

/// A change of an alarm as it travels: whose it is, and its number in that robot's history.
struct NumberedAlarm {
  std::string robot;
  std::int64_t number = 0;
  FallAlarm alarm;

  bool operator==(const NumberedAlarm&) const = default;
};
fall_alarm_t ToMessage(const NumberedAlarm& value);
NumberedAlarm FromMessage(const fall_alarm_t& message);

/// Somebody's answer to an alarm.
struct AlarmAnswer {
  std::int64_t utime = 0;
  std::string event_id;  ///< "": all that are active
  std::string by;
  bool closes = false;  ///< it is over; else: has taken notice

  bool operator==(const AlarmAnswer&) const = default;
};
fall_alarm_ack_t ToMessage(const AlarmAnswer& value);
AlarmAnswer FromMessage(const fall_alarm_ack_t& message);

/// What is really there. `labels` has one value a pixel, or is empty.
struct LabelledObject {
  std::string category;
  std::string name;
  std::int32_t label = 0;
  OrientedBox box;
};
struct GroundTruth {
  std::optional<OrientedBox> person_box;  ///< world frame; nothing: no fallen person in the scene
  std::string person;
  std::string room;
  std::vector<LabelledObject> objects;
  int label_width = 0;
  int label_height = 0;
  std::vector<std::uint8_t> labels;

  /// Label of the fallen person in `labels`, 0 if none is labelled.
  std::uint8_t person_label() const;
};
ground_truth_t ToMessage(const Header& header, const GroundTruth& truth);
GroundTruth FromMessage(const ground_truth_t& message);

model_t ToMessage(const Model& model);
Model FromMessage(const model_t& message);

environment_map_t ToMessage(const EnvironmentMap& map, const std::string& description);
EnvironmentMap FromMessage(const environment_map_t& message);

}  // namespace fallen
