// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "fallen/box_t.hpp"
#include "fallen/geometry/oriented_box.hpp"

/// Boxes inside other messages. Internal to this folder.
namespace fallen {

/// Both throw std::invalid_argument, naming `field`, unless all is finite and sizes are >= 0.
box_t BoxToMessage(std::string_view field, const OrientedBox& box);
OrientedBox BoxFromMessage(std::string_view field, const box_t& message);

}  // namespace fallen
