// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/serve_page.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <utility>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/configuration.hpp"
#include "fallen/service/logging.hpp"
#include "fallen/service/stop_signal.hpp"
#include "tools/view/feed/file_archive.hpp"
#include "tools/view/feed/live_source.hpp"
#include "tools/view/feed/memory_archive.hpp"
#include "tools/view/feed/recorded_source.hpp"
#include "tools/view/feed/replay_source.hpp"
#include "tools/view/feed/source_thread.hpp"
#include "tools/view/scene/scene_message.hpp"

namespace fallen {
namespace {

/// Frames that can be gone back to, live: about twenty seconds at 10 Hz.
constexpr std::size_t kLiveBytes = std::size_t{64} << 20;
/// Of the timeline: an hour at 10 Hz; a recording's is kept whole.
constexpr std::size_t kLiveEntries = 36000;
constexpr std::size_t kReplayEntries = std::size_t{1} << 24;

using Work = std::function<void(const std::atomic<bool>&)>;

std::shared_ptr<LiveSource> MakeLive(Feed& feed, const ViewOptions& options,
                                     const Configuration& config) {
  return std::make_shared<LiveSource>(feed, options.lcm_url.value_or(config.service.lcm_url),
                                      options.camera.value_or(config.service.camera));
}

std::optional<std::string> CameraOfRecordedDecisions(const ViewOptions& options) {
  if (options.detects_anew || !std::filesystem::is_regular_file(options.input)) return std::nullopt;
  return CameraWithDecisions(options.input, options.camera);
}

Work MakeReplay(Feed& feed, const ViewOptions& options) {
  const std::string name = NameOf(options.input);
  if (const auto camera = CameraOfRecordedDecisions(options)) {
    const auto source = std::make_shared<RecordedSource>(feed, options.input, *camera, name);
    return [source](const std::atomic<bool>& is_stopping) { source->Run(is_stopping); };
  }
  const auto source = std::make_shared<ReplaySource>(feed, OpenInput(options),
                                                     MakeDetector(options.detector), name);
  return [source](const std::atomic<bool>& is_stopping) { source->Run(is_stopping); };
}

std::unique_ptr<Feed> MakeFeed(bool is_live) {
  if (is_live)
    return std::make_unique<Feed>(std::make_unique<MemoryArchive>(kLiveBytes), kLiveEntries);
  return std::make_unique<Feed>(
      std::make_unique<FileArchive>(std::filesystem::temp_directory_path()), kReplayEntries);
}

void ShowEnvironment(Feed& feed, const ViewOptions& options, const Configuration& config) {
  const std::string file = options.detector.environment_map.empty()
                               ? config.files.environment_map
                               : options.detector.environment_map;
  if (!file.empty())
    feed.SetBinaryTopic("environment", EnvironmentToMessage(LoadEnvironmentMap(file)));
}

std::string ReadToken(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string token;
  std::getline(in, token);
  constexpr std::size_t kMinLength = 8;
  const bool is_plain = std::all_of(token.begin(), token.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '-' || c == '_';
  });
  if (!in && token.empty()) throw std::runtime_error(file.string() + ": token: cannot be read");
  if (token.size() < kMinLength || !is_plain)
    throw std::runtime_error(file.string() +
                             ":1: token: expected 8 or more letters, digits, _ and -");
  return token;
}

PageServerOptions ServerOptions(const ViewOptions& options) {
  PageServerOptions server = options.server;
  if (!options.token_file.empty())
    server.token = ReadToken(options.token_file);
  else if (!IsLoopback(server.address))
    server.token = MakeToken();
  return server;
}

}  // namespace

int ServePage(const ViewOptions& options) {
  StopSignal stop;
  SetUpLogging("view");
  const Configuration config = LoadConfiguration(options.detector.config);
  const PageFiles files(options.page.empty() ? ShippedPagePath() : options.page);
  const bool is_live = options.input.empty();
  const std::unique_ptr<Feed> feed = MakeFeed(is_live);
  PageServerOptions server_options = ServerOptions(options);
  std::shared_ptr<LiveSource> live;
  if (is_live) {
    live = MakeLive(*feed, options, config);
    server_options.acknowledge = [live](const std::string& id) { live->Acknowledge(id); };
  }
  PageServer server(*feed, files, server_options);
  ShowEnvironment(*feed, options, config);
  const SourceThread source(
      live ? Work([live](const std::atomic<bool>& is_stopping) { live->Run(is_stopping); })
           : MakeReplay(*feed, options));
  std::cout << server.url() << std::endl;
  server.Run([&] { return stop.Arrived(); });
  return 0;
}

}  // namespace fallen
