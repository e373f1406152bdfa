// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/mqtt_connection.hpp"

#include <mosquitto.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace fallen {
namespace {

constexpr int kQos = 1;
constexpr int kKeepAlive_s = 15;

}  // namespace

/// Between the library, which is C, and the handlers: nothing thrown gets past.
struct MqttConnection::Callbacks {
  static MqttConnection& Self(void* object) { return *static_cast<MqttConnection*>(object); }

  template <class Handler, class... Arguments>
  static void Call(MqttConnection& self, const Handler& handler, Arguments&&... arguments) {
    try {
      if (handler) handler(std::forward<Arguments>(arguments)...);
    } catch (const std::exception& error) {
      self.refusal_ = error.what();
    }
  }
  static void OnConnect(mosquitto*, void* object, int code) {
    MqttConnection& self = Self(object);
    self.is_answered_ = true;
    if (code != 0) {
      self.refusal_ = mosquitto_connack_string(code);
      return;
    }
    Call(self, self.handlers_.on_connected);
  }
  static void OnSubscribe(mosquitto*, void* object, int message, int, const int*) {
    Call(Self(object), Self(object).handlers_.on_subscribed, message);
  }
  static void OnPublish(mosquitto*, void* object, int message) {
    Call(Self(object), Self(object).handlers_.on_delivered, message);
  }
  static void OnMessage(mosquitto*, void* object, const mosquitto_message* message) {
    const auto* payload = static_cast<const char*>(message->payload);
    Call(Self(object), Self(object).handlers_.on_message, std::string(message->topic),
         std::string(payload ? payload : "", static_cast<std::size_t>(message->payloadlen)),
         message->retain);
  }
  static void OnLog(mosquitto*, void* object, int level, const char* text) {
    if (level == MOSQ_LOG_ERR) Self(object).library_error_ = text;
  }
};

MqttConnection::MqttConnection(const MqttConfig& config, const std::string& password,
                               const std::string& client_id, const std::string& will_topic,
                               const std::string& will, Handlers handlers)
    : host_(config.host),
      port_(config.port),
      broker_(host_ + ":" + std::to_string(port_)),
      handlers_(std::move(handlers)) {
  const bool is_clean_session = false;
  client_ = mosquitto_new(client_id.c_str(), is_clean_session, this);
  if (!client_) throw std::runtime_error("mqtt: out of memory");
  mosquitto_connect_callback_set(client_, &Callbacks::OnConnect);
  mosquitto_subscribe_callback_set(client_, &Callbacks::OnSubscribe);
  mosquitto_publish_callback_set(client_, &Callbacks::OnPublish);
  mosquitto_message_callback_set(client_, &Callbacks::OnMessage);
  mosquitto_log_callback_set(client_, &Callbacks::OnLog);
  try {
    Require(mosquitto_will_set(client_, will_topic.c_str(), static_cast<int>(will.size()),
                               will.data(), kQos, true),
            "last will");
    if (!config.username.empty())
      Require(mosquitto_username_pw_set(client_, config.username.c_str(),
                                        password.empty() ? nullptr : password.c_str()),
              "username");
    if (config.tls && config.ca_file.empty())
      Require(mosquitto_int_option(client_, MOSQ_OPT_TLS_USE_OS_CERTS, 1), "TLS");
    if (config.tls && !config.ca_file.empty())
      Require(
          mosquitto_tls_set(client_, config.ca_file.c_str(), nullptr, nullptr, nullptr, nullptr),
          "ca_file " + config.ca_file);
    Connect();
  } catch (...) {
    mosquitto_destroy(client_);
    throw;
  }
}

MqttConnection::~MqttConnection() { mosquitto_destroy(client_); }

void MqttConnection::Fail(const std::string& why) const {
  throw std::runtime_error("mqtt: " + broker_ + ": " + why);
}

void MqttConnection::Require(int status, const std::string& what) {
  if (status == MOSQ_ERR_SUCCESS) return;
  const std::string why =
      status == MOSQ_ERR_ERRNO ? std::strerror(errno) : mosquitto_strerror(status);
  Fail(what + ": " + why);
}

void MqttConnection::Connect() {
  // An IPv4 address to come from leaves only such addresses to go to.
  const char* const from = is_ipv4_only_ ? "0.0.0.0" : nullptr;
  errno = 0;
  const int status =
      mosquitto_connect_bind_async(client_, host_.c_str(), port_, kKeepAlive_s, from);
  connect_error_ = errno;
  if (status != MOSQ_ERR_CONN_PENDING) Require(status, "connecting");
}

void MqttConnection::Loop(std::chrono::milliseconds timeout) {
  try {
    LoopOnce(timeout);
  } catch (const std::runtime_error&) {
    if (is_answered_ || is_ipv4_only_) throw;
    is_ipv4_only_ = true;
    library_error_.clear();
    Connect();
  }
}

void MqttConnection::LoopOnce(std::chrono::milliseconds timeout) {
  const int max_packets = 1;  // as the library wants it
  errno = 0;
  const int status = mosquitto_loop(client_, static_cast<int>(timeout.count()), max_packets);
  if (!refusal_.empty()) Fail(refusal_);
  if (status == MOSQ_ERR_SUCCESS) return RequireAlive();
  if (status == MOSQ_ERR_ERRNO && errno != 0 && library_error_.empty()) Fail(std::strerror(errno));
  Fail(std::string(mosquitto_strerror(status)) +
       (library_error_.empty() ? "" : " (" + library_error_ + ")"));
}

/// libmosquitto 2.0.11 goes on for ever, without a word, with a TLS connection that was refused.
void MqttConnection::RequireAlive() const {
  const int socket = mosquitto_socket(client_);
  if (socket < 0) Fail("connection lost");
  pollfd state{socket, 0, 0};
  if (poll(&state, 1, 0) == 0) return;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  if (error == 0 && connect_error_ != EINPROGRESS) error = connect_error_;
  Fail(error != 0 ? std::strerror(error) : "connection lost");
}

int MqttConnection::Publish(const std::string& topic, const std::string& payload) {
  int message = 0;
  Require(mosquitto_publish(client_, &message, topic.c_str(), static_cast<int>(payload.size()),
                            payload.data(), kQos, true),
          "publishing on " + topic);
  return message;
}

int MqttConnection::Subscribe(const std::vector<std::string>& topics) {
  std::vector<char*> names;
  for (const std::string& topic : topics) names.push_back(const_cast<char*>(topic.c_str()));
  int message = 0;
  Require(mosquitto_subscribe_multiple(client_, &message, static_cast<int>(names.size()),
                                       names.data(), kQos, 0, nullptr),
          "subscribing");
  return message;
}

void MqttConnection::Unsubscribe(const std::string& topic) {
  Require(mosquitto_unsubscribe(client_, nullptr, topic.c_str()), "unsubscribing");
}

void MqttConnection::Disconnect() { mosquitto_disconnect(client_); }

MqttLibrary::MqttLibrary() { mosquitto_lib_init(); }
MqttLibrary::~MqttLibrary() { mosquitto_lib_cleanup(); }

}  // namespace fallen
