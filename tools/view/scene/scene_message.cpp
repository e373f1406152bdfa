// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/scene/scene_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tools/view/scene/cell_texels.hpp"
#include "tools/view/scene/page_message.hpp"

namespace fallen {
namespace {

using nlohmann::json;

constexpr double kBallDeviation = 0.15;  // of a ball's cell sizes
constexpr int kMaxImageWidth = 320;      // of the thinned image: a panel of the page is no wider

json ToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json ToJson(const OrientedBox& box) {
  return {{"center", ToJson(box.center)}, {"size", ToJson(box.size)}, {"yaw", box.yaw}};
}

json ToJson(const Eigen::Isometry3d& transform) {
  json numbers = json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) numbers.push_back(transform.matrix()(row, column));
  return numbers;
}

json ToJson(const GroundEstimate& ground) {
  return {{"status", EnumName(ground.status)},
          {"method", EnumName(ground.method)},
          {"normal", ToJson(ground.plane.normal)},
          {"offset", ground.plane.offset}};
}

json ToJson(const PersonHypothesis& person) {
  return {{"centroid", ToJson(person.centroid)},
          {"box", ToJson(person.box)},
          {"probability", person.probability},
          {"cells", person.cell_count},
          {"distance", person.mahalanobis_distance},
          {"mean_score", person.mean_score},
          {"is_person", person.is_person}};
}

json ToJson(const StageTimes& times) {
  return {{"ground", times.ground}, {"ndt", times.ndt},     {"background", times.background},
          {"iron", times.iron},     {"cells", times.cells}, {"clusters", times.clusters},
          {"total", times.total}};
}

void AddImage(json& facts, std::vector<std::uint16_t>& depth, const DepthImage& image) {
  const CameraIntrinsics& camera = image.intrinsics;
  facts["intrinsics"] = {{"width", camera.width}, {"height", camera.height}, {"fx", camera.fx},
                         {"fy", camera.fy},       {"cx", camera.cx},         {"cy", camera.cy}};
  const int step = (camera.width + kMaxImageWidth - 1) / kMaxImageWidth;
  const int width = camera.width / step;
  const int height = camera.height / step;
  facts["depth"] = {{"width", width}, {"height", height}};
  depth.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * step * camera.width + x * step);
      const double millimetres = image.depth[pixel] * image.depth_unit_m * 1000;
      depth.push_back(static_cast<std::uint16_t>(std::lround(std::min(millimetres, 65535.0))));
    }
}

/// A cell of which only the place is known.
NdtCell Ball(const Eigen::Vector3f& mean, double cell_size_m) {
  const auto variance = static_cast<float>(std::pow(kBallDeviation * cell_size_m, 2));
  return {mean, {variance, 0, 0, variance, 0, variance}, 1, 0};
}

/// The map of a frame, or what the segmentation says of it where only that has spoken: the cells of
/// clusters, and small balls for the others, of which it tells the place alone.
std::optional<NdtMap> MapOf(const Scene& scene) {
  if (scene.map) return scene.map->map;
  if (!scene.segmented) return std::nullopt;
  const SegmentedMap& segmented = *scene.segmented;
  NdtMap map{segmented.cell_size_m, segmented.frame,  segmented.T_map_camera,
             segmented.view,        segmented.ground, {}};
  auto member = segmented.members.begin();
  for (const ScoredCell& scored : segmented.cells)
    map.cells.push_back(scored.cluster >= 0 ? *member++ : Ball(scored.mean, map.cell_size_m));
  return map;
}

/// What is known of each cell of `map`.
std::vector<CellMark> MarksOf(const Scene& scene, const NdtMap& map, CellAges& ages) {
  using Place = std::array<float, 3>;
  const auto place_of = [](const Eigen::Vector3f& mean) {
    return Place{mean.x(), mean.y(), mean.z()};
  };
  std::map<Place, const ScoredCell*> scored_at;
  if (scene.segmented)
    for (const ScoredCell& scored : scene.segmented->cells)
      scored_at[place_of(scored.mean)] = &scored;
  const std::vector<double> ages_s = ages.Update(scene.header.utime, map.cell_size_m, map.cells);
  std::vector<CellMark> marks(map.cells.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    marks[i].age_s = ages_s[i];
    if (scene.map) marks[i].is_foreground = scene.map->is_foreground[i] != 0;
    const auto found = scored_at.find(place_of(map.cells[i].mean));
    if (found == scored_at.end()) continue;
    marks[i].score = found->second->score;
    marks[i].cluster = found->second->cluster;
  }
  return marks;
}

json CellsToJson(const CellTexels& cells) {
  return {{"count", cells.count()},
          {"origin", ToJson(cells.origin)},
          {"place_step_m", cells.place_step_m},
          {"root_step_m", cells.root_step_m}};
}

json FactsOf(const Scene& scene, std::int64_t index) {
  json facts = {{"kind", "frame"},
                {"index", index},
                {"utime", scene.header.utime},
                {"seq", scene.header.seq},
                {"camera", scene.header.sensor_name}};
  if (scene.map) facts["background"] = EnumName(scene.map->status);
  if (scene.decision) {
    facts["min_probability"] = scene.decision->min_probability;
    facts["frame"] = EnumName(scene.decision->frame);
    facts["persons"] = json::array();
    for (const PersonHypothesis& person : scene.decision->hypotheses)
      facts["persons"].push_back(ToJson(person));
  }
  if (scene.milliseconds) facts["milliseconds"] = ToJson(*scene.milliseconds);
  if (scene.truth) facts["truth"] = ToJson(*scene.truth);
  return facts;
}

}  // namespace

std::vector<std::uint8_t> SceneToMessage(const Scene& scene, std::int64_t index, CellAges& ages) {
  json facts = FactsOf(scene, index);
  std::vector<std::uint16_t> depth;
  if (scene.image) AddImage(facts, depth, *scene.image);
  const std::optional<NdtMap> map = MapOf(scene);
  if (!map) {
    PageMessage message(std::move(facts));
    message.Add<std::uint16_t>("depth", depth);
    return message.Encode();
  }

  const CellTexels cells = ToCellTexels(map->cells, MarksOf(scene, *map, ages));
  facts["frame"] = EnumName(map->frame);
  facts["T_map_camera"] = ToJson(map->T_map_camera);
  facts["ground"] = ToJson(map->ground);
  facts["cells"] = CellsToJson(cells);
  PageMessage message(std::move(facts));
  message.Add<std::uint16_t>("depth", depth);
  message.Add<std::int16_t>("texels", cells.texels);
  return message.Encode();
}

std::vector<std::uint8_t> EnvironmentToMessage(const EnvironmentMap& environment) {
  CellMark known;
  known.is_foreground = false;
  const CellTexels cells =
      ToCellTexels(environment.cells, std::vector<CellMark>(environment.cells.size(), known));
  PageMessage message({{"kind", "environment"}, {"cells", CellsToJson(cells)}});
  message.Add<std::int16_t>("texels", cells.texels);
  return message.Encode();
}

}  // namespace fallen
