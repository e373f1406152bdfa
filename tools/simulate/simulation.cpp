// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "tools/simulate/black_cloth.hpp"
#include "tools/simulate/distractors.hpp"
#include "tools/simulate/lying_props.hpp"
#include "tools/simulate/moved_furniture.hpp"
#include "tools/simulate/persons.hpp"
#include "tools/simulate/resting_person.hpp"
#include "tools/simulate/room_layout.hpp"

namespace fallen::sim {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr double kCameraAhead = 0.15;  // [m] of the robot's middle

// What a robot believes of its way when its odometry is off by `drift`: scale and heading wander.
std::vector<RobotPose> Astray(const std::vector<RobotPose>& path, double drift, Random random) {
  std::vector<RobotPose> told = path;
  const double scale = 1 + random.Normal(0, drift), heading_per_m = random.Normal(0, drift);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d step(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    const double error = told[i - 1].yaw - path[i - 1].yaw + heading_per_m * step.norm();
    const Eigen::Vector2d moved = scale * (Eigen::Rotation2Dd(error) * step);
    told[i] = {told[i - 1].x + moved.x(), told[i - 1].y + moved.y(), path[i].yaw + error};
  }
  return told;
}

Eigen::Isometry3d Perturb(const Eigen::Isometry3d& T_robot_camera, double degrees, double metres,
                          Random random) {
  const auto direction = [&] {
    return Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal()).normalized();
  };
  Eigen::Isometry3d perturbed = T_robot_camera;
  perturbed.rotate(Eigen::AngleAxisd(degrees * kRadPerDeg, direction()));
  perturbed.translation() += metres * direction();
  return perturbed;
}

BodyShape DressedBody(const Scenario& scenario) {
  BodyShape shape = DrawBodyShape(scenario.body);
  WearBlack(scenario.black_cloth,
            Random::Stream(static_cast<std::uint64_t>(scenario.seed), "clothes"), shape);
  return shape;
}

}  // namespace

std::filesystem::path AssetsFolder(const std::optional<std::filesystem::path>& given) {
  if (given) return *given;
  if (const char* variable = std::getenv("FALLEN_ASSETS"); variable != nullptr && *variable != 0)
    return variable;
  return FALLEN_DEFAULT_ASSETS;
}

Assets LoadAssets(const std::filesystem::path& folder) {
  return {LoadHumanModel(folder), LoadFurnitureCatalogue(folder)};
}

Eigen::Isometry3d MakeMounting(double height_m, double pitch_rad) {
  const double c = std::cos(pitch_rad), s = std::sin(pitch_rad);
  Eigen::Isometry3d T_robot_camera = Eigen::Isometry3d::Identity();
  T_robot_camera.linear() << 0, -s, c,  //
      -1, 0, 0,                         //
      0, -c, -s;
  T_robot_camera.translation() = Eigen::Vector3d(kCameraAhead, 0, height_m);
  return T_robot_camera;
}

Eigen::Isometry3d ToTransform(const RobotPose& pose) {
  return Eigen::Translation3d(pose.x, pose.y, 0) *
         Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()) * Eigen::Isometry3d::Identity();
}

