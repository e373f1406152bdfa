// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/openni_conversions.hpp"

#include <algorithm>

namespace fallen {

std::string OpenNiError(const std::string& otherwise) {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
  const std::size_t end = text.find_last_not_of(' ');
  text.resize(end == std::string::npos ? 0 : end + 1);
  return text.empty() ? otherwise : text;
}

std::optional<DepthMode> FromOpenNi(const openni::VideoMode& mode) {
  DepthMode result{mode.getResolutionX(), mode.getResolutionY(), mode.getFps(), DepthUnit::k1Mm};
  if (mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM) return result;
  result.unit = DepthUnit::k100Um;
  if (mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_100_UM) return result;
  return std::nullopt;
}

openni::VideoMode ToOpenNi(const DepthMode& mode) {
  openni::VideoMode result;
  result.setResolution(mode.width, mode.height);
  result.setFps(mode.rate_hz);
  result.setPixelFormat(mode.unit == DepthUnit::k1Mm ? openni::PIXEL_FORMAT_DEPTH_1_MM
                                                     : openni::PIXEL_FORMAT_DEPTH_100_UM);
  return result;
}

std::vector<DepthMode> DepthModesOf(openni::Device& device) {
  std::vector<DepthMode> modes;
  const openni::SensorInfo* sensor = device.getSensorInfo(openni::SENSOR_DEPTH);
  if (sensor == nullptr) return modes;
  const openni::Array<openni::VideoMode>& offered = sensor->getSupportedVideoModes();
  for (int i = 0; i < offered.getSize(); ++i) {
    const std::optional<DepthMode> mode = FromOpenNi(offered[i]);
    // The PS1080 lists a mode once for each way of transferring it over USB.
    if (mode && std::find(modes.begin(), modes.end(), *mode) == modes.end()) modes.push_back(*mode);
  }
  return modes;
}

RawDepthFrame ViewOf(const openni::VideoFrameRef& frame) {
  const std::optional<DepthMode> mode = FromOpenNi(frame.getVideoMode());
  if (!mode || frame.getSensorType() != openni::SENSOR_DEPTH)
    throw BadFrame("depth frame: pixel format " +
                   std::to_string(frame.getVideoMode().getPixelFormat()) + " holds no depth");
  RawDepthFrame view;
  view.bytes = {static_cast<const std::uint8_t*>(frame.getData()),
                static_cast<std::size_t>(std::max(frame.getDataSize(), 0))};
  view.width = frame.getWidth();
  view.height = frame.getHeight();
  view.stride_bytes = frame.getStrideInBytes();
  view.full_width = mode->width;
  view.full_height = mode->height;
  view.crop_x = frame.getCroppingEnabled() ? frame.getCropOriginX() : 0;
  view.crop_y = frame.getCroppingEnabled() ? frame.getCropOriginY() : 0;
  view.unit = mode->unit;
  return view;
}

FieldOfView FieldOfViewOf(const openni::VideoStream& stream) {
  return {stream.getHorizontalFieldOfView(), stream.getVerticalFieldOfView()};
}

}  // namespace fallen
