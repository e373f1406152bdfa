// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

#include "fallen/service/channels.hpp"
#include "tools/frames/directory_source.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/frames/log_source.hpp"
#ifdef FALLEN_HAVE_OPENNI2
#include "tools/frames/oni_source.hpp"
#endif

namespace fallen {
namespace {

/// What OpenNI's recordings start with.
bool IsOniFile(const std::filesystem::path& file) {
  constexpr std::array<char, 4> kMagic = {'N', 'I', '1', '0'};
  std::array<char, kMagic.size()> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return start == kMagic || file.extension() == ".oni";
}

std::unique_ptr<FrameSource> OpenOni(
    const std::filesystem::path& file, [[maybe_unused]] const std::string& camera,
    [[maybe_unused]] const std::optional<Eigen::Isometry3d>& T_robot_camera) {
#ifdef FALLEN_HAVE_OPENNI2
  return std::make_unique<OniSource>(file, camera, T_robot_camera);
#else
  throw std::runtime_error(file.string() +
                           ": got an .oni recording, expected a log or a directory: this build is "
                           "without OpenNI2 (libopenni2-dev)");
#endif
}

}  // namespace

std::unique_ptr<FrameSource> OpenFrameSource(
    const std::filesystem::path& input, const std::optional<std::string>& camera,
    const std::optional<Eigen::Isometry3d>& T_robot_camera) {
  if (!std::filesystem::exists(input))
    throw std::runtime_error(
        input.string() + ": got no such file, expected an LCM log, an .oni file or a directory");
  const std::string name = camera.value_or(channels::kDefaultCamera);
  if (std::filesystem::is_directory(input)) return std::make_unique<DirectorySource>(input, name);
  if (IsOniFile(input)) return OpenOni(input, name, T_robot_camera);
  return std::make_unique<LogSource>(input, camera);
}

}  // namespace fallen
