// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <set>

#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/service/channels.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/common/tool.hpp"
#include "tools/listen/decision_tally.hpp"

namespace {

using namespace fallen;
using Clock = std::chrono::steady_clock;

struct Options {
  std::optional<std::filesystem::path> config;
  std::optional<std::string> lcm_url;
  std::optional<std::string> camera;
  std::vector<std::string> services;
  double idle_seconds = 3;
  double timeout_seconds = 60;
  bool require_person = false;
};

std::span<const std::uint8_t> Bytes(const lcm::ReceiveBuffer* buffer) {
  return {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size};
}

// Everything that arrives. Nothing thrown leaves a handler: LCM calls them from C.
class Listener {
 public:
  Listener(lcm::LCM& lcm, const std::string& camera) {
    lcm.subscribe(channels::Depth(camera), &Listener::OnDepth, this);
    lcm.subscribe(channels::FallenPersons(camera), &Listener::OnPersons, this);
    lcm.subscribe(channels::kFallAlarm, &Listener::OnAlarm, this);
    lcm.subscribe("STATUS_.*", &Listener::OnStatus, this);
  }

  const DecisionTally& tally() const { return tally_; }
  const std::set<std::string>& status_channels() const { return status_channels_; }
  Clock::time_point last_arrival() const { return last_arrival_; }

 private:
  void OnDepth(const lcm::ReceiveBuffer* buffer, const std::string&) noexcept {
    last_arrival_ = Clock::now();
    const Decoded<depth_image_t> decoded = DecodeMessage<depth_image_t>(Bytes(buffer));
    if (!decoded) return tally_.AddDamaged();
    tally_.AddFrame(FromMessage(decoded.message->header));
    if (!first_utime_) first_utime_ = decoded.message->header.utime;
  }

  void OnPersons(const lcm::ReceiveBuffer* buffer, const std::string&) noexcept {
    last_arrival_ = Clock::now();
    const Decoded<fallen_persons_t> decoded = DecodeMessage<fallen_persons_t>(Bytes(buffer));
    if (!decoded) return tally_.AddDamaged();
    try {
      const Header header = FromMessage(decoded.message->header);
      const Decision decision = FromMessage(*decoded.message);
      tally_.AddDecision(header, decision);
      const std::string line =
          DescribeDecision(header, decision, first_utime_.value_or(header.utime));
      if (!line.empty()) std::cout << line << std::endl;
    } catch (const std::exception&) {
      tally_.AddDamaged();
    }
  }

  // Repetitions say nothing new: they neither print nor keep the listener waiting.
  void OnAlarm(const lcm::ReceiveBuffer* buffer, const std::string&) noexcept {
    const Decoded<fall_alarm_t> decoded = DecodeMessage<fall_alarm_t>(Bytes(buffer));
    if (!decoded) return tally_.AddDamaged();
    try {
      const FallAlarm alarm = FromMessage(*decoded.message).alarm;
      if (!alarms_.emplace(alarm.id, alarm.revision).second) return;
      std::cout << DescribeAlarm(alarm, first_utime_.value_or(alarm.change_utime)) << std::endl;
    } catch (const std::exception&) {
      tally_.AddDamaged();
    }
  }

  void OnStatus(const lcm::ReceiveBuffer*, const std::string& channel) noexcept {
    status_channels_.insert(channel);
  }

  DecisionTally tally_;
  std::set<std::string> status_channels_;
  std::set<std::pair<std::string, std::int32_t>> alarms_;  // id and revision
  std::optional<std::int64_t> first_utime_;
  Clock::time_point last_arrival_ = Clock::now();
};

double SecondsSince(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

int WaitForServices(lcm::LCM& lcm, const Listener& listener, const Options& options) {
  const Clock::time_point start = Clock::now();
  std::string missing;
  do {
    lcm.handleTimeout(100);
    missing.clear();
    for (const std::string& service : options.services)
      if (!listener.status_channels().contains(channels::Status(service))) missing += " " + service;
    if (missing.empty()) return 0;
  } while (SecondsSince(start) < options.timeout_seconds);
  throw std::runtime_error("no status after " + std::to_string(options.timeout_seconds) +
                           " s from:" + missing);
}

int ListenUntilIdle(lcm::LCM& lcm, const Listener& listener, const Options& options) {
  const Clock::time_point start = Clock::now();
  while (true) {
    lcm.handleTimeout(100);
    const bool has_begun = listener.tally().frames() + listener.tally().decisions() > 0;
    if (has_begun && SecondsSince(listener.last_arrival()) > options.idle_seconds) break;
    if (!has_begun && SecondsSince(start) > options.timeout_seconds) break;
  }
  const DecisionTally& tally = listener.tally();
  std::cout << tally.Summary() << std::endl;
  if (tally.frames() == 0) throw std::runtime_error("no depth image arrived");
  if (options.require_person && tally.frames_with_person() == 0) return 1;
  return tally.lost() == 0 ? 0 : 1;
}

int Listen(const Options& options) {
  const Configuration config = LoadConfiguration(options.config);
  lcm::LCM lcm(options.lcm_url.value_or(config.service.lcm_url));
  if (!lcm.good())
    throw std::runtime_error(options.lcm_url.value_or(config.service.lcm_url) +
                             ": LCM cannot be opened, run fallen-doctor");
  const Listener listener(lcm, options.camera.value_or(config.service.camera));
  if (!options.services.empty()) return WaitForServices(lcm, listener, options);
  return ListenUntilIdle(lcm, listener, options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser = MakeToolParser(
      "fallen-listen",
      "Prints detections and alarms as they come, and at the end how many frames were "
      "decided. "
      "Exit status 1 if a frame was lost.");
  parser->add_option("--config", options.config, "Deployment (YAML)");
  parser->add_option("--lcm-url", options.lcm_url, "LCM URL");
  parser->add_option("--camera", options.camera, "Camera, as in the channel names");
  parser->add_option("--wait-for", options.services,
                     "Only wait until these services have said that they are there");
  parser->add_option("--idle-exit", options.idle_seconds, "End after so long without a message [s]")
      ->check(CLI::PositiveNumber);
  parser->add_option("--timeout", options.timeout_seconds, "Give up without any message [s]")
      ->check(CLI::PositiveNumber);
  parser->add_flag("--require-person", options.require_person,
                   "Exit status 1 if no fallen person was found, too");
  return RunTool(*parser, argc, argv, [&] { return Listen(options); });
}