Simulation::Simulation(const Scenario& scenario, const Assets& assets) : scenario_(scenario) {
  const auto seed = static_cast<std::uint64_t>(scenario.seed);
  sensor_ = DrawSensor(scenario.sensor, scenario.width, scenario.sensor_variation, seed);
  sensor_.config.noise = scenario.noise;
  sensor_.config.axial_noise_scale *= scenario.noise_scale;
  sensor_.config.lateral_noise_px *= scenario.noise_scale;
  if (scenario.furnished) {
    scene_ = FurnishRoom(scenario.room, scenario.furniture_pool, assets.furniture, scenario.clutter,
                         scenario.room_kind)
                 .scene;
    Random moves = Random::Stream(static_cast<std::uint64_t>(scenario.room), "moved_furniture");
    MoveFurniture(scene_, scenario.moved_furniture, moves);
  } else {
    scene_.room_size = {6, 6};
    scene_.shell = MakeShell(scene_.room_size, 2.5);
  }
  ColumnGrid grid(scene_.room_size);
  for (const SceneObject& object : scene_.objects) grid.Add(object.mesh);
  if (scenario.person) AddPerson(assets, grid);
  AddDistractors(assets, grid);
  if (person_ && scenario.gets_up_after_s) LetGetUp(assets, grid);

  const SceneObject* target = DrawTarget(Random::Stream(seed, "target"));
  std::optional<Eigen::Vector2d> target_place;
  PathConfig path;
  path.frames = scenario.frames;
  path.rate_hz = scenario.rate_hz;
  path.max_speed_m_s = scenario.max_speed_m_s;
  path.half_field_of_view_rad = std::atan(scenario.width / 2.0 / sensor_.intrinsics.fx);
  path.half_vertical_view_rad = std::atan(sensor_.intrinsics.height / 2.0 / sensor_.intrinsics.fy);
  path.camera_height_m = scenario.camera_height_m;
  path.camera_pitch_rad = scenario.camera_pitch_deg * kRadPerDeg;
  path.robot_height_m = scenario.camera_height_m + 0.1;
  if (scenario.half_hidden && person_) {
    const OrientedBox& box = scene_.objects[*person_].box;
    constexpr double kEnd = 0.3;  // of the length, from the middle
    path.half_hidden = Eigen::Rotation2Dd(box.yaw) * Eigen::Vector2d(kEnd * box.size.x(), 0);
  }
  if (target != nullptr) {
    target_place = target->box.center.head<2>();
    path.target_height_m = target->box.center.z();
  }
  Random random = Random::Stream(seed, "path");
  path_ = DrawPath(path, grid, scene_.room_size, target_place, random);
  told_path_ = Astray(path_, scenario.odometry_drift, Random::Stream(seed, "odometry"));
  told_T_robot_camera_ =
      MakeMounting(scenario.camera_height_m, scenario.camera_pitch_deg * kRadPerDeg);
  true_T_robot_camera_ = Perturb(told_T_robot_camera_, scenario.mounting_error_deg,
                                 scenario.mounting_error_m, Random::Stream(seed, "mounting"));
  caster_ = std::make_unique<RayCaster>(scene_);
  if (later_) later_->caster = std::make_unique<RayCaster>(later_->scene);
}

Simulation::~Simulation() = default;

void Simulation::AddPerson(const Assets& assets, ColumnGrid& grid) {
  const auto seed = static_cast<std::uint64_t>(scenario_.seed);
  Random pose_random = Random::Stream(seed, "pose_jitter");
  PersonMesh person =
      MakeLyingPerson(assets.humans, DressedBody(scenario_), scenario_.pose, pose_random);
  settled_ = person.settled;
  if (scenario_.blanket)
    person.props.push_back({"blanket", MakeBlanketOver(person.mesh, pose_random)});
  TriangleMesh together = person.mesh;
  for (const Prop& prop : person.props) together.Append(prop.mesh);
  std::optional<double> yaw;
  if (scenario_.yaw_deg) yaw = *scenario_.yaw_deg * kRadPerDeg;
  Random random = Random::Stream(seed, "person_place");
  const auto place = PlaceOnFloor(together, scenario_.placement, yaw, grid, scene_, random);
  if (!place)
    throw std::runtime_error(
        "room " + std::to_string(scenario_.room) + ": got no floor for body " +
        std::to_string(scenario_.body) +
        " to lie on, expected a room with more space: try another room or less clutter");
  placement_reached_ = place->reached;
  SceneObject object =
      PlaceObject(kFallenPerson, "body-" + std::to_string(scenario_.body), std::move(person.mesh),
                  {place->position.x(), place->position.y(), 0}, place->yaw);
  object.box = BoxAround(object.mesh, MainAxisYaw(object.mesh));
  grid.Add(object.mesh);
  person_ = scene_.objects.size();
  scene_.objects.push_back(std::move(object));
  for (Prop& prop : person.props) {
    if (prop.mesh.empty()) continue;
    scene_.objects.push_back(PlaceObject(prop.name, prop.name, std::move(prop.mesh),
                                         {place->position.x(), place->position.y(), 0},
                                         place->yaw));
    grid.Add(scene_.objects.back().mesh);
  }
}

void Simulation::AddDistractors(const Assets& assets, ColumnGrid& grid) {
  const auto seed = static_cast<std::uint64_t>(scenario_.seed);
  for (std::size_t i = 0; i < scenario_.distractors.size(); ++i) {
    Random random = Random::Stream(seed, "distractor-" + std::to_string(i));
    const std::string& kind = scenario_.distractors[i];
    if (kind == kResting || kind == kSeated) {
      auto person =
          (kind == kResting ? MakeRestingPerson : MakeSeatedPerson)(assets.humans, scene_, random);
      if (!person) continue;  // neither bed nor sofa nor chair here
      grid.Add(person->mesh);
      scene_.objects.push_back(std::move(*person));
      continue;
    }
    Distractor distractor =
        MakeDistractor(kind, assets.furniture, assets.humans, scenario_.furniture_pool, random);
    CoverInBlack(scenario_.black_cloth, Random::Stream(seed, "cover-" + std::to_string(i)),
                 distractor.mesh);
    const auto place = PlaceDistractor(distractor.mesh, grid, random);
    if (!place) continue;  // a full room stays as it is
    SceneObject object =
        PlaceObject(distractor.category, distractor.name, std::move(distractor.mesh),
                    {place->position.x(), place->position.y(), 0}, place->yaw);
    grid.Add(object.mesh);
    scene_.objects.push_back(std::move(object));
  }
}

