// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/oni_file.hpp"

#include <OpenNI.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "services/depth_capture/frame_gate.hpp"
#include "services/depth_capture/frame_wait.hpp"
#include "services/depth_capture/oni_index.hpp"
#include "services/depth_capture/openni_conversions.hpp"
#include "services/depth_capture/openni_session.hpp"

namespace fallen {
namespace {

/// Longest time to decode one frame [ms]. It takes milliseconds; a frame that never comes is
/// damage. Long, as a wait that is given up too early leaves OpenNI2 with a frame asked for twice.
constexpr int kFrameTimeoutMs = 10000;
/// Playback speed at which OpenNI2 hands out the next frame only when it is waited for.
constexpr float kOnDemand = -1.0F;
/// The player's thread looks at its list of streams without a lock, and a stream that is destroyed
/// in that moment crashes it (seen in one of 500 runs). In this time it comes to rest, waiting
/// until the next frame is asked for, where it does not look.
constexpr std::chrono::milliseconds kPlayerRest{30};
/// Time between frames of a recording with a single one [us]: that of a PrimeSense camera.
constexpr std::int64_t kDefaultPeriodUs = 33333;

/// A name for the file that nobody else in this process has.
///
/// OpenNI2 shares one player, and one place in the file, among all who open the same name, and
/// takes names of up to 255 characters only.
class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& file)
      : number_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (number_ < 0)
      throw std::runtime_error(file.string() + ": cannot be read: " + std::strerror(errno));
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

}  // namespace

struct OniFile::State {
  State(const std::filesystem::path& path, OniFileOptions its_options)
      : name(path.string()),
        options(std::move(its_options)),
        index(IndexOniFile(path)),
        descriptor(path) {}

  std::string name;
  OniFileOptions options;
  OniIndex index;
  Descriptor descriptor;
  std::size_t position = 0;
  OpenNiSession session;
  FrameGate gate;
  openni::Device device;
  openni::VideoStream stream;
  FieldOfView field_of_view;
  bool mirrored = false;

  ~State() {
    gate.Open();
    if (stream.isValid()) {
      stream.stop();
      std::this_thread::sleep_for(kPlayerRest);
    }
    stream.destroy();
    device.close();
  }
};

OniFile::OniFile(const std::filesystem::path& path, OniFileOptions options)
    : state_(std::make_unique<State>(path, std::move(options))) {
  State& state = *state_;
  const auto require = [&](bool good, const std::string& what) {
    if (!good)
      throw std::runtime_error(state.name + ": " + what + ": " + OpenNiError("no reason given"));
  };
  require(state.device.open(state.descriptor.path().c_str()) == openni::STATUS_OK &&
              state.device.isValid(),
          "OpenNI2 cannot open it");
  openni::PlaybackControl* playback = state.device.getPlaybackControl();
  // Repeating, it waits behind the last frame for the first to be asked for; else it would spin
  // there.
  require(playback != nullptr && playback->setSpeed(kOnDemand) == openni::STATUS_OK &&
              playback->setRepeatEnabled(true) == openni::STATUS_OK,
          "OpenNI2 cannot play it");
  require(state.stream.create(state.device, openni::SENSOR_DEPTH) == openni::STATUS_OK &&
              state.stream.setFrameBuffersAllocator(&state.gate) == openni::STATUS_OK,
          "no depth stream");
  state.mirrored = state.stream.getMirroringEnabled();
  state.field_of_view = FieldOfViewOf(state.stream);
  require(state.stream.start() == openni::STATUS_OK, "depth stream does not start");
}

OniFile::~OniFile() = default;
OniFile::OniFile(OniFile&&) noexcept = default;

std::optional<StampedDepthImage> OniFile::Next() {
  State& state = *state_;
  if (state.position == state.index.frames.size()) return std::nullopt;
  const OniIndexEntry& expected = state.index.frames[state.position];
  const auto refuse = [&](const std::string& text) {
    throw std::runtime_error(state.name + ": frame " + std::to_string(expected.number) + ": " +
                             text);
  };
  state.gate.Admit();
  openni::VideoFrameRef frame;
  if (WaitForFrame(state.stream, kFrameTimeoutMs, frame) != openni::STATUS_OK)
    refuse("cannot be decoded");
  // Should the player ever leave out a frame after all, nobody must take the next one for it.
  const OniIndexEntry got{static_cast<std::int64_t>(frame.getTimestamp()), frame.getFrameIndex()};
  if (got != expected)
    refuse("got frame " + std::to_string(got.number) + " of time " + std::to_string(got.time_us) +
           ", expected time " + std::to_string(expected.time_us));
  StampedDepthImage result;
  try {
    result.image = ToDepthImage(ViewOf(frame), state.field_of_view, state.mirrored);
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  }
  const std::int64_t since_first_us = got.time_us - state.index.frames.front().time_us;
  result.header = {state.options.epoch_us + since_first_us,
                   static_cast<std::int64_t>(state.position), state.options.sensor_name};
  result.T_robot_camera = state.options.T_robot_camera;
  ++state.position;
  return result;
}

std::size_t OniFile::frame_count() const { return state_->index.frames.size(); }

std::size_t OniFile::position() const { return state_->position; }

std::int64_t OniFile::duration_us() const {
  const std::vector<OniIndexEntry>& index = state_->index.frames;
  const std::int64_t span = index.back().time_us - index.front().time_us;
  if (index.size() < 2) return kDefaultPeriodUs;
  return span + span / static_cast<std::int64_t>(index.size() - 1);
}

}  // namespace fallen
