// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <exception>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service_status_t.hpp"
#include "lap_times.hpp"

namespace fallen {
namespace {

constexpr int kTransferTimeout_ms = 1000;

// A port of this process, so that no service hears the benchmark.
std::string OwnUrl() {
  return "udpm://239.255.76.67:" + std::to_string(10000 + getpid() % 20000) +
         "?ttl=0&recv_buf_size=4194304";
}

// What the services would send about the frames of a sequence.
struct Traffic {
  std::vector<Header> headers;
  std::vector<StampedDepthImage> images;
  std::vector<StampedPose> poses;
  std::vector<FrameResult> results;
};

Traffic Detected(BenchSequence& sequence, const DetectorOptions& options) {
  Detector detector = MakeDetector(options);
  Traffic traffic;
  for (std::size_t step = 0; step < sequence.size(); ++step) {
    const Frame& frame = sequence.At(step);
    const Eigen::Isometry3d pose =
        frame.T_world_robot.value_or(Eigen::Isometry3d(Eigen::Isometry3d::Identity()));
    traffic.headers.push_back({frame.utime, static_cast<std::int64_t>(step), "CAMERA"});
    traffic.images.push_back({traffic.headers.back(), frame.image, frame.T_robot_camera});
    traffic.poses.push_back({frame.utime, pose.translation(), Eigen::Quaterniond(pose.linear())});
    traffic.results.push_back(detector.Detect(frame));
  }
  return traffic;
}

NumberedAlarm SomeAlarm() {
  NumberedAlarm alarm{"robot", 7, {}};
  alarm.alarm.id = "robot-1700000000000000-3";
  alarm.alarm.camera = "CAMERA";
  alarm.alarm.box.size = {1.7, 0.6, 0.3};
  alarm.alarm.raised_utime = alarm.alarm.change_utime = 1'700'000'000'000'000;
  return alarm;
}

service_status_t SomeStatus() {
  service_status_t status{};
  status.header.sensor_name = "CAMERA";
  status.service = "background-subtraction";
  status.version = "1.0.0";
  status.text = "no environment map: everything is foreground";
  return status;
}

// A way to make the message about frame i, and to make a value of it again.
template <class Message>
struct Conversion {
  std::string name;
  std::function<Message(const Traffic&, std::size_t)> to_message;
  std::function<void(const Message&)> from_message;
};

double Milliseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

template <class Message>
std::vector<std::vector<std::uint8_t>> Encoded(const Traffic& traffic,
                                               const Conversion<Message>& conversion) {
  std::vector<std::vector<std::uint8_t>> messages;
  for (std::size_t i = 0; i < traffic.headers.size(); ++i)
    messages.push_back(EncodeMessage(conversion.to_message(traffic, i)));
  return messages;
}

template <class Message>
void RunEncode(benchmark::State& state, const Traffic& traffic,
               const Conversion<Message>& conversion) {
  LapTimes all, conversion_only, bytes;
  std::size_t step = 0;
  for (auto _ : state) {
    const std::size_t i = step++ % traffic.headers.size();
    conversion_only.Start();
    all.Start();
    const Message message = conversion.to_message(traffic, i);
    conversion_only.Stop();
    const std::vector<std::uint8_t> encoded = EncodeMessage(message);
    all.Stop();
    bytes.Add(static_cast<double>(encoded.size()));
  }
  all.Report(state);
  state.counters["conversion_ms"] = conversion_only.Median();
  state.counters["bytes"] = bytes.Median();
}

template <class Message>
void RunDecode(benchmark::State& state, const Traffic& traffic,
               const Conversion<Message>& conversion) {
  const auto messages = Encoded(traffic, conversion);
  LapTimes all, conversion_only;
  std::size_t step = 0;
  for (auto _ : state) {
    all.Start();
    const auto decoded = DecodeMessage<Message>(messages[step++ % messages.size()]);
    conversion_only.Start();
    conversion.from_message(*decoded.message);
    conversion_only.Stop();
    all.Stop();
  }
  all.Report(state);
  state.counters["conversion_ms"] = conversion_only.Median();
}

struct Arrival {
  void Receive(const lcm::ReceiveBuffer*, const std::string&) {}
};

// From publish() to the handler, over the loopback; on the clock on the wall, and what all threads
// of this process and the kernel for them work meanwhile.
template <class Message>
void RunTransfer(benchmark::State& state, const Traffic& traffic,
                 const Conversion<Message>& conversion) {
  lcm::LCM lcm(OwnUrl());
  if (!lcm.good() || lcm.getFileno() < 0)
    return state.SkipWithError("LCM cannot be opened: no multicast route");
  Arrival arrival;
  lcm.subscribe("BENCH", &Arrival::Receive, &arrival);
  const auto messages = Encoded(traffic, conversion);
  LapTimes wall, work;
  std::size_t step = 0;
  for (auto _ : state) {
    const std::vector<std::uint8_t>& bytes = messages[step++ % messages.size()];
    const double begin = Milliseconds(CLOCK_MONOTONIC);
    const double begin_work = Milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    lcm.publish("BENCH", bytes.data(), static_cast<unsigned>(bytes.size()));
    if (lcm.handleTimeout(kTransferTimeout_ms) <= 0)
      return state.SkipWithError("a message was lost");
    wall.Add(Milliseconds(CLOCK_MONOTONIC) - begin);
    work.Add(Milliseconds(CLOCK_PROCESS_CPUTIME_ID) - begin_work);
  }
  wall.Report(state);
  state.counters["work_ms"] = work.Median();
}

class Registrar {
 public:
  Registrar(std::shared_ptr<BenchSequence> sequence, DetectorOptions options)
      : sequence_(std::move(sequence)),
        options_(std::move(options)),
        traffic_(std::make_shared<Traffic>()) {}