void Simulation::LetGetUp(const Assets& assets, ColumnGrid& grid) {
  Random random = Random::Stream(static_cast<std::uint64_t>(scenario_.seed), "gets_up");
  later_.emplace();
  later_->scene = scene_;
  std::vector<SceneObject>& objects = later_->scene.objects;
  const std::string name = objects[*person_].name;
  objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(*person_));
  TriangleMesh standing = MakeStandingPerson(assets.humans, DressedBody(scenario_), random);
  const auto place =
      PlaceOnFloor(standing, Placement::kFree, std::nullopt, grid, later_->scene, random);
  if (!place) return;
  objects.push_back(PlaceObject(kStandingPerson, name, std::move(standing),
                                {place->position.x(), place->position.y(), 0}, place->yaw));
  grid.Add(objects.back().mesh);
}

bool Simulation::IsSomebodyLying(int index) const {
  return person_ && (!later_ || index < *scenario_.gets_up_after_s * scenario_.rate_hz);
}

const Scene& Simulation::SceneAt(int index) const {
  return later_ && !IsSomebodyLying(index) ? later_->scene : scene_;
}

const RayCaster& Simulation::CasterAt(int index) const {
  return later_ && !IsSomebodyLying(index) ? *later_->caster : *caster_;
}

std::optional<FloorPose> Simulation::PlaceDistractor(const TriangleMesh& mesh,
                                                     const ColumnGrid& grid, Random& random) const {
  const Placement placement = random.Chance(0.3) ? Placement::kTouching : Placement::kFree;
  const bool near = scenario_.distractors_near && person_;
  constexpr int kTries = 25;
  std::optional<FloorPose> best;
  double best_distance = 1e9;
  for (int i = 0; i < (near ? kTries : 1); ++i) {
    const auto place = PlaceOnFloor(mesh, placement, std::nullopt, grid, scene_, random);
    if (!place) continue;
    const double distance =
        near ? (place->position - scene_.objects[*person_].box.center.head<2>()).norm() : 0;
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = place;
  }
  return best;
}

const SceneObject* Simulation::DrawTarget(Random random) const {
  if (person_) return &scene_.objects[*person_];
  std::vector<const SceneObject*> candidates;
  for (const SceneObject& object : scene_.objects)
    if (object.category != kFurniture) candidates.push_back(&object);
  return candidates.empty() ? nullptr : random.Pick(candidates);
}

Frame Simulation::TakeFrame(int index) const {
  const auto i = static_cast<std::size_t>(index);
  Frame frame;
  frame.utime = kEpochUtime + std::llround(index / scenario_.rate_hz * 1e6);
  frame.true_pose = path_[i];
  frame.told_pose = told_path_[i];
  const std::uint64_t seed = MixBits(MixBits(static_cast<std::uint64_t>(scenario_.seed)) + i);
  frame.image =
      TakePicture(CasterAt(index), sensor_.intrinsics,
                  ToTransform(frame.true_pose) * true_T_robot_camera_, sensor_.config, seed);
  return frame;
}

double Simulation::VisibleShare(int index) const {
  if (!IsSomebodyLying(index)) return 0;
  constexpr int kWidth = 160;  // [px], the view's quarter or half
  CameraIntrinsics intrinsics = sensor_.intrinsics;
  const double scale = static_cast<double>(kWidth) / intrinsics.width;
  intrinsics.width = kWidth;
  intrinsics.height = kWidth * 3 / 4;
  intrinsics.fx *= scale;
  intrinsics.fy *= scale;
  intrinsics.cx *= scale;
  intrinsics.cy *= scale;
  const Eigen::Isometry3d T_world_camera =
      ToTransform(path_[static_cast<std::size_t>(index)]) * true_T_robot_camera_;
  const auto count = [&](const RayCaster& caster, std::uint8_t label) {
    const IdealView view = caster.Render(intrinsics, T_world_camera, {}, {0, 0, 0});
    return std::count(view.label.begin(), view.label.end(), label);
  };
  Scene alone;
  alone.shell = MakeBox({0.01, 0.01, 0.01});  // a tree needs a shell, out of the way
  alone.shell.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, -1)));
  alone.objects.push_back(scene_.objects[*person_]);
  const auto whole = count(RayCaster(alone), 1);
  const auto seen = count(*caster_, static_cast<std::uint8_t>(*person_ + 1));
  return whole == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(whole);
}

}  // namespace fallen::sim
