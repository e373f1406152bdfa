// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/map_part_conversion.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

const std::string kNdtMap = "ndt_map_t";
const std::string kCells = kNdtMap + ".cells";
const std::string kFlags = kNdtMap + ".is_foreground";
const std::string kEnvironmentMap = "environment_map_t";

void CheckFlags(const ndt_map_t& message) {
  checks::InRange(kNdtMap + ".background_status", message.background_status, 0,
                  static_cast<int>(BackgroundStatus::kNoPose));
  checks::Count(kNdtMap + ".flag_count", message.flag_count, message.is_foreground.size());
  for (const std::uint8_t flag : message.is_foreground) checks::InRange(kFlags, flag, 0, 1);
}

void CheckCellsNearCamera(const NdtMap& map) {
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    CheckNearCamera(kCells, i, map.cells[i].mean, map.T_map_camera);
}

// All but the flags.
NdtMap CheckedMap(const ndt_map_t& message) {
  NdtMap map;
  MapPartFromMessage(kNdtMap, message, map);
  map.cells = CellsFromMessage(kCells, message.cells);
  CheckCellsNearCamera(map);
  return map;
}

}  // namespace

ndt_map_t ToMessage(const Header& header, const NdtMap& map) {
  ndt_map_t message{};
  MapPartToMessage(kNdtMap, header, map, message);
  message.cells = CellsToMessage(map.cells);
  CheckCellsNearCamera(map);
  message.background_status = static_cast<std::int32_t>(BackgroundStatus::kNoEnvironmentMap);
  return message;
}

ndt_map_t ToMessage(const Header& header, const ForegroundMap& foreground) {
  ndt_map_t message = ToMessage(header, foreground.map);
  message.background_status = static_cast<std::int32_t>(foreground.status);
  message.is_foreground = foreground.is_foreground;
  message.flag_count = static_cast<std::int32_t>(message.is_foreground.size());
  CheckFlags(message);
  checks::Count(kNdtMap + ".flag_count", message.flag_count, foreground.map.cells.size());
  return message;
}

NdtMap NdtMapFromMessage(const ndt_map_t& message) {
  NdtMap map = CheckedMap(message);
  CheckFlags(message);
  if (message.flag_count != 0)
    checks::Count(kNdtMap + ".flag_count", message.flag_count, map.cells.size());
  return map;
}

ForegroundMap ForegroundFromMessage(const ndt_map_t& message) {
  ForegroundMap foreground;
  foreground.map = CheckedMap(message);
  CheckFlags(message);
  checks::Count(kNdtMap + ".flag_count", message.flag_count, foreground.map.cells.size());
  foreground.is_foreground = message.is_foreground;
  foreground.status = static_cast<BackgroundStatus>(message.background_status);
  return foreground;
}

environment_map_t ToMessage(const EnvironmentMap& map, const std::string& description) {
  environment_map_t message{};
  message.cell_size_m = map.cell_size_m;
  message.description = description;
  CheckCellSize(kEnvironmentMap, message.cell_size_m);
  checks::CheckText(kEnvironmentMap + ".description", message.description, limits::kMaxTextBytes);
  message.cells = CellsToMessage(map.cells);
  return message;
}

EnvironmentMap FromMessage(const environment_map_t& message) {
  CheckCellSize(kEnvironmentMap, message.cell_size_m);
  checks::CheckText(kEnvironmentMap + ".description", message.description, limits::kMaxTextBytes);
  return {message.cell_size_m, CellsFromMessage(kEnvironmentMap + ".cells", message.cells),
          message.description};
}

}  // namespace fallen
