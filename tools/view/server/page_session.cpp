// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/page_session.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <nlohmann/json.hpp>
#include <utility>

namespace fallen {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

constexpr std::size_t kMaxIncomingBytes = 1024;  // wishes are short
/// Small, so that what waits in the system is not old when it arrives [bytes].
constexpr int kSendBuffer = 256 * 1024;

}  // namespace

PageSession::PageSession(beast::tcp_stream stream, Feed& feed, Acknowledge acknowledge)
    : socket_(std::move(stream)),
      feed_(feed),
      acknowledge_(std::move(acknowledge)),
      wake_(socket_.get_executor()) {
  // Pings tell a browser that went away from one that is busy.
  socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  socket_.read_message_max(kMaxIncomingBytes);
  boost::system::error_code ignored;
  socket_.next_layer().socket().set_option(asio::socket_base::send_buffer_size(kSendBuffer),
                                           ignored);
}

asio::awaitable<void> PageSession::Run(Request request) {
  const auto self = shared_from_this();
  boost::system::error_code error;
  socket_.next_layer().expires_never();  // the WebSocket has timeouts of its own
  co_await socket_.async_accept(request, asio::redirect_error(asio::use_awaitable, error));
  if (error) co_return;
  asio::co_spawn(
      socket_.get_executor(), [self] { return self->Write(); }, asio::detached);
  co_await Read();
  is_open_ = false;
  Wake();
}

asio::awaitable<void> PageSession::Read() {
  while (is_open_) {
    beast::flat_buffer buffer;
    boost::system::error_code error;
    co_await socket_.async_read(buffer, asio::redirect_error(asio::use_awaitable, error));
    if (error) co_return;
    Take(beast::buffers_to_string(buffer.data()));
    Wake();
  }
}

asio::awaitable<void> PageSession::Write() {
  const auto self = shared_from_this();
  boost::system::error_code error;
  while (is_open_) {
    const Feed::Message message = NextMessage();
    if (!message.bytes) {
      wake_.expires_at(asio::steady_timer::time_point::max());
      co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, error));
      continue;
    }
    socket_.text(message.is_text);
    co_await socket_.async_write(asio::buffer(*message.bytes),
                                 asio::redirect_error(asio::use_awaitable, error));
    if (error) is_open_ = false;
  }
}

void PageSession::Wake() { wake_.cancel(); }

Feed::Message PageSession::NextMessage() {
  if (const Feed::Topic topic = feed_.NextTopic(topics_sent_); topic.message.bytes) {
    topics_sent_ = topic.version;
    return topic.message;
  }
  if (const Feed::Message timeline = feed_.TimelineSince(timeline_sent_); timeline.bytes)
    return timeline;
  return NextFrame();
}

Feed::Message PageSession::NextFrame() {
  const std::int64_t count = feed_.frames().count;
  if (count == 0) return {};
  if (wanted_frame_) return feed_.Frame(*std::exchange(wanted_frame_, std::nullopt));
  if (!wants_newest_ || newest_sent_ == count - 1) return {};
  wants_newest_ = false;
  newest_sent_ = count - 1;
  return feed_.Frame(newest_sent_);
}

void PageSession::Take(const std::string& text) {
  const nlohmann::json wish = nlohmann::json::parse(text, nullptr, false);
  if (!wish.is_object()) return;
  if (const auto id = wish.find("acknowledge"); id != wish.end() && id->is_string()) {
    if (const auto event_id = id->get<std::string>(); !event_id.empty() && acknowledge_)
      acknowledge_(event_id);
  }
  if (!wish.contains("want")) return;
  const nlohmann::json& want = wish["want"];
  wants_newest_ = want == "newest";
  wanted_frame_.reset();
  if (want.is_number_integer()) wanted_frame_ = want.get<std::int64_t>();
}

}  // namespace fallen
