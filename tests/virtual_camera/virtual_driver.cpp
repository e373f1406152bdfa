// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause

// An OpenNI2 driver that plays depth pictures through the real library: a camera for tests that can
// be plugged, unplugged and put out of order. How it is steered: virtual_pattern.hpp.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "openni_driver.hpp"
#include "virtual_pattern.hpp"
#include "virtual_stream.hpp"

namespace fallen::virtual_camera {
namespace {

enum class State { kPlugged, kUnplugged, kSilent, kRefusing };

/// How often the control file is looked at: short against a frame, so that tests need not wait.
constexpr std::chrono::milliseconds kControlPeriod{5};

State ReadState() {
  const char* path = std::getenv(kControlVariable);
  std::string word;
  if (path == nullptr || !(std::ifstream(path) >> word)) return State::kPlugged;
  if (word == "unplugged") return State::kUnplugged;
  if (word == "silent") return State::kSilent;
  if (word == "refusing") return State::kRefusing;
  return State::kPlugged;
}

std::vector<std::uint16_t> ReadRawFrames() {
  const char* path = std::getenv(kFramesVariable);
  if (path == nullptr) return {};
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return {};
  std::vector<std::uint16_t> values(static_cast<std::size_t>(file.tellg()) / sizeof(std::uint16_t));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(std::uint16_t)));
  return values;
}

int CameraCount() {
  const char* text = std::getenv(kCountVariable);
  return text == nullptr ? 1 : std::atoi(text);
}

bool AnnouncesPlugging() {
  const char* text = std::getenv(kHotplugVariable);
  return text == nullptr || std::strcmp(text, "0") != 0;
}

class VirtualDevice : public oni::driver::DeviceBase {
 public:
  VirtualDevice(const std::atomic<State>& state, const std::vector<std::uint16_t>& raw_frames)
      : state_(state),
        raw_frames_(raw_frames),
        modes_(SupportedModes().begin(), SupportedModes().end()) {
    sensor_ = {ONI_SENSOR_DEPTH, static_cast<int>(modes_.size()), modes_.data()};
  }

  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override {
    *sensors = &sensor_;
    *count = 1;
    return ONI_STATUS_OK;
  }

  oni::driver::StreamBase* createStream(OniSensorType type) override {
    if (type != ONI_SENSOR_DEPTH) return nullptr;
    // A device that was pulled out stays dead, also if another one is plugged in for it.
    return new VirtualStream(
        [this] {
          if (state_ == State::kUnplugged) dead_ = true;
          return !dead_ && state_ == State::kPlugged;
        },
        raw_frames_);
  }

  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }

 private:
  const std::atomic<State>& state_;
  const std::vector<std::uint16_t>& raw_frames_;
  std::vector<OniVideoMode> modes_;
  OniSensorInfo sensor_{};
  std::atomic<bool> dead_{false};
};

class VirtualDriver : public oni::driver::DriverBase {
 public:
  explicit VirtualDriver(OniDriverServices* services) : DriverBase(services) {}

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback changed, void* cookie) override {
    DriverBase::initialize(connected, disconnected, changed, cookie);
    for (int i = 0; i < CameraCount(); ++i) {
      OniDeviceInfo info{};
      std::snprintf(info.uri, sizeof(info.uri), "virtual://%d", i);
      std::snprintf(info.vendor, sizeof(info.vendor), "Fallen");
      std::snprintf(info.name, sizeof(info.name), "Virtual camera %d", i);
      infos_.push_back(info);
    }
    state_ = ReadState();
    if (state_ != State::kUnplugged) Announce(true);
    running_ = true;
    thread_ = std::thread([this] { WatchControl(); });
    return ONI_STATUS_OK;
  }

  void shutdown() override {
    running_ = false;
    if (thread_.joinable()) thread_.join();
  }

  oni::driver::DeviceBase* deviceOpen(const char*, const char*) override {
    if (state_ == State::kUnplugged || state_ == State::kRefusing) return nullptr;
    return new VirtualDevice(state_, raw_frames_);
  }

  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }

 private:
  void Announce(bool plugged) {
    for (const OniDeviceInfo& info : infos_)
      plugged ? deviceConnected(&info) : deviceDisconnected(&info);
  }

  void WatchControl() {
    const bool announces = AnnouncesPlugging();
    while (running_) {
      std::this_thread::sleep_for(kControlPeriod);
      const State before = state_.exchange(ReadState());
      const bool was_plugged = before != State::kUnplugged;
      const bool is_plugged = state_ != State::kUnplugged;
      if (announces && was_plugged != is_plugged) Announce(is_plugged);
    }
  }

  std::deque<OniDeviceInfo> infos_;
  std::vector<std::uint16_t> raw_frames_ = ReadRawFrames();
  std::atomic<State> state_{State::kPlugged};
  std::atomic<bool> running_{false};
  std::thread thread_;
};

}  // namespace
}  // namespace fallen::virtual_camera

ONI_EXPORT_DRIVER(fallen::virtual_camera::VirtualDriver)
