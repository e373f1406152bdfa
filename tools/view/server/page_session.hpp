// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/view/feed/feed.hpp"

namespace fallen {

/// One browser's WebSocket: tells it what it does not know yet, at its pace.
class PageSession : public std::enable_shared_from_this<PageSession> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::string_body>;

  using Acknowledge = std::function<void(const std::string& event_id)>;

  /// @param feed         Must outlive this.
  /// @param acknowledge  Is told of alarms that somebody takes notice of; may be empty.
  PageSession(boost::beast::tcp_stream stream, Feed& feed, Acknowledge acknowledge);

  /// Accepts the upgrade and runs until the browser leaves. Throws nothing.
  boost::asio::awaitable<void> Run(Request request);

  /// Something in the feed has changed.
  void Wake();

 private:
  boost::asio::awaitable<void> Read();
  boost::asio::awaitable<void> Write();
  Feed::Message NextMessage();
  Feed::Message NextFrame();
  void Take(const std::string& text);

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  Feed& feed_;
  Acknowledge acknowledge_;
  boost::asio::steady_timer wake_;
  bool is_open_ = true;

  // What the browser has, and what it wants.
  std::int64_t topics_sent_ = 0;
  std::int64_t timeline_sent_ = 0;
  std::int64_t newest_sent_ = -1;
  bool wants_newest_ = false;
  std::optional<std::int64_t> wanted_frame_;
};

}  // namespace fallen