  template <class Message>
  void Add(const Conversion<Message>& conversion) const {
    Add("Encode", conversion, RunEncode<Message>);
    Add("Transfer", conversion, RunTransfer<Message>);
    Add("Decode", conversion, RunDecode<Message>);
  }

 private:
  template <class Message>
  void Add(const std::string& what, const Conversion<Message>& conversion,
           void (*run)(benchmark::State&, const Traffic&, const Conversion<Message>&)) const {
    const std::string name = what + "/" + conversion.name + "/" + sequence_->size_name();
    benchmark::RegisterBenchmark(name.c_str(), [=, *this](benchmark::State& state) {
      try {
        if (traffic_->headers.empty()) *traffic_ = Detected(*sequence_, options_);
      } catch (const std::exception& error) {
        return state.SkipWithError(error.what());
      }
      run(state, *traffic_, conversion);
      state.SetLabel(sequence_->source());
    })->Unit(benchmark::kMicrosecond);
  }

  std::shared_ptr<BenchSequence> sequence_;
  DetectorOptions options_;
  std::shared_ptr<Traffic> traffic_;  // made when it is first needed
};

}  // namespace

void RegisterTransportBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                                 const DetectorOptions& options) {
  const Registrar registrar(sequence, options);
  const auto from_message = [](const auto& message) { FromMessage(message); };
  registrar.Add<depth_image_t>(
      {"depth_image_t", [](const Traffic& t, std::size_t i) { return ToMessage(t.images[i]); },
       from_message});
  registrar.Add<pose_t>({"pose_t",
                         [](const Traffic& t, std::size_t i) { return ToMessage(t.poses[i]); },
                         from_message});
  registrar.Add<ndt_map_t>({"ndt_map_t",
                            [](const Traffic& t, std::size_t i) {
                              return ToMessage(t.headers[i], t.results[i].foreground);
                            },
                            ForegroundFromMessage});
  registrar.Add<clusters_t>({"clusters_t",
                             [](const Traffic& t, std::size_t i) {
                               return ToMessage(t.headers[i], t.results[i].segmented);
                             },
                             from_message});
  registrar.Add<fallen_persons_t>({"fallen_persons_t",
                                   [](const Traffic& t, std::size_t i) {
                                     return ToMessage(t.headers[i], t.results[i].decision);
                                   },
                                   from_message});
  registrar.Add<fall_alarm_t>({"fall_alarm_t",
                               [](const Traffic&, std::size_t) { return ToMessage(SomeAlarm()); },
                               from_message});
  registrar.Add<fall_alarm_ack_t>(
      {"fall_alarm_ack_t",
       [](const Traffic&, std::size_t) {
         return ToMessage(AlarmAnswer{1'700'000'000'000'000, SomeAlarm().alarm.id, "page", false});
       },
       from_message});
  registrar.Add<service_status_t>(
      {"service_status_t", [](const Traffic&, std::size_t) { return SomeStatus(); },
       [](const service_status_t& message) { FromMessage(message.header); }});
}

}  // namespace fallen
