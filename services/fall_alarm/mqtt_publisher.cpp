// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/mqtt_publisher.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "services/fall_alarm/alarm_json.hpp"

namespace fallen {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// How soon a new change, and a request to stop, is seen.
constexpr milliseconds kPollInterval{50};
constexpr milliseconds kAnswerTimeout{10000};  // of a broker that is asked to connect
constexpr milliseconds kGoodbyeTimeout{2000};
constexpr milliseconds kFirstRetry{500};
constexpr milliseconds kLongestRetry{10000};
constexpr char kOnline[] = "online";
constexpr char kOffline[] = "offline";
constexpr char kAll[] = "all";

std::string FirstLine(const std::string& file) {
  if (file.empty()) return "";
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line))
    throw std::runtime_error(file + ": cannot be read, expected a password (mqtt.password_file)");
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

void RequireReadable(const std::string& file) {
  if (!file.empty() && !std::ifstream(file))
    throw std::runtime_error(file + ": cannot be read, expected certificates (mqtt.ca_file)");
}

/// "all", an event's id, or {"event_id": ..., "by": ...}; nothing for what is none of them.
std::optional<AlarmAnswer> ParseAnswer(const std::string& payload, bool closes) {
  AlarmAnswer answer{0, payload, "MQTT", closes};
  const nlohmann::json json = nlohmann::json::parse(payload, nullptr, false);
  if (json.is_object()) {
    const nlohmann::json id = json.value("event_id", nlohmann::json());
    const nlohmann::json by = json.value("by", nlohmann::json(answer.by));
    if (!id.is_string() || !by.is_string()) return std::nullopt;
    answer.event_id = id;
    answer.by = by;
  }
  if (answer.event_id.empty()) return std::nullopt;
  if (answer.event_id == kAll) answer.event_id.clear();
  return answer;
}

}  // namespace

/// What a connection knows: who waits for what.
class MqttPublisher::Session {
 public:
  explicit Session(MqttPublisher& owner)
      : owner_(owner),
        connection_(owner.config_, owner.password_, "fallen-" + owner.robot_,
                    owner.topics_.availability, kOffline,
                    {[this] { OnConnected(); }, [this](int message) { OnSubscribed(message); },
                     [this](int message) { OnDelivered(message); },
                     [this](const auto& topic, const auto& payload, bool is_retained) {
                       OnMessage(topic, payload, is_retained);
                     }}) {}

  bool is_ready() const { return is_ready_; }
  bool has_told_all() const { return !underway_ && !owner_.history_.FirstUnsent(); }

  void Loop() {
    connection_.Loop(kPollInterval);
    if (!is_ready_ && Clock::now() > begin_ + kAnswerTimeout)
      throw std::runtime_error("mqtt: " + owner_.config_.host + ": no answer within 10 s");
    if (is_ready_ && !underway_) TellNext();
  }

  void SayGoodbye() {
    const auto end = Clock::now() + kGoodbyeTimeout;
    while (!has_told_all() && Clock::now() < end) Loop();
    goodbye_ = connection_.Publish(owner_.topics_.availability, kOffline);
    while (goodbye_ && Clock::now() < end) connection_.Loop(kPollInterval);
    connection_.Disconnect();
  }

 private:
  void OnConnected() {
    // The answer to the second comes after what is retained for the first.
    connection_.Subscribe({owner_.topics_.event});
    last_subscription_ = connection_.Subscribe({owner_.topics_.acknowledge, owner_.topics_.close});
  }

  void OnSubscribed(int message) {
    if (message != last_subscription_) return;
    connection_.Unsubscribe(owner_.topics_.event);
    for (const MqttMessage& entity :
         HomeAssistantDiscovery(owner_.config_.discovery_prefix, owner_.robot_, owner_.topics_))
      connection_.Publish(entity.topic, entity.payload);
    TellState();
    connection_.Publish(owner_.topics_.availability, kOnline);
    is_ready_ = true;
    owner_.handlers_.on_state("");
  }

