// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "virtual_stream.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "virtual_pattern.hpp"

namespace fallen::virtual_camera {
namespace {

constexpr std::array<OniVideoMode, 5> kModes{{
    {ONI_PIXEL_FORMAT_DEPTH_1_MM, 320, 240, 30},
    {ONI_PIXEL_FORMAT_DEPTH_1_MM, 320, 240, 60},
    {ONI_PIXEL_FORMAT_DEPTH_1_MM, 640, 480, 30},
    {ONI_PIXEL_FORMAT_DEPTH_100_UM, 320, 240, 30},
    {ONI_PIXEL_FORMAT_DEPTH_100_UM, 640, 480, 30},
}};

template <class Value>
OniStatus Answer(const Value& value, void* data, int* size) {
  if (*size != static_cast<int>(sizeof(Value))) return ONI_STATUS_BAD_PARAMETER;
  *static_cast<Value*>(data) = value;
  return ONI_STATUS_OK;
}

bool SameMode(const OniVideoMode& a, const OniVideoMode& b) {
  return a.pixelFormat == b.pixelFormat && a.resolutionX == b.resolutionX &&
         a.resolutionY == b.resolutionY && a.fps == b.fps;
}

int StrideBytes(const OniVideoMode& mode) {
  return mode.resolutionX * static_cast<int>(sizeof(OniDepthPixel));
}

}  // namespace

std::span<const OniVideoMode> SupportedModes() { return kModes; }

VirtualStream::VirtualStream(std::function<bool()> sends_frames,
                             const std::vector<std::uint16_t>& raw_frames)
    : sends_frames_(std::move(sends_frames)), raw_frames_(raw_frames), mode_(kModes.front()) {}

VirtualStream::~VirtualStream() { stop(); }

OniStatus VirtualStream::start() {
  if (running_.exchange(true)) return ONI_STATUS_OK;
  thread_ = std::thread([this] { Run(); });
  return ONI_STATUS_OK;
}

void VirtualStream::stop() {
  running_ = false;
  if (thread_.joinable()) thread_.join();
}

OniStatus VirtualStream::getProperty(int id, void* data, int* size) {
  switch (id) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return Answer(mode_, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return Answer(StrideBytes(mode_), data, size);
    case ONI_STREAM_PROPERTY_CROPPING:
      return Answer(OniCropping{FALSE, 0, 0, mode_.resolutionX, mode_.resolutionY}, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return Answer(static_cast<float>(kHorizontalFovRad), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return Answer(static_cast<float>(kVerticalFovRad), data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return Answer(kMaxDepth, data, size);
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return Answer(0, data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return Answer(mirrored_, data, size);
    default:
      return ONI_STATUS_NOT_SUPPORTED;
  }
}

OniStatus VirtualStream::setProperty(int id, const void* data, int size) {
  if (id == ONI_STREAM_PROPERTY_MIRRORING && size == static_cast<int>(sizeof(OniBool))) {
    mirrored_ = *static_cast<const OniBool*>(data);
    return ONI_STATUS_OK;
  }
  if (id != ONI_STREAM_PROPERTY_VIDEO_MODE || size != static_cast<int>(sizeof(OniVideoMode)))
    return ONI_STATUS_NOT_SUPPORTED;
  const auto& wanted = *static_cast<const OniVideoMode*>(data);
  const auto same = [&](const OniVideoMode& mode) { return SameMode(mode, wanted); };
  if (running_ || std::none_of(kModes.begin(), kModes.end(), same)) return ONI_STATUS_BAD_PARAMETER;
  mode_ = wanted;
  return ONI_STATUS_OK;
}

OniBool VirtualStream::isPropertySupported(int id) {
  return id >= ONI_STREAM_PROPERTY_CROPPING && id <= ONI_STREAM_PROPERTY_MIRRORING;
}

void VirtualStream::Run() {
  const auto period = std::chrono::microseconds(1'000'000 / mode_.fps);
  auto next = std::chrono::steady_clock::now();
  int frame_number = 0;
  while (running_) {
    next += period;
    std::this_thread::sleep_until(next);
    if (running_ && sends_frames_()) Raise(++frame_number);
  }
}

void VirtualStream::Raise(int frame_number) {
  OniFrame* frame = getServices().acquireFrame();
  if (frame == nullptr) return;
  frame->frameIndex = frame_number;
  frame->videoMode = mode_;
  frame->width = mode_.resolutionX;
  frame->height = mode_.resolutionY;
  frame->cropOriginX = 0;
  frame->cropOriginY = 0;
  frame->croppingEnabled = FALSE;
  frame->sensorType = ONI_SENSOR_DEPTH;
  frame->stride = StrideBytes(mode_);
  frame->dataSize = frame->stride * frame->height;
  frame->timestamp = kFirstTimestampUs + static_cast<std::uint64_t>(frame_number - 1) *
                                             static_cast<std::uint64_t>(1'000'000 / mode_.fps);
  Fill(frame_number, static_cast<std::uint16_t*>(frame->data));
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

void VirtualStream::Fill(int frame_number, std::uint16_t* depth) const {
  const int width = mode_.resolutionX;
  const int height = mode_.resolutionY;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t raw_count = raw_frames_.size() / pixels;
  if (raw_count > 0) {
    const std::size_t index = static_cast<std::size_t>(frame_number - 1) % raw_count;
    std::copy_n(raw_frames_.data() + index * pixels, pixels, depth);
  } else {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) depth[y * width + x] = PatternDepth(x, y, frame_number);
  }
  if (!mirrored_) return;
  for (int y = 0; y < height; ++y) std::reverse(depth + y * width, depth + (y + 1) * width);
}

}  // namespace fallen::virtual_camera
