// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <map>
#include <stdexcept>

#include "fallen/messages/model_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"
#include "tools/picture/box_edges.hpp"
#include "tools/picture/canvas.hpp"
#include "tools/picture/frame_choice.hpp"
#include "tools/picture/map_cells.hpp"
#include "tools/picture/oblique_view.hpp"

namespace fallen {
namespace {

using lying_scene::Render;
using lying_scene::With;
using testing::HasSubstr;
using testing::StartsWith;

constexpr char kPngSignature[] = "\x89PNG\r\n";

TEST(BoxEdges, AreTwelveEdgesOfTheBoxAroundItsCenter) {
  const OrientedBox box{{1, 2, 3}, {2, 4, 6}, 0.7};
  const auto corners = BoxCorners(box);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : corners) {
    sum += corner;
    EXPECT_TRUE(box.Contains(box.center + 0.999 * (corner - box.center)));
    EXPECT_FALSE(box.Contains(box.center + 1.001 * (corner - box.center)));
  }
  EXPECT_TRUE((sum / 8).isApprox(box.center));
  std::map<long, int> lengths;
  for (const auto& [a, b] : BoxEdges()) ++lengths[std::lround((corners[a] - corners[b]).norm())];
  EXPECT_EQ(lengths, (std::map<long, int>{{2, 4}, {4, 4}, {6, 4}}));
}

TEST(ViewFromMap, PutsTheCameraAtTheOriginAndAheadOnX) {
  Eigen::Isometry3d T_world_camera = Eigen::Translation3d(5, -3, 0) *
                                     Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()) *
                                     lying_scene::CameraPose(0);
  const Eigen::Isometry3d T_view_map = ViewFromMap(MapFrame::kWorld, T_world_camera);
  const Eigen::Isometry3d T_view_camera = T_view_map * T_world_camera;
  EXPECT_TRUE(T_view_camera.isApprox(lying_scene::CameraPose(0), 1e-9));

  const Eigen::Isometry3d of_camera = ViewFromMap(MapFrame::kCamera, Eigen::Isometry3d::Identity());
  EXPECT_TRUE((of_camera * Eigen::Vector3d(0, 0, 2)).isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_TRUE((of_camera * Eigen::Vector3d(0, -1, 0)).isApprox(Eigen::Vector3d(0, 0, 1)));
}

TEST(ObliqueView, ShowsLeftOnTheLeftFarAndHighAbove) {
  const ObliqueView view(100, {400, 300});
  EXPECT_TRUE(view.Project({0, 0, 0}).isApprox(Eigen::Vector2d(400, 300)));
  EXPECT_NEAR(view.Project({0, 1, 0}).x(), 300, 1e-9);
  EXPECT_LT(view.Project({1, 0, 0}).y(), 300);
  EXPECT_LT(view.Project({0, 0, 1}).y(), 300);
  EXPECT_GT(ObliqueView::Depth({2, 0, 0}), ObliqueView::Depth({1, 0, 0}));

  // The ellipse of a covariance is that of its projected points.
  Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.04, 0.0025).asDiagonal();
  const Eigen::Vector2d step = view.Project({0, 0.2, 0}) - view.Project({0, 0, 0});
  EXPECT_NEAR(view.ProjectCovariance(covariance)(0, 0), step.x() * step.x(), 1e-9);
}

TEST(CellsToDraw, DrawsEveryCellOnceTheFarthestFirst) {
  Detector detector(PlainModel(), {}, BackgroundSubtractor());
  const FrameResult result = detector.Detect(Render(0, 0, With::kPerson));
  const NdtMap& map = result.foreground.map;
  const auto cells = CellsToDraw(result, ViewFromMap(map.frame, map.T_map_camera));
  EXPECT_EQ(cells.size(), map.cells.size());
  for (std::size_t i = 1; i < cells.size(); ++i)
    EXPECT_GE(ObliqueView::Depth(cells[i - 1].mean), ObliqueView::Depth(cells[i].mean));
}

TEST(Colors, RunFromEndToEndAndClamp) {
  EXPECT_EQ(PackColor({1, 0, 0.5}), 0xff0080u);
  EXPECT_EQ(PackColor(DepthColor(-3)), PackColor(DepthColor(0)));
  EXPECT_EQ(PackColor(ScoreColor(7)), PackColor(ScoreColor(1)));
  EXPECT_GT(ScoreColor(1).red, ScoreColor(1).blue);
  EXPECT_GT(ScoreColor(-1).blue, ScoreColor(-1).red);
}

