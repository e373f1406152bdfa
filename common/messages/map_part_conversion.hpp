// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/messages/camera_view_conversion.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/map_conversion.hpp"
#include "fallen/messages/message_checks.hpp"

/// What ndt_map_t and clusters_t both say: of which map their cells are, not the cells. Internal to
/// this folder.
///
/// `owner` is the name of the message, for error texts. All throw std::invalid_argument.
namespace fallen {

/// The numbers that no conversion of a part checks.
template <class Message>
void CheckMapScalars(const std::string& owner, const Message& message) {
  FromMessage(message.header);
  CheckCellSize(owner, message.cell_size_m);
  checks::InRange(owner + ".frame", message.frame, 0, static_cast<int>(MapFrame::kCamera));
}

/// @param map  NdtMap or SegmentedMap.
template <class Map, class Message>
void MapPartToMessage(const std::string& owner, const Header& header, const Map& map,
                      Message& message) {
  message.header = ToMessage(header);
  message.cell_size_m = map.cell_size_m;
  message.frame = static_cast<std::int32_t>(map.frame);
  TransformToMessage(map.T_map_camera, message.T_map_camera);
  message.view = ViewToMessage(owner + ".view", map.view);
  message.ground = GroundToMessage(map.ground);
  CheckMapScalars(owner, message);
  TransformFromMessage(owner + ".T_map_camera", message.T_map_camera);
}

template <class Map, class Message>
void MapPartFromMessage(const std::string& owner, const Message& message, Map& map) {
  CheckMapScalars(owner, message);
  map.cell_size_m = message.cell_size_m;
  map.frame = static_cast<MapFrame>(message.frame);
  map.T_map_camera = TransformFromMessage(owner + ".T_map_camera", message.T_map_camera);
  map.view = ViewFromMessage(owner + ".view", message.view);
  map.ground = GroundFromMessage(owner, message.ground);
}

}  // namespace fallen
