// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/scene.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace fallen::sim {

OrientedBox BoxAround(const TriangleMesh& mesh, double yaw) {
  const Eigen::Matrix3f R_box_world =
      Eigen::AngleAxisf(static_cast<float>(-yaw), Eigen::Vector3f::UnitZ()).toRotationMatrix();
  Eigen::AlignedBox3f bounds;
  for (const Eigen::Vector3f& vertex : mesh.vertices) bounds.extend(R_box_world * vertex);
  OrientedBox box;
  box.center = (R_box_world.transpose() * bounds.center()).cast<double>();
  box.size = bounds.sizes().cast<double>();
  box.yaw = yaw;
  return box;
}

double MainAxisYaw(const TriangleMesh& mesh) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& vertex : mesh.vertices) mean += vertex.head<2>().cast<double>();
  mean /= static_cast<double>(mesh.vertices.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    const Eigen::Vector2d offset = vertex.head<2>().cast<double>() - mean;
    scatter += offset * offset.transpose();
  }
  const Eigen::Vector2d axis =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(1);
  return std::atan2(axis.y(), axis.x());
}

TriangleMesh MakeShell(const Eigen::Vector2d& room_size, double height_m) {
  constexpr double kThickness = 0.1;
  constexpr double kFloorAlbedo = 0.45, kWallAlbedo = 0.75;
  TriangleMesh shell;
  const auto add = [&](const Eigen::Vector3d& size, const Eigen::Vector3d& center, double albedo) {
    TriangleMesh box = MakeBox(size, albedo);
    box.Transform(Eigen::Affine3f(Eigen::Translation3f(center.cast<float>())));
    shell.Append(box);
  };
  const double x = room_size.x(), y = room_size.y();
  add({x + 2, y + 2, kThickness}, {0, 0, -kThickness / 2}, kFloorAlbedo);
  add({x + 2, y + 2, kThickness}, {0, 0, height_m + kThickness / 2}, kWallAlbedo);
  for (const double side : {-1.0, 1.0}) {
    add({kThickness, y + 2 * kThickness, height_m}, {side * (x + kThickness) / 2, 0, height_m / 2},
        kWallAlbedo);
    add({x + 2 * kThickness, kThickness, height_m}, {0, side * (y + kThickness) / 2, height_m / 2},
        kWallAlbedo);
  }
  return shell;
}

SceneObject PlaceObject(std::string category, std::string name, TriangleMesh mesh,
                        const Eigen::Vector3d& position, double yaw) {
  mesh.Transform(Eigen::Translation3f(position.cast<float>()) *
                 Eigen::AngleAxisf(static_cast<float>(yaw), Eigen::Vector3f::UnitZ()));
  const OrientedBox box = BoxAround(mesh, yaw);
  return {std::move(category), std::move(name), std::move(mesh), box};
}

}  // namespace fallen::sim
