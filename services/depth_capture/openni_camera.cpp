// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/openni_camera.hpp"

#include <OpenNI.h>

#include <atomic>
#include <vector>

#include "services/depth_capture/frame_wait.hpp"
#include "services/depth_capture/oni_index.hpp"
#include "services/depth_capture/openni_conversions.hpp"
#include "services/depth_capture/openni_session.hpp"

namespace fallen {
namespace {

/// Hears when a camera is pulled out; OpenNI2 says so from a thread of its own.
class UnplugListener : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  explicit UnplugListener(const std::string& uri) : uri_(uri) {
    openni::OpenNI::addDeviceDisconnectedListener(this);
  }
  ~UnplugListener() { openni::OpenNI::removeDeviceDisconnectedListener(this); }
  UnplugListener(const UnplugListener&) = delete;
  UnplugListener& operator=(const UnplugListener&) = delete;

  bool unplugged() const { return unplugged_; }

 private:
  void onDeviceDisconnected(const openni::DeviceInfo* info) override {
    if (uri_ == info->getUri()) unplugged_ = true;
  }

  const std::string uri_;
  std::atomic<bool> unplugged_{false};
};

/// The URI to open. @throws CameraUnavailable
std::string FindCamera(const std::string& wanted_uri) {
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::string others;
  for (int i = 0; i < devices.getSize(); ++i) {
    const std::string uri = devices[i].getUri();
    if (wanted_uri.empty() || uri == wanted_uri) return uri;
    others += (others.empty() ? "" : ", ") + uri;
  }
  if (others.empty()) throw CameraUnavailable("no camera is plugged in");
  throw CameraUnavailable("no camera " + wanted_uri + " is plugged in, there is " + others);
}

/// OpenNI2's recorder doubles the length of a file when it closes it, with nothing.
void DropPadding(const std::filesystem::path& path) noexcept {
  try {
    std::filesystem::resize_file(path, IndexOniFile(path).bytes);
  } catch (const std::exception&) {
    // A recording without a single frame, or a disk that is full: what there is stays as it is.
  }
}

}  // namespace

/// Destroyed from the last member to the first: recorder before stream before device before
/// library.
struct OpenNiCamera::State {
  OpenNiSession session;
  std::optional<UnplugListener> unplug;
  openni::Device device;
  openni::VideoStream stream;
  openni::Recorder recorder;
  std::string description;
  FieldOfView field_of_view;
  bool mirrored = false;

  std::optional<std::filesystem::path> record;

  ~State() {
    recorder.destroy();
    if (record) DropPadding(*record);
    if (stream.isValid()) stream.stop();
    stream.destroy();
    device.close();
  }
};

namespace {

void Open(openni::Device& device, const std::string& uri) {
  // Going on with a device that did not open crashes inside OpenNI2.
  if (device.open(uri.c_str()) != openni::STATUS_OK || !device.isValid())
    throw CameraUnavailable(uri + ": cannot be opened: " + OpenNiError("no reason given"));
}

/// @throws CameraUnavailable if `status` is not OK.
void Require(openni::Status status, const std::string& uri, const std::string& what) {
  if (status == openni::STATUS_OK) return;
  throw CameraUnavailable(uri + ": " + what + ": " + OpenNiError("no reason given"));
}

void StartRecording(openni::Recorder& recorder, openni::VideoStream& stream,
                    const std::filesystem::path& path) {
  constexpr bool kLossy = false;
  if (recorder.create(path.c_str()) == openni::STATUS_OK &&
      recorder.attach(stream, kLossy) == openni::STATUS_OK && recorder.start() == openni::STATUS_OK)
    return;
  throw std::runtime_error(path.string() +
                           ": cannot be recorded to: " + OpenNiError("no reason given"));
}

}  // namespace

OpenNiCamera::OpenNiCamera(const std::string& uri, const DepthMode& mode,
                           const std::optional<std::filesystem::path>& record) {
  try {
    state_ = std::make_unique<State>();
  } catch (const std::runtime_error& error) {
    throw CameraUnavailable(error.what());
  }
  const std::string found = FindCamera(uri);
  state_->unplug.emplace(found);
  Open(state_->device, found);
  RequireSupported(found, mode, DepthModesOf(state_->device));
  openni::VideoStream& stream = state_->stream;
  Require(stream.create(state_->device, openni::SENSOR_DEPTH), found, "no depth stream");
  Require(stream.setVideoMode(ToOpenNi(mode)), found, "mode " + ToString(mode) + " is refused");
  stream.setMirroringEnabled(false);
  state_->mirrored = stream.getMirroringEnabled();
  state_->field_of_view = FieldOfViewOf(stream);
  if (record) StartRecording(state_->recorder, stream, *record);
  state_->record = record;
  Require(stream.start(), found, "depth stream does not start");
  const openni::DeviceInfo& info = state_->device.getDeviceInfo();
  state_->description =
      std::string(info.getVendor()) + " " + info.getName() + " (" + found + "), " + ToString(mode);
}

OpenNiCamera::~OpenNiCamera() = default;

std::optional<CameraFrame> OpenNiCamera::Read(std::chrono::milliseconds timeout) {
  openni::VideoFrameRef frame;
  const openni::Status status =
      WaitForFrame(state_->stream, static_cast<int>(timeout.count()), frame);
  if (state_->unplug->unplugged()) throw CameraUnavailable(state_->description + ": was unplugged");
  if (status == openni::STATUS_TIME_OUT) return std::nullopt;
  if (status != openni::STATUS_OK)
    throw CameraUnavailable(state_->description +
                            ": cannot be read: " + OpenNiError("no reason given"));
  CameraFrame result;
  result.image = ToDepthImage(ViewOf(frame), state_->field_of_view, state_->mirrored);
  result.device_time_us = static_cast<std::int64_t>(frame.getTimestamp());
  result.device_index = frame.getFrameIndex();
  return result;
}

std::string OpenNiCamera::description() const { return state_->description; }

}  // namespace fallen
