// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

/// Channel names, all in one place (README lists them with type, publisher and rate).
namespace fallen::channels {

inline constexpr char kRobotPose[] = "ROBOT_POSE";
inline constexpr char kFallAlarm[] = "FALL_ALARM";
inline constexpr char kFallAlarmAck[] = "FALL_ALARM_ACK";

inline std::string Depth(const std::string& camera) { return "DEPTH_" + camera; }
inline std::string NdtMap(const std::string& camera) { return "NDT_MAP_" + camera; }
inline std::string Foreground(const std::string& camera) { return "FOREGROUND_" + camera; }
inline std::string Clusters(const std::string& camera) { return "CLUSTERS_" + camera; }
inline std::string FallenPersons(const std::string& camera) { return "FALLEN_PERSONS_" + camera; }
inline std::string GroundTruth(const std::string& camera) { return "GROUND_TRUTH_" + camera; }
/// `service` as in the executables' names without "fallen-", e.g. "ndt-mapping" ->
/// STATUS_NDT_MAPPING.
std::string Status(const std::string& service);

/// Longest camera name: LCM's limit of 63 characters on a channel less our longest prefix.
inline constexpr std::size_t kMaxCameraLength = 40;

/// True for 1 to kMaxCameraLength letters, digits, '_' and '-'. Anything else would be taken as a
/// regular expression by LCM's subscribe.
bool IsValidCamera(const std::string& camera);

/// Camera name that tools assume unless told: "CAMERA".
inline constexpr char kDefaultCamera[] = "CAMERA";

}  // namespace fallen::channels
