// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/frame_pacer.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace fallen {
namespace {

using testing::ElementsAre;
using Clock = FramePacer::Clock;

/// A recording of `times` [us], and a clock that only moves when it is slept on or pushed.
struct Stage {
  explicit Stage(std::vector<std::int64_t> utimes) : times(std::move(utimes)) {}

  FramePacer::Source MakeSource() {
    return {[this]() -> std::optional<Frame> {
              if (next == times.size()) return std::nullopt;
              Frame frame;
              frame.utime = times[next++];
              return frame;
            },
            [this] { return now; }, [this](Clock::time_point time) { now = std::max(now, time); }};
  }

  std::vector<std::int64_t> times;
  std::size_t next = 0;
  Clock::time_point now{};
};

std::int64_t Milliseconds(Clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

TEST(FramePacer, PlaysAtTheRecordingsPace) {
  Stage stage({5'000'000, 5'100'000, 5'300'000});
  FramePacer pacer(stage.MakeSource());
  std::vector<std::int64_t> played_at;
  while (pacer.Next()) played_at.push_back(Milliseconds(stage.now));
  EXPECT_THAT(played_at, ElementsAre(0, 100, 300));
  EXPECT_EQ(pacer.dropped(), 0);
}

TEST(FramePacer, DropsWhatANewerFrameHasOvertaken) {
  Stage stage({0, 100'000, 200'000, 300'000, 400'000});
  FramePacer pacer(stage.MakeSource());
  std::vector<std::int64_t> played;
  while (const std::optional<Frame> frame = pacer.Next()) {
    played.push_back(frame->utime);
    stage.now += std::chrono::milliseconds(250);  // a slow detector
  }
  EXPECT_THAT(played, ElementsAre(0, 200'000, 400'000));
  EXPECT_EQ(pacer.dropped(), 2);
}

TEST(FramePacer, DoesNotWaitThroughGapsOrClocksThatRunBack) {
  Stage stage({0, 3'600'000'000, 10});
  FramePacer pacer(stage.MakeSource());
  int played = 0;
  while (pacer.Next()) ++played;
  EXPECT_EQ(played, 3);
  EXPECT_LT(Milliseconds(stage.now), 1000);
}

}  // namespace
}  // namespace fallen
