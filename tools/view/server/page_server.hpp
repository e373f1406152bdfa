// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/view/feed/feed.hpp"
#include "tools/view/server/access.hpp"
#include "tools/view/server/page_files.hpp"

namespace fallen {

struct PageServerOptions {
  std::string address = "127.0.0.1";
  unsigned short port = 8765;        ///< 0: any that is free
  std::optional<std::string> token;  ///< see AccessRules
  /// Somebody at a browser takes notice of an alarm; nothing where nobody can be told.
  std::function<void(const std::string& event_id)> acknowledge;
};

/// Serves the page by HTTP, and a feed to each browser by WebSocket (at /feed).
///
/// Over the WebSocket the server sends topics and the timeline as they change, and frames only as
/// they are asked for: {"want": "newest"} for the next one that is new to this browser, {"want": n}
/// for a certain one. {"acknowledge": "<event id>"} answers an alarm. One message is on its way at
/// a time and the next is chosen when it has gone, so that a slow browser skips frames, and one
/// that stops reading costs one message and nothing else.
class PageServer {
 public:
  /// Opens the port. @param feed, files  Must outlive this.
  /// @throws std::runtime_error naming address and port if they cannot be had.
  PageServer(Feed& feed, const PageFiles& files, const PageServerOptions& options);
  ~PageServer();

  /// What to type into a browser, with the token.
  std::string url() const;

  /// Serves in this thread until `stop_arrived`, which is asked often, says so.
  void Run(const std::function<bool()>& stop_arrived);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fallen
