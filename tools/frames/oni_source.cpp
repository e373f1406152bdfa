// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/frames/oni_source.hpp"

#include <stdexcept>
#include <utility>

#include "tools/frames/frame_from_message.hpp"

namespace fallen {
namespace {

OniFileOptions Named(const std::string& camera) {
  OniFileOptions options;
  options.sensor_name = camera;
  return options;
}

}  // namespace

OniSource::OniSource(const std::filesystem::path& file, const std::string& camera)
    : file_(file, Named(camera)), camera_(camera) {}

std::optional<Frame> OniSource::Next() {
  if (is_at_end_) return std::nullopt;
  try {
    if (std::optional<StampedDepthImage> depth = file_.Next()) return ToFrame(std::move(*depth));
  } catch (const std::exception& error) {
    damage_.Add(error.what());  // the player does not go on behind it
  }
  is_at_end_ = true;
  return std::nullopt;
}

double OniSource::share_done() const {
  return static_cast<double>(file_.position()) / static_cast<double>(file_.frame_count());
}

}  // namespace fallen
