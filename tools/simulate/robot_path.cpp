// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/robot_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGridCell = 0.05;  // [m]

double WrapAngle(double angle) { return std::remainder(angle, 2 * kPi); }

// Where the robot's middle may be.
class FreeSpace {
 public:
  FreeSpace(const PathConfig& config, const ColumnGrid& grid, const Eigen::Vector2d& room_size)
      : half_(room_size / 2),
        width_(static_cast<int>(room_size.x() / kGridCell)),
        height_(static_cast<int>(room_size.y() / kGridCell)) {
    constexpr double kStepOver = 0.04;  // rugs, cables
    const int reach = static_cast<int>(std::ceil(config.robot_radius_m / kGridCell));
    std::vector<char> blocked(static_cast<std::size_t>(width_ * height_), 0);
    free_.assign(blocked.size(), 1);
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        const double x = (column + 0.5) * kGridCell - half_.x(),
                     y = (row + 0.5) * kGridCell - half_.y();
        bool taken = false;
        for (const double dx : {-0.25, 0.25})
          for (const double dy : {-0.25, 0.25})
            taken |= grid.Blocked(x + dx * kGridCell, y + dy * kGridCell, kStepOver,
                                  config.robot_height_m);
        blocked[static_cast<std::size_t>(row * width_ + column)] = taken;
      }
    }
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        const bool at_wall =
            row < reach || column < reach || row + reach >= height_ || column + reach >= width_;
        if (at_wall) free_[static_cast<std::size_t>(row * width_ + column)] = 0;
        if (!blocked[static_cast<std::size_t>(row * width_ + column)]) continue;
        for (int dr = -reach; dr <= reach; ++dr)
          for (int dc = -reach; dc <= reach; ++dc)
            if (dr * dr + dc * dc <= reach * reach && row + dr >= 0 && row + dr < height_ &&
                column + dc >= 0 && column + dc < width_)
              free_[static_cast<std::size_t>((row + dr) * width_ + column + dc)] = 0;
      }
    }
    for (std::size_t i = 0; i < free_.size(); ++i)
      if (free_[i]) cells_.push_back(static_cast<int>(i));
  }

  bool Free(double x, double y) const {
    const int column = static_cast<int>(std::floor((x + half_.x()) / kGridCell));
    const int row = static_cast<int>(std::floor((y + half_.y()) / kGridCell));
    return column >= 0 && row >= 0 && column < width_ && row < height_ &&
           free_[static_cast<std::size_t>(row * width_ + column)];
  }
  bool empty() const { return cells_.empty(); }
  Eigen::Vector2d Draw(Random& random) const {
    const int cell = random.Pick(cells_);
    return {(cell % width_ + random.Uniform()) * kGridCell - half_.x(),
            (cell / width_ + random.Uniform()) * kGridCell - half_.y()};
  }

 private:
  Eigen::Vector2d half_;
  int width_, height_;
  std::vector<char> free_;
  std::vector<int> cells_;
};

