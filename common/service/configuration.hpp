// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "fallen/alarm/alarm_config.hpp"
#include "fallen/detection/detector.hpp"
#include "fallen/service/alarm_output_config.hpp"
#include "fallen/service/capture_config.hpp"
#include "fallen/service/channels.hpp"

/// Configuration of a deployment: one YAML file that every service and tool reads its sections of.
///
/// Sections: ground, ndt, background, segmentation, classification, alarm, files (model,
/// environment_map, zones), service (lcm_url, camera, robot), capture, history, mqtt. Every key has
/// a default; an unknown key or section, a value of a wrong type or out of range is an error that
/// names file and line.
namespace fallen {

/// Files that stages load. Relative paths are relative to the configuration file.
struct FilesConfig {
  std::string model;            ///< empty: the shipped model
  std::string environment_map;  ///< empty: none, everything is foreground
  std::string zones;            ///< empty: none, the alarm has one rule everywhere

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("model", model);
    visit("environment_map", environment_map);
    visit("zones", zones);
  }
};

struct ServiceConfig {
  std::string lcm_url = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";
  std::string camera = "CAMERA";
  std::string robot = "robot";  ///< begins the ids of alarms, names their MQTT topics
  /// Where the robot's pose comes: any channel that carries pose_t, which is bot_core.pose_t.
  std::string pose_channel = channels::kRobotPose;
  std::string depth_channel;  ///< where depth_image_t comes; empty: DEPTH_<camera>

  /// @throws std::invalid_argument for an empty URL, or a name that cannot be part of a channel.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("lcm_url", lcm_url);
    visit("camera", camera);
    visit("robot", robot);
    visit("pose_channel", pose_channel);
    visit("depth_channel", depth_channel);
  }
};

/// A loaded configuration.
struct Configuration {
  GroundConfig ground;
  NdtConfig ndt;
  BackgroundConfig background;
  ClassificationConfig classification;
  AlarmConfig alarm;
  FilesConfig files;  ///< paths as they can be opened, here and below: no longer relative
  ServiceConfig service;
  CaptureConfig capture;
  HistoryConfig history;
  MqttConfig mqtt;

  /// The model's segmentation settings with the file's overrides.
  /// @throws std::runtime_error naming file and line if they do not fit together.
  SegmentationConfig SegmentationOver(const SegmentationConfig& model_settings) const;

  /// Applies what the section `segmentation` sets; empty if there is none.
  std::function<void(SegmentationConfig&)> override_segmentation;
  std::string source;  ///< file, "" for the defaults
};

/// @param path  Nothing: all defaults.
/// @throws std::runtime_error: "<file>:<line>: <section>.<key>: got ..., expected ...".
Configuration LoadConfiguration(const std::optional<std::filesystem::path>& path);

/// The shipped model: what the environment variable FALLEN_MODEL names, else
/// share/fallen/models/fallen.model of the executable's installation, else models/fallen.model of
/// the source tree of a build. Where none is there, the installation's path: opening it tells.
std::filesystem::path ShippedModelPath();

}  // namespace fallen
