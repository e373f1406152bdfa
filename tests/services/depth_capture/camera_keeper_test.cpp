// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/camera_keeper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <stdexcept>
#include <vector>

namespace fallen {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What a scripted camera does when it is read.
enum class Does { kDelivers, kNothing, kVanishes, kBreaks };

class ScriptedCamera : public Camera {
 public:
  explicit ScriptedCamera(std::deque<Does>& script) : script_(script) {}

  std::optional<CameraFrame> Read(milliseconds) override {
    const Does does = script_.empty() ? Does::kNothing : script_.front();
    if (!script_.empty()) script_.pop_front();
    if (does == Does::kVanishes) throw CameraUnavailable("pulled out");
    if (does == Does::kBreaks) throw std::runtime_error("broken");
    if (does == Does::kNothing) return std::nullopt;
    return CameraFrame{};
  }
  std::string description() const override { return "scripted"; }

 private:
  std::deque<Does>& script_;
};

class CameraKeeperTest : public ::testing::Test {
 protected:
  static constexpr KeeperOptions kOptions{milliseconds(1000), milliseconds(500),
                                          milliseconds(3000)};

  /// Reads at `at_ms` on the test's clock.
  bool ReadAt(int at_ms) {
    return keeper_.Read(CameraKeeper::Clock::time_point(milliseconds(at_ms)), milliseconds(10))
        .has_value();
  }

  std::deque<Does> script_;
  bool is_there_ = true;
  std::vector<int> attempts_;
  CameraKeeper keeper_{[this](int attempt) -> std::unique_ptr<Camera> {
                         attempts_.push_back(attempt);
                         if (!is_there_) throw CameraUnavailable("not there");
                         return std::make_unique<ScriptedCamera>(script_);
                       },
                       kOptions};
};

TEST_F(CameraKeeperTest, OpensAtOnceAndReads) {
  script_ = {Does::kDelivers, Does::kNothing, Does::kDelivers};
  EXPECT_FALSE(keeper_.is_open());
  EXPECT_TRUE(ReadAt(1));
  EXPECT_TRUE(keeper_.is_open());
  EXPECT_EQ(keeper_.text(), "scripted");
  EXPECT_FALSE(ReadAt(20));
  EXPECT_TRUE(ReadAt(30));
  EXPECT_EQ(keeper_.connections(), 1);
}

TEST_F(CameraKeeperTest, TriesAgainAfterPausesThatDoubleUpToTheLongest) {
  is_there_ = false;
  std::vector<int> tried_at_ms;
  for (int at_ms = 0; at_ms <= 12000; at_ms += 100) {
    const std::size_t before = attempts_.size();
    EXPECT_FALSE(ReadAt(at_ms));
    if (attempts_.size() > before) tried_at_ms.push_back(at_ms);
  }
  // Pauses 500, 1000, 2000, then 3000 each.
  EXPECT_THAT(tried_at_ms, ElementsAre(0, 500, 1500, 3500, 6500, 9500));
  EXPECT_THAT(attempts_, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(keeper_.text(), HasSubstr("not there; tried again in 3.0 s"));
}

TEST_F(CameraKeeperTest, GoesOnWhenTheCameraComesBackAndStartsOverWithItsPauses) {
  script_ = {Does::kDelivers, Does::kVanishes};
  EXPECT_TRUE(ReadAt(0));
  EXPECT_FALSE(ReadAt(100));
  EXPECT_FALSE(keeper_.is_open());
  EXPECT_THAT(keeper_.text(), HasSubstr("pulled out"));
  EXPECT_EQ(keeper_.retry_at(), CameraKeeper::Clock::time_point(milliseconds(600)));
  script_ = {Does::kDelivers, Does::kVanishes};
  EXPECT_FALSE(ReadAt(599));
  EXPECT_TRUE(ReadAt(600));
  EXPECT_EQ(keeper_.connections(), 2);
  EXPECT_FALSE(ReadAt(700));
  EXPECT_EQ(keeper_.retry_at(), CameraKeeper::Clock::time_point(milliseconds(1200)));
  EXPECT_THAT(attempts_, ElementsAre(1, 1));
}

TEST_F(CameraKeeperTest, LosesACameraThatIsSilentForTooLong) {
  script_ = {Does::kDelivers};
  EXPECT_TRUE(ReadAt(0));
  EXPECT_FALSE(ReadAt(1000));
  EXPECT_TRUE(keeper_.is_open());
  EXPECT_FALSE(ReadAt(1001));
  EXPECT_FALSE(keeper_.is_open());
  EXPECT_THAT(keeper_.text(), HasSubstr("sent nothing for 1.0 s"));
}

TEST_F(CameraKeeperTest, DoesNotHammerACameraThatOpensButNeverDelivers) {
  std::vector<int> tried_at_ms;
  for (int at_ms = 0; at_ms <= 12000; at_ms += 100) {
    const std::size_t before = attempts_.size();
    EXPECT_FALSE(ReadAt(at_ms));
    if (attempts_.size() > before) tried_at_ms.push_back(at_ms);
  }
  // 1.1 s until it counts as lost each time, and the growing pause.
  EXPECT_THAT(tried_at_ms, ElementsAre(0, 1600, 3700, 6800, 10900));
}

TEST_F(CameraKeeperTest, PassesOnWhatTryingAgainCannotMend) {
  script_ = {Does::kBreaks};
  EXPECT_THROW(ReadAt(0), std::runtime_error);
  CameraKeeper keeper([](int) -> std::unique_ptr<Camera> { throw std::runtime_error("mode"); },
                      kOptions);
  EXPECT_THROW(keeper.OpenIfDue(CameraKeeper::Clock::time_point()), std::runtime_error);
}

}  // namespace
}  // namespace fallen
