// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fallen/detection/detector.hpp"

namespace fallen::testing_support {

/// Calls `visit` with the result of each frame of `camera` in a log, by the detector in this
/// process.
void DetectInLog(const std::filesystem::path& path, const Model& model, const std::string& camera,
                 const std::function<void(const Frame&, const FrameResult&)>& visit);

/// Writes the log of all stages: what `input` has on the depth and pose channels, and after each
/// frame what the four services would publish for it.
void WriteStageLog(const std::filesystem::path& input, const Model& model,
                   const std::filesystem::path& output, const std::string& camera = "CAMERA");

/// Messages of a channel in a log, as bytes, in order.
std::vector<std::vector<std::uint8_t>> BytesInLog(const std::filesystem::path& path,
                                                  const std::string& channel);

}  // namespace fallen::testing_support
