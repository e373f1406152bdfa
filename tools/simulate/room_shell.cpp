// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/room_shell.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace fallen::sim {
namespace {

constexpr double kThickness = 0.1;  // [m], of walls
constexpr double kBeyond = 4;       // [m], by which the floor goes on behind the walls

// Adds boxes in the frame of one wall: x along it, y out of the room, 0 at its inner face.
class Wall {
 public:
  Wall(TriangleMesh& shell, int number, const Eigen::Vector2d& room_size, double height)
      : shell_(shell), height_(height) {
    const bool along_x = number % 2 == 0;
    length_ = along_x ? room_size.x() : room_size.y();
    distance_ = (along_x ? room_size.y() : room_size.x()) / 2;
    yaw_ = number * std::numbers::pi / 2;
  }

  double length() const { return length_; }
  double height() const { return height_; }

  void Add(double x_low, double x_high, double y_low, double y_high, double z_low, double z_high,
           double albedo, double turn = 0) {
    if (x_high - x_low < 1e-3) return;
    TriangleMesh box = MakeBox({x_high - x_low, y_high - y_low, z_high - z_low}, albedo);
    // Turned about the end at x_low.
    const Eigen::Vector3d end(x_low, y_low, (z_low + z_high) / 2);
    const Eigen::Vector3d half((x_high - x_low) / 2, (y_high - y_low) / 2, 0);
    box.Transform((Eigen::AngleAxisd(yaw_, Eigen::Vector3d::UnitZ()) *
                   Eigen::Translation3d(end.x(), end.y() + distance_, end.z()) *
                   Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(half) *
                   Eigen::Affine3d::Identity())
                      .cast<float>());
    shell_.Append(box);
  }

 private:
  TriangleMesh& shell_;
  double length_ = 0, distance_ = 0, yaw_ = 0, height_;
};

void AddDoor(Wall& wall, double low, double high, double wall_albedo, Random& random) {
  const double top = random.Uniform(1.95, 2.1), leaf_albedo = random.Uniform(0.3, 0.9);
  wall.Add(low, high, 0, kThickness, top, wall.height(), wall_albedo);
  wall.Add(low, high, 0, kThickness, 0, random.Uniform(0.003, 0.025), random.Uniform(0.2, 0.7));
  const bool open = random.Chance(0.6);
  const double turn = open ? random.Uniform(0.5, 1.6) : 0;
  wall.Add(low, high, 0.04, 0.08, 0, top, leaf_albedo, turn);
  if (!open) return;
  const double behind = random.Uniform(1.0, 2.5), wide = random.Uniform(0.8, 2);
  wall.Add(low - wide, high + wide, behind, behind + kThickness, 0, wall.height(), wall_albedo);
  for (const double side : {low - wide, high + wide})
    wall.Add(side, side + kThickness, kThickness, behind, 0, wall.height(), wall_albedo);
}

void AddWindow(Wall& wall, Random& random) {
  // By day the sun outshines the projector and by night the pane sends nothing back.
  constexpr double kPaneAlbedo = 0.01;
  const double width = std::min(random.Uniform(0.8, 2.2), wall.length() * 0.8);
  const double low = random.Uniform(-wall.length() / 2, wall.length() / 2 - width);
  const double sill = random.Chance(0.25) ? 0.05 : random.Uniform(0.75, 1.0);
  wall.Add(low, low + width, -0.012, -0.002, sill, random.Uniform(1.9, 2.2), kPaneAlbedo);
}

void AddRug(TriangleMesh& shell, const Eigen::Vector2d& room_size, Random& random) {
  const Eigen::Vector2d most = 0.8 * room_size;
  const Eigen::Vector3d size(std::min(random.Uniform(0.7, 2.4), most.x()),
                             std::min(random.Uniform(0.5, 1.7), most.y()),
                             random.Uniform(0.004, 0.01));
  TriangleMesh rug = MakeBox(size, random.Uniform(0.05, 0.8));
  const Eigen::Vector2d reach = (room_size - size.head<2>()) / 2;
  const double x = random.Uniform(-reach.x(), reach.x()), y = random.Uniform(-reach.y(), reach.y());
  rug.Transform((Eigen::Translation3d(x, y, size.z() / 2) *
                 Eigen::AngleAxisd(random.Normal(0, 0.1), Eigen::Vector3d::UnitZ()) *
                 Eigen::Affine3d::Identity())
                    .cast<float>());
  shell.Append(rug);
}

}  // namespace

TriangleMesh MakeRoomShell(const Eigen::Vector2d& room_size, double height_m, Random& random) {
  TriangleMesh shell;
  const auto slab = [&](double middle, double albedo) {
    TriangleMesh box =
        MakeBox({room_size.x() + 2 * kBeyond, room_size.y() + 2 * kBeyond, kThickness}, albedo);
    box.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, static_cast<float>(middle))));
    shell.Append(box);
  };
  slab(-kThickness / 2, random.Uniform(0.12, 0.8));
  slab(height_m + kThickness / 2, random.Uniform(0.6, 0.9));
  const double wall_albedo = random.Uniform(0.4, 0.9), board_albedo = random.Uniform(0.2, 0.9);
  const double board = random.Chance(0.7) ? random.Uniform(0.05, 0.1) : 0;
  for (int number = 0; number < 4; ++number) {
    Wall wall(shell, number, room_size, height_m);
    const double half = wall.length() / 2;
    const auto solid = [&](double low, double high) {
      wall.Add(low, high, 0, kThickness, 0, height_m, wall_albedo);
      if (board > 0) wall.Add(low, high, -0.015, 0, 0, board, board_albedo);
    };
    const double width = random.Uniform(0.8, 1.05);
    if (random.Chance(0.4) && wall.length() > width + 0.3) {
      const double low = random.Uniform(-half + 0.1, half - width - 0.1);
      solid(-half - kThickness, low);
      solid(low + width, half + kThickness);
      AddDoor(wall, low, low + width, wall_albedo, random);
    } else {
      solid(-half - kThickness, half + kThickness);
      if (random.Chance(0.25)) AddWindow(wall, random);
    }
  }
  for (int i = random.Integer(0, 2); i > 0; --i) AddRug(shell, room_size, random);
  return shell;
}

}  // namespace fallen::sim