  void OnMessage(const std::string& topic, const std::string& payload, bool is_retained) {
    const MqttTopics& topics = owner_.topics_;
    if (topic == topics.event && is_retained) return NoteRetained(payload);
    // A retained command would be obeyed again with each connection.
    if (is_retained) return;
    if (topic != topics.acknowledge && topic != topics.close) return;
    if (const auto answer = ParseAnswer(payload, topic == topics.close))
      owner_.handlers_.on_answer(*answer);
  }

  /// The broker has this change and those before it, if it is one of ours.
  void NoteRetained(const std::string& payload) {
    const nlohmann::json json = nlohmann::json::parse(payload, nullptr, false);
    if (!json.is_object() || !json.contains("event_id") || !json["event_id"].is_string()) return;
    const auto changes = owner_.history_.Changes(json["event_id"].get<std::string>());
    for (const NumberedAlarm& change : changes)
      if (json == nlohmann::json::parse(JsonLine(AlarmJson(change))))
        owner_.history_.MarkSent(change.number);
  }

  void TellNext() {
    const auto change = owner_.history_.FirstUnsent();
    if (!change) return;
    underway_ = {connection_.Publish(owner_.topics_.event, JsonLine(AlarmJson(*change))),
                 change->number};
  }

  void OnDelivered(int message) {
    if (message == goodbye_) goodbye_.reset();
    if (!underway_ || underway_->message != message) return;
    owner_.history_.MarkSent(underway_->number);
    underway_.reset();
    TellState();
  }

  /// What is retained for those who come later: the state as the history has it now.
  void TellState() {
    const auto active = owner_.history_.Active();
    Tell(owner_.topics_.alarms, JsonLine(ActiveAlarmsJson(active)));
    Tell(owner_.topics_.alarm, active.empty() ? "OFF" : "ON");
  }

  void Tell(const std::string& topic, const std::string& payload) {
    std::string& told = told_[topic];
    if (told == payload) return;
    connection_.Publish(topic, payload);
    told = payload;
  }

  struct Underway {
    int message;
    std::int64_t number;
  };
  MqttPublisher& owner_;
  const Clock::time_point begin_ = Clock::now();
  bool is_ready_ = false;
  int last_subscription_ = 0;
  std::optional<Underway> underway_;
  std::optional<int> goodbye_;
  std::map<std::string, std::string> told_;
  MqttConnection connection_;
};

MqttPublisher::MqttPublisher(const MqttConfig& config, const std::string& robot,
                             AlarmHistory& history, Handlers handlers)
    : config_(config),
      robot_(robot),
      password_(FirstLine(config.password_file)),
      topics_(config.topic, robot),
      history_(history),
      handlers_(std::move(handlers)) {
  RequireReadable(config.ca_file);
  thread_ = std::thread([this] { Run(); });
}

MqttPublisher::~MqttPublisher() {
  is_stopping_ = true;
  thread_.join();
}

void MqttPublisher::Run() {
  retry_ = kFirstRetry;
  while (!is_stopping_) {
    try {
      Connect();
    } catch (const std::exception& error) {
      handlers_.on_state(error.what());
      if (!Wait(retry_)) return;
      retry_ = std::min(2 * retry_, kLongestRetry);
    }
  }
}

void MqttPublisher::Connect() {
  Session session(*this);
  while (!is_stopping_) {
    session.Loop();
    if (session.is_ready()) retry_ = kFirstRetry;
  }
  if (session.is_ready()) session.SayGoodbye();
}

/// @return false once it is to stop.
bool MqttPublisher::Wait(milliseconds time) const {
  for (milliseconds waited{0}; waited < time && !is_stopping_; waited += kPollInterval)
    std::this_thread::sleep_for(kPollInterval);
  return !is_stopping_;
}

}  // namespace fallen
