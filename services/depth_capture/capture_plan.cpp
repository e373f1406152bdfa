// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/capture_plan.hpp"

#include <charconv>
#include <iostream>
#include <stdexcept>

#include "services/depth_capture/openni_session.hpp"

namespace fallen {
namespace {

void PrintCameras() {
  const OpenNiSession session;
  const std::vector<CameraInfo> cameras = ListCameras(session);
  if (cameras.empty()) std::cout << "no camera is plugged in\n";
  for (const CameraInfo& camera : cameras) {
    std::cout << camera.uri << "  " << camera.vendor << " " << camera.name << "\n";
    for (const DepthMode& mode : camera.modes)
      std::cout << "    --width " << mode.width << " --height " << mode.height << " --rate "
                << mode.rate_hz << " --unit " << EnumName(mode.unit) << "\n";
    if (camera.modes.empty()) std::cout << "    " << camera.problem << "\n";
  }
  std::cout.flush();
}

bool IsRecording(const std::string& name) {
  return std::filesystem::path(name).extension() == ".oni";
}

DepthUnit ParseUnit(const std::string& text) {
  const std::optional<DepthUnit> unit = EnumFromName<DepthUnit>(text);
  if (!unit) throw std::invalid_argument("--unit: got '" + text + "', expected 1mm or 100um");
  return *unit;
}

std::int64_t ParseEpoch(const std::string& text, std::int64_t now_us) {
  if (text.empty()) return 0;
  if (text == "now") return now_us;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0)
    throw std::invalid_argument("--epoch: got '" + text +
                                "', expected microseconds since the epoch, or now");
  return value;
}

/// A flag that says nothing where it stands is a mistake somebody should hear of.
void RefuseWithRecording(bool given, const std::string& flag) {
  if (given)
    throw std::invalid_argument(flag + ": got it with a recording, expected it with a camera only");
}

void RefuseWithCamera(bool given, const std::string& flag) {
  if (given)
    throw std::invalid_argument(flag + ": got it with a camera, expected it with a recording only");
}

void RequireNewFile(const std::filesystem::path& path) {
  if (!IsRecording(path))
    throw std::invalid_argument("--record: got '" + path.string() + "', expected a name in .oni");
  if (std::filesystem::exists(path))
    throw std::invalid_argument("--record: got '" + path.string() +
                                "', which is there already, expected a new file");
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw std::invalid_argument("--record: got '" + path.string() +
                                "', expected a file in a folder that is there");
}

}  // namespace

void AddCaptureFlags(CLI::App& cli, CaptureFlags& flags) {
  cli.add_option("FILE", flags.file, "Recording (.oni) to play in place of a camera");
  cli.add_option("--device", flags.device, "Camera, as --list prints it; else the first one")
      ->type_name("URI");
  cli.add_option("--width", flags.width, "Width of the pictures [px]");
  cli.add_option("--height", flags.height, "Height of the pictures [px]");
  cli.add_option("--rate", flags.rate_hz, "Pictures a second");
  cli.add_option("--unit", flags.unit, "Step of the depth values: 1mm or 100um");
  cli.add_option("--record", flags.record,
                 "Record all that the camera takes; whole once this program has ended")
      ->type_name("FILE.oni");
  cli.add_flag("--as-fast-as-possible", flags.as_fast_as_possible,
               "Play a recording without its pauses");
  cli.add_flag("--loop", flags.loop, "Play a recording over and over");
  cli.add_option("--epoch", flags.epoch,
                 "Time of a recording's first picture, in us since the epoch, or now; else 0")
      ->type_name("TIME");
  cli.add_flag_callback(
      "--list",
      [] {
        try {
          PrintCameras();
        } catch (const std::exception& error) {
          throw CLI::ValidationError(error.what());
        }
        throw CLI::Success();
      },
      "Print the cameras that are plugged in, with their modes");
}

CapturePlan MakeCapturePlan(const CaptureFlags& flags, const CaptureConfig& config,
                            std::int64_t now_us) {
  CapturePlan plan;
  plan.config = config;
  if (flags.device) plan.config.device_uri = *flags.device;
  if (flags.width) plan.config.width = *flags.width;
  if (flags.height) plan.config.height = *flags.height;
  if (flags.rate_hz) plan.config.rate_hz = *flags.rate_hz;
  if (!flags.unit.empty()) plan.config.depth_unit = ParseUnit(flags.unit);
  plan.config.Validate();
  plan.loop = flags.loop;
  plan.as_fast_as_possible = flags.as_fast_as_possible;
  plan.epoch_us = ParseEpoch(flags.epoch, now_us);
  if (!flags.file.empty()) {
    plan.file = flags.file;
  } else if (IsRecording(plan.config.device_uri)) {
    plan.file = plan.config.device_uri;
  }
  if (plan.file) {
    RefuseWithRecording(!flags.file.empty() && flags.device.has_value(), "--device");
    RefuseWithRecording(!flags.record.empty(), "--record");
    RefuseWithRecording(flags.width || flags.height || flags.rate_hz || !flags.unit.empty(),
                        "--width, --height, --rate or --unit");
    return plan;
  }
  RefuseWithCamera(flags.loop, "--loop");
  RefuseWithCamera(flags.as_fast_as_possible, "--as-fast-as-possible");
  RefuseWithCamera(!flags.epoch.empty(), "--epoch");
  if (!flags.record.empty()) {
    RequireNewFile(flags.record);
    plan.record = flags.record;
  }
  return plan;
}

}  // namespace fallen
