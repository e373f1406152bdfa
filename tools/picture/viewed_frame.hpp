// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fallen/detection/detector.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// A frame with everything that is known about it, for pictures.
struct ViewedFrame {
  std::string source;      ///< name of the recording
  std::int64_t index = 0;  ///< number in it, from 0
  Frame frame;
  FrameResult result;
  std::optional<OrientedBox> truth;  ///< the lying person's box, world frame, if labelled
};

}  // namespace fallen