// Drives from goal to goal: turns towards it, speeds up, brakes before what is in the way.
std::vector<RobotPose> Drive(const PathConfig& config, const FreeSpace& space,
                             const std::optional<Eigen::Vector2d>& target, Random& random) {
  constexpr double kReached = 0.25;          // [m] from a goal
  constexpr double kAcceleration = 0.5;      // [m/s^2]
  constexpr double kTurnAcceleration = 1.5;  // [rad/s^2]
  constexpr int kPatience = 15;  // frames of standing still before another goal is drawn
  const double step_s = 1 / config.rate_hz;
  const double cruise = random.Uniform(0.4, 1.0) * config.max_speed_m_s;
  const Eigen::Vector2d start = space.Draw(random);
  const auto draw_goal = [&]() -> Eigen::Vector2d {
    if (!target) return space.Draw(random);
    const double angle = random.Uniform(-kPi, kPi), distance = random.Uniform(0, 1.2);
    return *target + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  Eigen::Vector2d goal = draw_goal();
  RobotPose pose{start.x(), start.y(),
                 std::atan2(goal.y() - start.y(), goal.x() - start.x()) + random.Normal(0, 0.35)};
  double speed = 0, turn = 0;
  int standing = 0;
  std::vector<RobotPose> path;
  while (static_cast<int>(path.size()) < config.frames) {
    path.push_back(pose);
    const Eigen::Vector2d offset(goal.x() - pose.x, goal.y() - pose.y);
    const double heading_error = WrapAngle(std::atan2(offset.y(), offset.x()) - pose.yaw);
    const double ahead = std::max(0.15, speed * 0.8);
    const bool clear =
        space.Free(pose.x + ahead * std::cos(pose.yaw), pose.y + ahead * std::sin(pose.yaw));
    const double wanted_speed =
        clear && std::abs(heading_error) < 0.9 ? cruise * std::cos(heading_error) : 0;
    const double wanted_turn =
        std::clamp(1.5 * heading_error, -config.max_turn_rad_s, config.max_turn_rad_s);
    // Braking may be harder than speeding up: the robot must never touch anything.
    speed = clear ? std::clamp(wanted_speed, speed - 2 * kAcceleration * step_s,
                               speed + kAcceleration * step_s)
                  : std::min(wanted_speed, std::max(0.0, speed - 4 * kAcceleration * step_s));
    turn = std::clamp(wanted_turn, turn - kTurnAcceleration * step_s,
                      turn + kTurnAcceleration * step_s);
    RobotPose next = pose;
    next.yaw = WrapAngle(pose.yaw + turn * step_s);
    next.x += speed * step_s * std::cos(next.yaw);
    next.y += speed * step_s * std::sin(next.yaw);
    if (!space.Free(next.x, next.y)) {
      next.x = pose.x;
      next.y = pose.y;
      speed = 0;
    }
    standing = speed < 0.05 ? standing + 1 : 0;
    pose = next;
    if (offset.norm() < kReached || standing > kPatience) {
      goal = draw_goal();
      standing = 0;
    }
  }
  return path;
}

struct Distances {
  double nearest, farthest;  // [m]
};

// Whether something stands between the camera and what lies at the target.
bool Hidden(const PathConfig& config, const ColumnGrid& grid, const Eigen::Vector2d& eye,
            const Eigen::Vector2d& target, double target_reach) {
  constexpr double kStep = 0.04;  // [m]
  const double distance = (target - eye).norm();
  for (double s = 0.3; s < distance - target_reach; s += kStep) {
    const double share = s / distance;
    const Eigen::Vector2d p = eye + share * (target - eye);
    const double z = (1 - share) * config.camera_height_m + share * config.target_height_m;
    if (grid.Taken({p.x(), p.y(), z})) return true;
  }
  return false;
}

// Whether the target shows as much of itself as is wanted.
bool ShowsEnough(const PathConfig& config, const ColumnGrid& grid, const Eigen::Vector2d& eye,
                 const Eigen::Vector2d& target) {
  constexpr double kBodyLength = 0.7, kBodyWidth = 0.35;  // [m], from its middle, or its axis
  if (!config.half_hidden) return !Hidden(config, grid, eye, target, kBodyLength);
  return Hidden(config, grid, eye, target + *config.half_hidden, kBodyWidth) !=
         Hidden(config, grid, eye, target - *config.half_hidden, kBodyWidth);
}

// What a frame is worth in which the robot sees its target: 1 at the wanted distance.
double Worth(const PathConfig& config, const ColumnGrid& grid, const RobotPose& pose,
             const Eigen::Vector2d& target, const Distances& wanted) {
  constexpr double kNearest = 0.7, kFarthest = 4.8;  // [m], where there is something to see at all
  constexpr double kElsewhere = 0.4;                 // worth at another distance
  constexpr double kRim = 0.8;                       // of half the field of view
  const Eigen::Vector2d offset(target.x() - pose.x, target.y() - pose.y);
  const double bearing = std::abs(WrapAngle(std::atan2(offset.y(), offset.x()) - pose.yaw));
  const double distance = offset.norm();
  const double down = std::atan2(config.camera_height_m - config.target_height_m, distance);
  if (bearing > kRim * config.half_field_of_view_rad ||
      std::abs(down - config.camera_pitch_rad) > kRim * config.half_vertical_view_rad ||
      distance < kNearest || distance > kFarthest ||
      !ShowsEnough(config, grid, {pose.x, pose.y}, target))
    return 0;
  return distance > wanted.nearest && distance < wanted.farthest ? 1 : kElsewhere;
}

// Mean worth of the frames, plus a little for moving.
double Score(const PathConfig& config, const ColumnGrid& grid, const std::vector<RobotPose>& path,
             const Eigen::Vector2d& target, const Distances& wanted) {
  constexpr double kMovingWorth = 0.1;  // of the score, for each metre driven, up to two
  double worth = 0, driven = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    worth += Worth(config, grid, path[i], target, wanted);
    if (i > 0) driven += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  }
  return worth / static_cast<double>(path.size()) + kMovingWorth * std::min(driven, 2.0);
}

}  // namespace

std::vector<RobotPose> DrawPath(const PathConfig& config, const ColumnGrid& grid,
                                const Eigen::Vector2d& room_size,
                                const std::optional<Eigen::Vector2d>& target, Random& random) {
  const int drives = config.half_hidden ? 150 : 40;  // it is a rare view
  FreeSpace space(config, grid, room_size);
  if (space.empty()) {                 // a smaller robot may still get in
    constexpr double kSmallest = 0.1;  // [m]
    PathConfig narrower = config;
    narrower.robot_radius_m *= 0.6;
    if (narrower.robot_radius_m > kSmallest)
      return DrawPath(narrower, grid, room_size, target, random);
    return std::vector<RobotPose>(static_cast<std::size_t>(config.frames));
  }
  if (!target) return Drive(config, space, target, random);
  // From where a person fills the view to where there is little of one.
  constexpr Distances kDistances[] = {{0.9, 2.4}, {1.5, 3.2}, {2.2, 4.4}, {2.2, 4.4}};
  const Distances wanted = kDistances[random.Index(std::size(kDistances))];
  std::vector<RobotPose> best;
  double best_score = -1;
  for (int i = 0; i < drives; ++i) {
    std::vector<RobotPose> path = Drive(config, space, target, random);
    const double score = Score(config, grid, path, *target, wanted);
    if (score <= best_score) continue;
    best_score = score;
    best = std::move(path);
  }
  return best;
}

}  // namespace fallen::sim
