// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "tools/common/detector_setup.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/view/server/page_server.hpp"

namespace fallen {

/// The command line of fallen-view.
struct ViewOptions {
  std::filesystem::path input;        ///< empty: live from LCM
  std::filesystem::path export_file;  ///< empty: serve the page
  std::string frame = "best";
  std::optional<std::string> camera;
  std::optional<std::string> lcm_url;
  bool detects_anew = false;  ///< though the log holds what was decided
  DetectorOptions detector;
  std::filesystem::path page;  ///< empty: the shipped one
  std::filesystem::path token_file;
  PageServerOptions server;
};

/// Opens the recording to look at; an `.oni` file, which knows no mounting, with the configured
/// one.
/// @throws std::runtime_error as OpenFrameSource and LoadConfiguration.
std::unique_ptr<FrameSource> OpenInput(const ViewOptions& options);

/// Name of a recording for people: its last part.
std::string NameOf(const std::filesystem::path& input);

/// Adds the options to the parser, with their checks.
void AddViewOptions(CLI::App& parser, ViewOptions& options);

}  // namespace fallen
