// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-depth-capture in front of the chain: filmed by the virtual camera, played into it.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/model_files.hpp"
#include "tests/integration/chain_checks.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/services/depth_capture/virtual_camera_control.hpp"
#include "tests/support/log_detection.hpp"
#include "tests/support/synthetic_model.hpp"
#include "tests/support/synthetic_scene.hpp"
#include "tools/view/view_options.hpp"

namespace fallen::testing_support {
namespace {

using std::chrono::milliseconds;

const std::string kCaptureService = "depth-capture";
const std::string kDepth = "DEPTH_CAMERA";
const std::string kPersons = "FALLEN_PERSONS_CAMERA";

using Film = std::vector<std::vector<std::uint16_t>>;  // 320 x 240 each

/// A call of a program of ours that finds the virtual cameras.
std::vector<std::string> AmongVirtualCameras(const std::string& program,
                                             const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"env", "LD_LIBRARY_PATH=" FALLEN_OPENNI2_DIR, Program(program)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// OpenNI2's recorder writes the end of a picture out of order: up to 14 pairs of equal pixels
/// before the last one come behind it, and take its value (XnStreamCompressDepth16ZWithEmbTable).
constexpr std::ptrdiff_t kPixelsOutOfOrder = 28;

bool IsSamePicture(const std::vector<std::uint16_t>& recorded,
                   const std::vector<std::uint16_t>& shown) {
  return recorded.size() == shown.size() && recorded.back() == shown.back() &&
         std::equal(recorded.begin(), recorded.end() - 1 - kPixelsOutOfOrder, shown.begin());
}

class CaptureChain : public testing::Test {
 protected:
  /// Starts fallen-depth-capture's recording of the virtual camera, which shows `film` over and
  /// over, and ends it once the whole film has been seen.
  void Record(ServiceChain& chain, const Film& film) {
    {
      std::ofstream raw(folder_ / "film.raw", std::ios::binary);
      for (const auto& image : film)
        raw.write(reinterpret_cast<const char*>(image.data()),
                  static_cast<std::streamsize>(image.size() * sizeof(image[0])));
    }
    setenv(virtual_camera::kFramesVariable, (folder_ / "film.raw").c_str(), 1);
    ChildProcess capture(AmongVirtualCameras("fallen-depth-capture",
                                             {"--width", "320", "--height", "240", "--record",
                                              recording_, "--lcm-url", chain.url()}),
                         folder_.path());
    EXPECT_TRUE(chain.WaitForMessages(kDepth, film.size())) << capture.StandardError();
    EXPECT_EQ(capture.Stop(), 0) << capture.StandardError();
  }

  /// Plays the recording into the chain, at its own pace, and waits for the last decision.
  /// @return Number of frames.
  std::size_t Play(ServiceChain& chain, const Film& film) {
    chain.recorder().Clear();
    std::vector<std::string> arguments{recording_, "--lcm-url", chain.url()};
    if (!configuration_.empty()) arguments.insert(arguments.end(), {"--config", configuration_});
    chain.Run(AmongVirtualCameras("fallen-depth-capture", arguments));
    const auto published =
        static_cast<std::size_t>(chain.recorder().Status(kCaptureService).published);
    EXPECT_GE(published, film.size());
    EXPECT_TRUE(chain.WaitForMessages(kPersons, published))
        << chain.recorder().Count(kPersons) << " decisions on " << chain.recorder().Count(kDepth)
        << " frames of " << published;
    const auto sent = chain.recorder().Messages<depth_image_t>(kDepth);
    for (std::size_t i = 0; i < sent.size(); ++i)
      EXPECT_TRUE(IsSamePicture(FromMessage(sent[i]).image.depth, film[i % film.size()])) << i;
    return published;
  }

  std::vector<std::string> Detect() const {
    std::vector<std::string> arguments{recording_, "--model", model_};
    if (!configuration_.empty()) arguments.insert(arguments.end(), {"--config", configuration_});
    return AmongVirtualCameras("fallen-detect", arguments);
  }

  const test::VirtualCameraControl camera_;
  const TemporaryFolder folder_;
  const std::filesystem::path recording_ = folder_ / "film.oni";
  std::filesystem::path model_ = FALLEN_SOURCE_DIR "/models/fallen.model";
  std::filesystem::path configuration_;
};

int CountPersons(ServiceChain& chain) {
  int count = 0;
  for (const auto& decision : chain.recorder().Messages<fallen_persons_t>(kPersons))
    for (const auto& hypothesis : decision.hypotheses) count += hypothesis.is_person;
  return count;
}

TEST_F(CaptureChain, FindsThePersonOfTheDemoRecordingAsOneProcessDoes) {
  Film film;
  for (const auto& bytes : BytesInLog(FALLEN_SOURCE_DIR "/recordings/demo.lcm", kDepth))
    film.push_back(FromMessage(*DecodeMessage<depth_image_t>(bytes).message).image.depth);
  ServiceChain chain(model_);
  Record(chain, film);
  chain.StartAll();
  Play(chain, film);
  ExpectSameAsTheTool(chain, Detect());
  EXPECT_GT(CountPersons(chain), 0) << "decisions about nobody would agree too easily";
  chain.StopAll();
}

TEST_F(CaptureChain, RecordedChannelsOfACameraThatStandsStillReplayWithTheSameResult) {
  // What the recording does not know comes from the configuration: the camera of the scene, and
  // that maps are to grow without a pose.
  configuration_ = folder_ / "fixed.yaml";
  std::ofstream(configuration_) << "capture:\n"
                                   "  mounting_position_m: [0.1, 0, 0.95]\n"
                                   "  mounting_roll_pitch_yaw_deg: [0, 20, 0]\n"
                                   "ground:\n"
                                   "  method: mounting\n"
                                   "ndt:\n"
                                   "  without_pose: fixed_camera\n";
  model_ = folder_ / "test.model";
  SaveModel(model_, SyntheticModel());
  Film film;
  for (int seq = 0; seq < 30; ++seq) film.push_back(SceneImage(seq).image.depth);
  ServiceChain chain(model_, configuration_);
  Record(chain, film);
  chain.StartAll();
  ChildProcess logger = chain.StartLogger(folder_ / "run.lcm");
  const std::size_t frames = Play(chain, film);
  chain.recorder().HandleFor(milliseconds(1200));  // a last status of each
  EXPECT_EQ(logger.Stop(), 0);
  ExpectSameAsTheTool(chain, Detect());
  for (const auto& map : chain.recorder().Messages<ndt_map_t>("NDT_MAP_CAMERA"))
    EXPECT_EQ(NdtMapFromMessage(map).ground.method, GroundMethod::kMounting);
  chain.StopAll();
  EXPECT_EQ(BytesInLog(folder_ / "run.lcm", kDepth).size(), frames);
  ExpectEachChannelReplays(chain, folder_ / "run.lcm", frames);
}

TEST_F(CaptureChain, IsLookedAtWithTheConfiguredMounting) {
  ServiceChain chain(model_);
  Record(chain, {SceneImage(0).image.depth});
  ViewOptions options;
  options.input = recording_;
  options.detector.config = folder_ / "mounting.yaml";
  std::ofstream(*options.detector.config) << "capture: {mounting_position_m: [0.1, 0, 0.95], "
                                             "mounting_roll_pitch_yaw_deg: [0, 0, 0]}\n";
  const std::optional<Frame> frame = OpenInput(options)->Next();
  ASSERT_TRUE(frame);
  ASSERT_TRUE(frame->T_robot_camera);
  EXPECT_EQ(frame->T_robot_camera->translation(), Eigen::Vector3d(0.1, 0, 0.95));
}

}  // namespace
}  // namespace fallen::testing_support