TEST(Canvas, SaysWhatItCannotWrite) {
  Canvas canvas(10, 10, palette::kPaper);
  EXPECT_THROW(canvas.SavePng("/nowhere/a.png"), std::runtime_error);
}

TEST(ParseFrameChoice, TakesNumbersAndBest) {
  EXPECT_FALSE(ParseFrameChoice("best").index);
  EXPECT_EQ(ParseFrameChoice("12").index, 12);
  for (const char* wrong : {"", "-1", "1.5", "first", "12x", "99999999999999999999"})
    EXPECT_THROW(ParseFrameChoice(wrong), std::invalid_argument) << wrong;
}

/// Frames out of a list.
class ListSource : public FrameSource {
 public:
  explicit ListSource(std::vector<Frame> frames) : frames_(std::move(frames)) {}
  std::optional<Frame> Next() override {
    if (next_ == frames_.size()) return std::nullopt;
    return frames_[next_++];
  }
  std::optional<GroundTruth> Truth(const Frame&) override { return std::nullopt; }
  const std::string& camera() const override { return camera_; }
  double share_done() const override { return 0; }
  Damage damage() const override { return {}; }

 private:
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
  std::string camera_ = "CAMERA";
};

TEST(FindFrame, FindsTheFrameWithTheHighestProbabilityOrTheOneAskedFor) {
  DetectorConfig config;
  config.ndt.max_range_m = 3.2;  // without the wall
  config.ndt.accumulate = false;
  const std::vector<Frame> frames = {Render(0, 0, With::kNobody), Render(100000, 0, With::kPerson),
                                     Render(200000, 0, With::kNobody)};
  const auto find = [&](const FrameChoice& choice) {
    Detector detector(PlainModel(), config, BackgroundSubtractor());
    ListSource source(frames);
    return FindFrame(source, detector, choice, "test");
  };
  EXPECT_EQ(find({}).index, 1);
  EXPECT_EQ(find({}).result.decision.hypotheses.size(), 1u);
  EXPECT_EQ(find({2}).index, 2);
  EXPECT_EQ(find({2}).frame.utime, 200000);
  EXPECT_THROW(find({3}), std::runtime_error);
}

TEST(FallenView, WritesAPictureOfEveryKindOfFrame) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "plain.model").string();
  SaveModel(model, PlainModel());
  const std::string png = (folder.path() / "out.png").string();
  for (const bool with_poses : {true, false}) {
    const auto room = folder.path() / (with_poses ? "posed" : "unposed");
    lying_scene::WriteDirectory(room, 2, With::kPerson, with_poses);
    const ProgramOutcome outcome =
        RunProgram("fallen-view", {room.string(), "--export", png, "--model", model});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("fallen person"));
    EXPECT_THAT(ReadText(png), StartsWith(kPngSignature));
    std::filesystem::remove(png);
  }
}

TEST(FallenView, MakesAFilmOfARecording) {
  if (RunCommand({"ffmpeg", "-version"}).status != 0) GTEST_SKIP() << "ffmpeg is missing";
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "plain.model").string();
  SaveModel(model, PlainModel());
  lying_scene::WriteDirectory(folder.path() / "room", 5, With::kPerson, true);
  const std::string film = (folder.path() / "out.mp4").string();
  const ProgramOutcome outcome = RunProgram(
      "fallen-view", {(folder.path() / "room").string(), "--export", film, "--model", model});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const ProgramOutcome probe =
      RunCommand({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                  "stream=nb_read_frames,r_frame_rate,width", "-of", "csv=p=0", film});
  EXPECT_EQ(probe.out, "1600,10/1,5\n") << probe.err;
}

TEST(FallenView, AWrongCallOrInputIsOneLineAndStatusTwo) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "plain.model").string();
  SaveModel(model, PlainModel());
  const std::string room = (folder.path() / "room").string();
  lying_scene::WriteDirectory(room, 1, With::kNobody, true);
  const std::string png = (folder.path() / "out.png").string();
  const std::vector<std::vector<std::string>> calls = {
      {room, "--export", png, "--frame", "first", "--model", model},
      {room, "--export", png, "--frame", "1", "--model", model},
      {room, "--export", "/nowhere/out.png", "--model", model},
      {room, "--export", "/nowhere/out.mp4", "--model", model},
      {room, "--export", png + ".gif", "--model", model},
      {"/nowhere", "--export", png, "--model", model}};
  for (const std::vector<std::string>& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-view", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(png));
  }
}

}  // namespace
}  // namespace fallen
