// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "fallen/detection/detector.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"
#include "tools/view/scene/cell_ages.hpp"
#include "tools/view/scene/cell_texels.hpp"
#include "tools/view/scene/page_message.hpp"
#include "tools/view/scene/scene_message.hpp"
#include "tools/view/scene/timeline.hpp"

namespace fallen {
namespace {

using nlohmann::json;
using testing::ElementsAre;

/// A message taken apart as its description says, without the code that made it.
struct Opened {
  json facts;
  std::vector<std::uint8_t> arrays;

  template <class T>
  std::vector<T> Array(const std::string& name) const {
    const json& place = facts.at("arrays").at(name);
    std::vector<T> values(place.at("count").get<std::size_t>());
    if (values.empty()) return values;
    std::memcpy(values.data(), arrays.data() + place.at("offset").get<std::size_t>(),
                values.size() * sizeof(T));
    return values;
  }
};

Opened Open(const std::vector<std::uint8_t>& bytes) {
  const std::uint32_t length = bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24;
  EXPECT_EQ(length % 4, 0u);
  const auto begin = bytes.begin() + 4;
  return {json::parse(begin, begin + length), {begin + length, bytes.end()}};
}

NdtCell CellAt(float x, float y, float z) {
  NdtCell cell;
  cell.mean = {x, y, z};
  cell.covariance = {4e-4f, 1e-4f, 2e-5f, 3e-4f, -5e-5f, 4e-5f};
  cell.point_count = 10;
  return cell;
}

Scene DetectedScene() {
  Detector detector(PlainModel(), {}, BackgroundSubtractor());
  const Frame frame = lying_scene::Render(1'000'000, 0, lying_scene::With::kPerson);
  FrameResult result = detector.Detect(frame);
  Scene scene;
  scene.header = {frame.utime, 7, "CAMERA"};
  scene.image = frame.image;
  scene.map = std::move(result.foreground);
  scene.segmented = std::move(result.segmented);
  scene.decision = std::move(result.decision);
  return scene;
}

TEST(PageMessage, HoldsFactsAndArraysAtAlignedPlaces) {
  PageMessage message({{"kind", "test"}, {"text", "ä"}});
  message.Add<std::int8_t>("odd", std::vector<std::int8_t>{-1, 2, 3});
  message.Add<std::uint16_t>("wide", std::vector<std::uint16_t>{65535, 7});
  message.Add<std::int16_t>("none", std::vector<std::int16_t>{});
  const Opened opened = Open(message.Encode());
  EXPECT_EQ(opened.facts["text"], "ä");
  EXPECT_EQ(opened.facts["arrays"]["odd"]["type"], "int8");
  EXPECT_EQ(opened.facts["arrays"]["wide"]["type"], "uint16");
  EXPECT_EQ(opened.facts["arrays"]["wide"]["offset"], 4);
  EXPECT_THAT(opened.Array<std::int8_t>("odd"), ElementsAre(-1, 2, 3));
  EXPECT_THAT(opened.Array<std::uint16_t>("wide"), ElementsAre(65535, 7));
  EXPECT_TRUE(opened.Array<std::int16_t>("none").empty());
}

TEST(CellTexels, GiveMeanAndCovarianceBack) {
  const std::vector<NdtCell> cells = {CellAt(-2, 1, 0.1f), CellAt(3, 4, 1), CellAt(0, 0, 0)};
  const CellTexels packed = ToCellTexels(cells, {});
  ASSERT_EQ(packed.count(), 3u);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::int16_t* t = &packed.texels[12 * i];
    const Eigen::Vector3d mean =
        packed.origin + packed.place_step_m * Eigen::Vector3d(t[0], t[1], t[2]);
    EXPECT_LT((mean - cells[i].mean.cast<double>()).norm(), 2 * packed.place_step_m);
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();
    root.row(0) << t[4], 0, 0;
    root.row(1) << t[5], t[6], 0;
    root.row(2) << t[8], t[9], t[10];
    root *= packed.root_step_m;
    const Eigen::Matrix3d expected = cells[i].CovarianceMatrix().cast<double>();
    EXPECT_LT((root * root.transpose() - expected).norm(), 1e-3 * expected.norm());
  }
  EXPECT_LT(packed.place_step_m, 1e-3);
}

TEST(CellTexels, TellScoreClusterAndAge) {
  const std::vector<NdtCell> cells(3, CellAt(1, 1, 1));
  const std::vector<CellMark> marks = {
      {0.5f, 4, 1.26, true}, {std::nullopt, -1, 0, true}, {-1.0f, -1, 1e9, false}};
  const std::vector<std::int16_t> t = ToCellTexels(cells, marks).texels;
  EXPECT_THAT((std::vector{t[3], t[7], t[11]}), ElementsAre(4, 16384, 13));
  EXPECT_THAT((std::vector{t[15], t[19], t[23]}), ElementsAre(-1, -32768, 0));
  EXPECT_THAT((std::vector{t[27], t[31], t[35]}), ElementsAre(-2, -32767, 32767));
  EXPECT_EQ(ToCellTexels({}, {}).count(), 0u);
}

TEST(CellAges, GrowUntilACellTakesPointsIn) {
  CellAges ages;
  std::vector<NdtCell> cells = {CellAt(0.01f, 0, 0), CellAt(1, 0, 0)};
  EXPECT_THAT(ages.Update(0, 0.05, cells), ElementsAre(0, 0));
  cells[1].point_count = 11;
  EXPECT_THAT(ages.Update(2'000'000, 0.05, cells), ElementsAre(2, 0));
  cells.push_back(CellAt(2, 0, 0));
  EXPECT_THAT(ages.Update(3'000'000, 0.05, cells), ElementsAre(3, 1, 0));
  EXPECT_THAT(ages.Update(1'000'000, 0.05, cells), ElementsAre(0, 0, 0)) << "time ran backwards";
}

TEST(SceneToMessage, HasTheWholeFrame) {
  const Scene scene = DetectedScene();
  CellAges ages;
  const Opened opened = Open(SceneToMessage(scene, 3, ages));
  const json& facts = opened.facts;
  EXPECT_EQ(facts["kind"], "frame");
  EXPECT_EQ(facts["index"], 3);
  EXPECT_EQ(facts["utime"], 1'000'000);
  EXPECT_EQ(facts["seq"], 7);
  EXPECT_EQ(facts["frame"], "world");
  EXPECT_EQ(facts["ground"]["status"], "ok");
  EXPECT_EQ(facts["persons"].size(), scene.decision->hypotheses.size());
  EXPECT_EQ(facts["cells"]["count"], scene.map->map.cells.size());
  EXPECT_EQ(opened.Array<std::int16_t>("texels").size(), 12 * scene.map->map.cells.size());
  const DepthImage& image = *scene.image;
  const auto depth = opened.Array<std::uint16_t>("depth");
  ASSERT_EQ(facts["depth"]["width"], image.intrinsics.width);
  ASSERT_EQ(depth.size(), image.depth.size());
  for (std::size_t i = 0; i < depth.size(); i += 997)
    EXPECT_NEAR(depth[i], image.depth[i] * image.depth_unit_m * 1000, 0.5);
  const Eigen::Vector3d camera = scene.map->map.T_map_camera.translation();
  EXPECT_NEAR(facts["T_map_camera"][3], camera.x(), 1e-12);
  EXPECT_NEAR(facts["T_map_camera"][11], camera.z(), 1e-12);
}

TEST(SceneToMessage, LeavesOutWhatIsNotKnown) {
  Scene scene = DetectedScene();
  CellAges ages;
  const std::size_t scored = scene.segmented->cells.size();
  scene.map.reset();
  EXPECT_EQ(Open(SceneToMessage(scene, 0, ages)).facts["cells"]["count"], scored);
  scene.segmented.reset();
  scene.decision.reset();
  const json facts = Open(SceneToMessage(scene, 0, ages)).facts;
  EXPECT_FALSE(facts.contains("cells"));
  EXPECT_FALSE(facts.contains("persons"));
  EXPECT_TRUE(facts.contains("depth"));
  scene.image.reset();
  EXPECT_FALSE(Open(SceneToMessage(scene, 0, ages)).facts.contains("depth"));
}

TEST(SceneToMessage, ShowsCellsOfNoClusterAsBallsWhereOnlyTheirPlaceIsKnown) {
  Scene scene;
  SegmentedMap& segmented = scene.segmented.emplace();
  segmented.members = {CellAt(1, 2, 0.1F)};
  segmented.cells = {{{0, 2, 0.2F}, -0.5F, -1}, {{1, 2, 0.1F}, 0.5F, 0}};
  segmented.clusters.resize(1);
  segmented.clusters[0].cells = {1};
  CellAges ages;
  const Opened opened = Open(SceneToMessage(scene, 0, ages));
  const auto t = opened.Array<std::int16_t>("texels");
  ASSERT_EQ(t.size(), 24U);
  const double step = opened.facts["cells"]["root_step_m"];
  const double deviation = 0.15 * segmented.cell_size_m;
  EXPECT_NEAR(t[4] * step, deviation, 2 * step);
  EXPECT_NEAR(t[6] * step, deviation, 2 * step);
  EXPECT_NEAR(t[10] * step, deviation, 2 * step);
  EXPECT_THAT((std::vector{t[5], t[8], t[9]}), ElementsAre(0, 0, 0));
  EXPECT_NEAR(t[16] * step, std::sqrt(segmented.members[0].covariance[0]), 2 * step);
  EXPECT_THAT((std::vector{t[3], t[15]}), ElementsAre(-1, 0));
}

TEST(SceneToMessage, ThinsALargeImage) {
  Scene scene;
  scene.image = DepthImage{{640, 480, 500, 500, 320, 240}, 0.0001, {}};
  scene.image->depth.assign(640 * 480, 12345);
  CellAges ages;
  const Opened opened = Open(SceneToMessage(scene, 0, ages));
  EXPECT_EQ(opened.facts["depth"]["width"], 320);
  EXPECT_EQ(opened.facts["depth"]["height"], 240);
  EXPECT_EQ(opened.facts["intrinsics"]["width"], 640);
  EXPECT_EQ(opened.Array<std::uint16_t>("depth").at(0), 1235) << "a tenth of a millimetre each";
}

TEST(TimelineEntry, TellsDecisionPersonsAndPlace) {
  const Scene scene = DetectedScene();
  const TimelineEntry entry = ToTimelineEntry(scene);
  EXPECT_EQ(entry.utime, 1'000'000);
  ASSERT_TRUE(entry.probability && entry.camera);
  EXPECT_EQ(ToJson(entry).size(), 6u);
  Scene undecided;
  undecided.header.utime = 5;
  EXPECT_EQ(ToJson(ToTimelineEntry(undecided)).dump(), "[5,null,0]");
}

}  // namespace
}  // namespace fallen
