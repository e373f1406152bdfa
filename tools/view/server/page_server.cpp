// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/page_server.hpp"

#include <atomic>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fallen/service/logging.hpp"
#include "tools/view/server/page_session.hpp"

namespace fallen {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using tcp = asio::ip::tcp;
using Request = PageSession::Request;
using Response = http::response<http::string_body>;

constexpr std::chrono::milliseconds kStopPoll{100};
constexpr std::chrono::seconds kRequestTimeout{30};
constexpr int kMaxConnections = 64;  // of all browsers together

std::string_view View(beast::string_view text) { return {text.data(), text.size()}; }

Response Answer(const Request& request, http::status status, const std::string& type,
                const std::string& body) {
  Response response(status, request.version(), body);
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-cache");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");  // addresses hold the token
  response.set("Content-Security-Policy",
               "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
               "img-src 'self' data: blob:; connect-src 'self'; base-uri 'none'; "
               "form-action 'none'; frame-ancestors 'none'");
  response.keep_alive(request.keep_alive());
  response.prepare_payload();
  if (request.method() == http::verb::head) response.body().clear();
  return response;
}

Response TextAnswer(const Request& request, http::status status, const std::string& line) {
  return Answer(request, status, "text/plain; charset=utf-8", "fallen-view: " + line + "\n");
}

tcp::endpoint Endpoint(const PageServerOptions& options) {
  boost::system::error_code error;
  const asio::ip::address address = asio::ip::make_address(options.address, error);
  if (error)
    throw std::runtime_error("--address: got " + options.address +
                             ", expected a numeric address, e.g. 127.0.0.1 or 0.0.0.0");
  return {address, options.port};
}

tcp::acceptor Listen(asio::io_context& context, const PageServerOptions& options) {
  const tcp::endpoint endpoint = Endpoint(options);
  try {
    return tcp::acceptor(context, endpoint);
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(options.address + " port " + std::to_string(options.port) + ": " +
                             error.code().message() + "; choose another with --port");
  }
}

}  // namespace

struct PageServer::State {
  State(Feed& shown, const PageFiles& page, const PageServerOptions& wanted)
      : feed(shown),
        files(page),
        options(wanted),
        acceptor(Listen(context, wanted)),
        rules{wanted.token, acceptor.local_endpoint().port()} {}

  asio::awaitable<void> Accept();
  asio::awaitable<void> Serve(tcp::socket socket);
  asio::awaitable<void> ServeRequests(beast::tcp_stream& stream);
  asio::awaitable<void> ServeFeed(beast::tcp_stream& stream, Request request);
  Response Respond(const Request& request, const AccessVerdict& verdict) const;
  void WakeSessions();

  Feed& feed;
  const PageFiles& files;
  const PageServerOptions options;
  asio::io_context context;
  tcp::acceptor acceptor;
  const AccessRules rules;
  int connections = 0;
  std::vector<std::weak_ptr<PageSession>> sessions;
  std::atomic<bool> is_wake_posted = false;
  RepeatedWarnings warnings;
};

asio::awaitable<void> PageServer::State::Accept() {
  while (true) {
    boost::system::error_code error;
    tcp::socket socket =
        co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, error));
    if (error) {  // no descriptors left, say: not to be asked for again at once
      asio::steady_timer pause(context, kStopPoll);
      co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
      continue;
    }
    if (connections >= kMaxConnections) continue;  // a socket that goes away is closed
    asio::co_spawn(context, Serve(std::move(socket)), asio::detached);
  }
}

asio::awaitable<void> PageServer::State::Serve(tcp::socket socket) {
  ++connections;
  try {
    beast::tcp_stream stream(std::move(socket));
    co_await ServeRequests(stream);
  } catch (const std::exception&) {
    // The browser has gone, or sent something that is no request.
  }
  --connections;
}

asio::awaitable<void> PageServer::State::ServeRequests(beast::tcp_stream& stream) {
  beast::flat_buffer buffer;
  while (true) {
    Request request;
    stream.expires_after(kRequestTimeout);
    co_await http::async_read(stream, buffer, request, asio::use_awaitable);
    const AccessVerdict verdict =
        Judge({View(request.target()), View(request[http::field::host]),
               View(request[http::field::origin]), View(request[http::field::cookie])},
              rules);
    const std::string_view target = View(request.target());
    const bool is_feed =
        target.substr(0, target.find('?')) == "/feed" && beast::websocket::is_upgrade(request);
    if (is_feed && verdict.is_allowed) {
      co_await ServeFeed(stream, std::move(request));
      co_return;
    }
    Response response = Respond(request, verdict);
    if (!verdict.is_allowed) {
      boost::system::error_code ignored;
      warnings.Warn("refused", "refused " +
                                   stream.socket().remote_endpoint(ignored).address().to_string() +
                                   ": " + verdict.reason);
    }
    co_await http::async_write(stream, response, asio::use_awaitable);
    if (response.need_eof()) co_return;
  }
}

asio::awaitable<void> PageServer::State::ServeFeed(beast::tcp_stream& stream, Request request) {
  const auto session = std::make_shared<PageSession>(std::move(stream), feed, options.acknowledge);
  std::erase_if(sessions, [](const auto& known) { return known.expired(); });
  sessions.push_back(session);
  co_await session->Run(std::move(request));
}

Response PageServer::State::Respond(const Request& request, const AccessVerdict& verdict) const {
  if (!verdict.is_allowed)
    return TextAnswer(request, rules.token ? http::status::unauthorized : http::status::forbidden,
                      verdict.reason);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return TextAnswer(request, http::status::method_not_allowed, "expected GET");
  const std::string_view target = View(request.target());
  const std::string path(target.substr(0, target.find('?')));
  const PageFiles::File* file = files.Find(path);
  if (!file) return TextAnswer(request, http::status::not_found, path + ": no such page");
  Response response = Answer(request, http::status::ok, file->type, file->content);
  if (!verdict.set_cookie.empty()) response.set(http::field::set_cookie, verdict.set_cookie);
  return response;
}

void PageServer::State::WakeSessions() {
  is_wake_posted = false;
  for (const auto& known : sessions)
    if (const auto session = known.lock()) session->Wake();
}

PageServer::PageServer(Feed& feed, const PageFiles& files, const PageServerOptions& options)
    : state_(std::make_unique<State>(feed, files, options)) {
  feed.OnChange([state = state_.get()] {
    if (!state->is_wake_posted.exchange(true))
      asio::post(state->context, [state] { state->WakeSessions(); });
  });
  asio::co_spawn(state_->context, state_->Accept(), asio::detached);
}

PageServer::~PageServer() { state_->feed.OnChange({}); }

std::string PageServer::url() const {
  const bool is_v6 = state_->acceptor.local_endpoint().address().is_v6();
  const std::string host = is_v6 ? "[" + state_->options.address + "]" : state_->options.address;
  const std::string query = state_->rules.token ? "?token=" + *state_->rules.token : "";
  return "http://" + host + ":" + std::to_string(state_->rules.port) + "/" + query;
}

void PageServer::Run(const std::function<bool()>& stop_arrived) {
  while (!stop_arrived()) state_->context.run_for(kStopPoll);
}

}  // namespace fallen
