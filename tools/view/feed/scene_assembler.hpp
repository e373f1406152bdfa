// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "tools/view/scene/scene.hpp"

namespace fallen {

/// Puts together what the services say about a frame: live messages, or those of a log.
///
/// Parts are joined by their frame's utime, which all results keep. A frame is whole with its
/// decision, which comes last; one that stays without is given out a second later, with what there
/// is. Frames come out in order of time; one that a newer one overtook is left out. Not
/// thread-safe.
class SceneAssembler {
 public:
  /// @param emit  Is given each scene.
  SceneAssembler(const std::string& camera, std::function<void(const Scene&)> emit);

  /// Takes a message of any channel; those that are not the camera's are ignored.
  /// @throws std::invalid_argument if it cannot be used.
  void Take(const std::string& channel, std::span<const std::uint8_t> bytes);

  /// Gives out what waits: at the end of a log.
  void Flush();

 private:
  void Add(const Header& header, const std::function<void(Scene&)>& fill);
  void EmitUpTo(std::int64_t utime);
  void EmitOverdue(std::int64_t newest_utime);

  using Handler = std::function<void(std::span<const std::uint8_t>)>;
  std::map<std::string, Handler> handlers_;  // by channel
  std::function<void(const Scene&)> emit_;
  std::map<std::int64_t, Scene> waiting_;  // by utime
  std::optional<std::int64_t> emitted_utime_;
};

/// LCM channels, as a regular expression, that an assembler of `camera` has use for.
std::string AssembledChannels(const std::string& camera);

}  // namespace fallen
