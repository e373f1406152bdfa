// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a second worker of a stage is worth: frames are fed as fast as the workers answer. Measured
// by hand, as chain_figures.cpp.
#include <gmock/gmock.h>

#include <deque>
#include <lcm/lcm-cpp.hpp>
#include <thread>

#include "fallen/detection/map_update.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/messages/log_format.hpp"
#include "tests/integration/figure_inputs.hpp"
#include "tests/integration/private_network.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen::testing_support {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaps = 30;
// Frames on their way to a worker and back: one that is worked on, one that waits, one on the wire.
constexpr int kInFlightPerWorker = 3;
constexpr milliseconds kStart{2000};
constexpr milliseconds kWarmUp{2000};
constexpr std::chrono::seconds kMeasured{10};
constexpr double kMinSpeedUp = 1.8;
constexpr std::size_t kSeqOffset = 16;  // hash and utime are before it

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> ForegroundMessages() {
  const BenchSequence sequence = LargeImages(kMaps);
  NdtMapper mapper{NdtConfig{}};
  BackgroundSubtractor nothing_known{BackgroundConfig{}};
  std::vector<Bytes> messages;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const ForegroundMap map =
        nothing_known.Subtract(UpdateMap(mapper, sequence[i], GroundConfig{}));
    cells += map.map.cells.size();
    messages.push_back(EncodeMessage(ToMessage(Header{0, 0, "CAMERA"}, map)));
  }
  std::printf("%zu maps of %s, %zu cells each\n", messages.size(), sequence.source().c_str(),
              cells / messages.size());
  return messages;
}

/// Sends the messages over and over, so that always as many are on their way.
class Feeder {
 public:
  Feeder(const std::string& url, std::vector<Bytes> messages)
      : lcm_(url), messages_(std::move(messages)) {
    lcm_.subscribe("CLUSTERS_CAMERA", &Feeder::Receive, this)->setQueueCapacity(0);
  }

  void Feed(int in_flight, Clock::duration time) {
    for (const auto end = Clock::now() + time; Clock::now() < end; lcm_.handleTimeout(100))
      while (sent_ - answered_ < in_flight) Send();
  }
  void Finish() {
    while (answered_ < sent_ && lcm_.handleTimeout(1000) > 0) {
    }
  }
  std::int64_t sent() const { return sent_; }
  std::int64_t answered() const { return answered_; }

 private:
  void Receive(const lcm::ReceiveBuffer*, const std::string&) { ++answered_; }

  void Send() {
    Bytes& bytes = messages_[static_cast<std::size_t>(sent_) % messages_.size()];
    log_format::WriteBigEndian(static_cast<std::uint64_t>(sent_), bytes.data() + kSeqOffset);
    lcm_.publish("FOREGROUND_CAMERA", bytes.data(), static_cast<unsigned>(bytes.size()));
    ++sent_;
  }

  lcm::LCM lcm_;
  std::vector<Bytes> messages_;
  std::int64_t sent_ = 0;
  std::int64_t answered_ = 0;
};

/// Frames a second that so many workers of cell segmentation handle.
double FramesPerSecond(int workers, const std::vector<Bytes>& messages) {
  const std::string url = EnterPrivateNetwork();
  const TemporaryFolder folder;
  std::deque<ChildProcess> processes;
  for (int k = 0; k < workers; ++k)
    processes.emplace_back(
        std::vector<std::string>{Program("fallen-cell-segmentation"), "--lossless", "--lcm-url",
                                 url, "--worker",
                                 std::to_string(k) + "/" + std::to_string(workers)},
        folder.path());
  std::this_thread::sleep_for(kStart);
  Feeder feeder(url, messages);
  feeder.Feed(kInFlightPerWorker * workers, kWarmUp);
  const std::int64_t before = feeder.answered();
  const auto begin = Clock::now();
  feeder.Feed(kInFlightPerWorker * workers, kMeasured);
  const std::chrono::duration<double> time = Clock::now() - begin;
  const double rate = static_cast<double>(feeder.answered() - before) / time.count();
  feeder.Finish();
  EXPECT_EQ(feeder.answered(), feeder.sent());
  for (ChildProcess& process : processes) EXPECT_EQ(process.Stop(), 0) << process.StandardError();
  std::printf("%d workers: %.1f frames a second\n", workers, rate);
  return rate;
}

TEST(WorkerFigures, SecondWorkerOfSegmentationNearlyDoublesTheRate) {
  const std::vector<Bytes> messages = ForegroundMessages();
  const double one = FramesPerSecond(1, messages);
  const double two = FramesPerSecond(2, messages);
  std::printf("two workers handle %.2f times as many\n", two / one);
  EXPECT_GE(two, kMinSpeedUp * one);
}

}  // namespace
}  // namespace fallen::testing_support
