// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "services/depth_capture/oni_file.hpp"
#include "services/depth_capture/oni_index.hpp"
#include "services/depth_capture/openni_camera.hpp"
#include "services/depth_capture/openni_session.hpp"
#include "tests/services/depth_capture/virtual_camera_control.hpp"

namespace fallen {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using virtual_camera::PatternFrame;

constexpr DepthMode kSmall{320, 240, 60, DepthUnit::k1Mm};
constexpr DepthMode kLarge{640, 480, 30, DepthUnit::k1Mm};
constexpr DepthMode kFine{320, 240, 30, DepthUnit::k100Um};
/// Far longer than a frame takes on a busy machine.
constexpr std::chrono::milliseconds kPatience{5000};

CameraFrame ReadFrame(Camera& camera) {
  std::optional<CameraFrame> frame = camera.Read(kPatience);
  if (!frame) throw std::runtime_error("no frame came");
  return *std::move(frame);
}

template <class Function>
std::string MessageOf(Function function) {
  try {
    function();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(ListCamerasTest, TellsEveryCameraWithItsModes) {
  const test::VirtualCameraControl control;
  setenv(virtual_camera::kCountVariable, "2", 1);
  const OpenNiSession session;
  const std::vector<CameraInfo> cameras = ListCameras(session);
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_EQ(cameras[0].uri, "virtual://0");
  EXPECT_EQ(cameras[1].uri, "virtual://1");
  EXPECT_EQ(cameras[1].vendor, "Fallen");
  EXPECT_EQ(cameras[1].name, "Virtual camera 1");
  EXPECT_EQ(ToString(cameras[0].modes),
            "320x240 30 Hz 1mm, 320x240 60 Hz 1mm, 640x480 30 Hz 1mm, 320x240 30 Hz 100um, "
            "640x480 30 Hz 100um");
  EXPECT_EQ(cameras[0].problem, "");
}

TEST(ListCamerasTest, TellsOfACameraThatCannotBeOpened) {
  const test::VirtualCameraControl control("refusing");
  const OpenNiSession session;
  const std::vector<CameraInfo> cameras = ListCameras(session);
  ASSERT_EQ(cameras.size(), 1U);
  EXPECT_TRUE(cameras[0].modes.empty());
  EXPECT_NE(cameras[0].problem, "");
}

TEST(ListCamerasTest, IsEmptyWithoutCameras) {
  const test::VirtualCameraControl control("unplugged");
  const OpenNiSession session;
  EXPECT_TRUE(ListCameras(session).empty());
}

class OpenNiCameraModeTest : public ::testing::TestWithParam<DepthMode> {};

TEST_P(OpenNiCameraModeTest, DeliversFramesBitForBitUnmirrored) {
  const test::VirtualCameraControl control;
  const DepthMode mode = GetParam();
  OpenNiCamera camera("virtual://0", mode);
  std::int64_t last_index = 0;
  std::int64_t last_time = 0;
  for (int i = 0; i < 5; ++i) {
    const CameraFrame frame = ReadFrame(camera);
    EXPECT_GT(frame.device_index, last_index);
    if (last_index > 0) {
      EXPECT_EQ(frame.device_time_us - last_time,
                (frame.device_index - last_index) * (1'000'000 / mode.rate_hz));
    }
    last_index = frame.device_index;
    last_time = frame.device_time_us;
    frame.image.Validate();
    EXPECT_EQ(frame.image.intrinsics.width, mode.width);
    EXPECT_EQ(frame.image.intrinsics.height, mode.height);
    EXPECT_DOUBLE_EQ(frame.image.depth_unit_m, MetresPerUnit(mode.unit));
    EXPECT_TRUE(frame.image.depth ==
                PatternFrame(mode.width, mode.height, static_cast<int>(frame.device_index)));
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, OpenNiCameraModeTest,
                         ::testing::Values(kSmall, kLarge, kFine,
                                           DepthMode{640, 480, 30, DepthUnit::k100Um}));

TEST(OpenNiCameraTest, StatesTheFocalLengthOfTheFieldOfView) {
  const test::VirtualCameraControl control;
  OpenNiCamera camera("", kLarge);
  const CameraIntrinsics intrinsics = ReadFrame(camera).image.intrinsics;
  // 320 / tan(1.0144686707507438 / 2), worked by hand; the driver holds single precision.
  EXPECT_NEAR(intrinsics.fx, 575.8157, 1e-3);
  EXPECT_NEAR(intrinsics.fy, 575.8157, 1e-3);
  EXPECT_DOUBLE_EQ(intrinsics.cx, 319.5);
  EXPECT_DOUBLE_EQ(intrinsics.cy, 239.5);
}

TEST(OpenNiCameraTest, NamesTheModesThatThereAre) {
  const test::VirtualCameraControl control;
  EXPECT_THROW(OpenNiCamera("", {800, 600, 30, DepthUnit::k1Mm}), UnsupportedMode);
  EXPECT_THAT(MessageOf([] {
                OpenNiCamera("", {800, 600, 30, DepthUnit::k1Mm});
              }),
              AllOf(HasSubstr("virtual://0"), HasSubstr("got 800x600 30 Hz 1mm"),
                    HasSubstr("320x240 60 Hz 1mm")));
}

TEST(OpenNiCameraTest, NamesTheCamerasThatThereAre) {
  const test::VirtualCameraControl control;
  EXPECT_THROW(OpenNiCamera("virtual://7", kSmall), CameraUnavailable);
  EXPECT_THAT(MessageOf([] { OpenNiCamera("virtual://7", kSmall); }),
              AllOf(HasSubstr("virtual://7"), HasSubstr("virtual://0")));
}

TEST(OpenNiCameraTest, IsUnavailableWhenThereIsNoneOrItRefuses) {
  const test::VirtualCameraControl control("unplugged");
  EXPECT_THROW(OpenNiCamera("", kSmall), CameraUnavailable);
  control.Set("refusing");
  EXPECT_THROW(OpenNiCamera("", kSmall), CameraUnavailable);
  control.Set("plugged");
  OpenNiCamera camera("", kSmall);
  EXPECT_EQ(ReadFrame(camera).image.intrinsics.width, 320);
}

TEST(OpenNiCameraTest, SaysWhenItIsUnpluggedAndOpensAgainAfterwards) {
  const test::VirtualCameraControl control;
  // OpenNI2 must not be shut down while a camera is announced: it would wait for itself.
  const OpenNiSession session;
  for (int round = 0; round < 3; ++round) {
    OpenNiCamera camera("virtual://0", kSmall);
    ReadFrame(camera);
    control.Set("unplugged");
    EXPECT_THROW(for (int i = 0; i < 100; ++i) camera.Read(std::chrono::milliseconds(50)),
                 CameraUnavailable);
    control.Set("plugged");
    while (ListCameras(session).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(OpenNiCameraTest, GivesNothingWhileACameraIsSilent) {
  const test::VirtualCameraControl control("silent");
  OpenNiCamera camera("virtual://0", kSmall);
  EXPECT_FALSE(camera.Read(std::chrono::milliseconds(100)));
  control.Set("plugged");
  EXPECT_EQ(ReadFrame(camera).image.depth.size(), 320U * 240U);
}

TEST(OpenNiCameraTest, OpensAndClosesManyTimes) {
  const test::VirtualCameraControl control;
  for (int i = 0; i < 20; ++i) {
    OpenNiCamera camera("virtual://0", kSmall);
    ReadFrame(camera);
  }
}

/// Records for a while; the frames that were read meanwhile.
std::vector<CameraFrame> Record(const std::filesystem::path& path, const DepthMode& mode,
                                int count) {
  OpenNiCamera camera("virtual://0", mode, path);
  std::vector<CameraFrame> frames;
  while (static_cast<int>(frames.size()) < count) frames.push_back(ReadFrame(camera));
  return frames;
}

class OniFileModeTest : public ::testing::TestWithParam<DepthMode> {};

TEST_P(OniFileModeTest, ReplaysARecordingBitForBit) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  const DepthMode mode = GetParam();
  const std::vector<CameraFrame> recorded = Record(folder / "a.oni", mode, 8);
  OniFile file(folder / "a.oni", {.epoch_us = 1000, .sensor_name = "LEFT", .T_robot_camera = {}});
  ASSERT_GE(file.frame_count(), recorded.size());
  std::size_t count = 0;
  while (const std::optional<StampedDepthImage> frame = file.Next()) {
    const int number = static_cast<int>(++count);
    EXPECT_EQ(file.position(), count);
    EXPECT_EQ(frame->header.seq, number - 1);
    EXPECT_EQ(frame->header.sensor_name, "LEFT");
    EXPECT_EQ(frame->header.utime, 1000 + (number - 1) * (1'000'000 / mode.rate_hz));
    EXPECT_TRUE(frame->image.depth == PatternFrame(mode.width, mode.height, number));
    EXPECT_DOUBLE_EQ(frame->image.depth_unit_m, MetresPerUnit(mode.unit));
    EXPECT_TRUE(frame->image.intrinsics == recorded[0].image.intrinsics);
  }
  EXPECT_EQ(count, file.frame_count());
  EXPECT_FALSE(file.Next());
  EXPECT_EQ(file.duration_us(), static_cast<std::int64_t>(count) * (1'000'000 / mode.rate_hz));
}

INSTANTIATE_TEST_SUITE_P(Modes, OniFileModeTest, ::testing::Values(kSmall, kLarge, kFine));

TEST(OniFileTest, GivesTheSameEveryTime) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Record(folder / "a.oni", kSmall, 20);
  for (int round = 0; round < 3; ++round) {
    OniFile first(folder / "a.oni");
    OniFile second(folder / "a.oni");
    while (const std::optional<StampedDepthImage> frame = first.Next()) {
      const std::optional<StampedDepthImage> same = second.Next();
      ASSERT_TRUE(same);
      EXPECT_EQ(frame->header, same->header);
      EXPECT_TRUE(frame->image.depth == same->image.depth);
    }
    EXPECT_FALSE(second.Next());
  }
}

TEST(OniFileTest, RefusesAFileThatIsMissingOrNoRecording) {
  const TemporaryFolder folder;
  EXPECT_THAT(MessageOf([&] { OniFile(folder / "missing.oni"); }),
              AllOf(HasSubstr("missing.oni"), HasSubstr("cannot be read")));
  EXPECT_THAT(MessageOf([&] { OniFile(folder / ""); }), HasSubstr("cannot be read"));
  std::ofstream(folder / "text.oni") << "this is a text of more than twenty-four characters";
  EXPECT_THAT(MessageOf([&] { OniFile(folder / "text.oni"); }), HasSubstr("NI10"));
  std::ofstream(folder / "empty.oni");
  EXPECT_THAT(MessageOf([&] { OniFile(folder / "empty.oni"); }), HasSubstr("cut off"));
}

TEST(OniFileTest, RefusesAFileThatIsCutOffAnywhere) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Record(folder / "a.oni", kSmall, 3);
  const auto size = std::filesystem::file_size(folder / "a.oni");
  // Everywhere in the last record (the end mark), and at places spread over the whole file.
  std::vector<std::uintmax_t> lengths;
  for (std::uintmax_t cut = 1; cut <= 28; ++cut) lengths.push_back(size - cut);
  for (std::uintmax_t length = 0; length < size; length += size / 97 + 1) lengths.push_back(length);
  for (const std::uintmax_t length : lengths) {
    std::filesystem::copy_file(folder / "a.oni", folder / "cut.oni",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(folder / "cut.oni", length);
    EXPECT_THAT(MessageOf([&] { OniFile(folder / "cut.oni"); }),
                AllOf(HasSubstr("cut.oni: byte "), HasSubstr("cut off")))
        << "at " << length << " of " << size;
  }
}

TEST(OniFileTest, ReadsAPathThatIsTooLongForOpenNi2) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Record(folder / "a.oni", kSmall, 1);
  const std::filesystem::path deep = folder / (std::string(150, 'd') + "/" + std::string(150, 'e'));
  std::filesystem::create_directories(deep);
  std::filesystem::copy_file(folder / "a.oni", deep / "a.oni");
  OniFile file(deep / "a.oni");
  const std::optional<StampedDepthImage> frame = file.Next();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->image.depth == PatternFrame(320, 240, 1));
}

}  // namespace
}  // namespace fallen
