// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/camera_view_t.hpp"
#include "fallen/geometry/camera_view.hpp"

/// Views inside other messages. Internal to this folder.
namespace fallen {

/// Both throw std::invalid_argument, naming `field`, unless the model is one of a camera and there
/// is a depth for each block; a view that is not known has neither.
camera_view_t ViewToMessage(const std::string& field, const CameraView& view);
CameraView ViewFromMessage(const std::string& field, const camera_view_t& message);

}  // namespace fallen
