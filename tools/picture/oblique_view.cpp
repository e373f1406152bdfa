// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/oblique_view.hpp"

#include <cmath>
#include <numbers>

namespace fallen {
namespace {

/// How far above the horizon the onlooker stands: the floor is seen, and heights are too.
constexpr double kElevation = 40 * std::numbers::pi / 180;

/// x ahead, y left, z up <- x right, y down, z ahead.
Eigen::Matrix3d LevelFromOptical() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R;
}

}  // namespace

Eigen::Isometry3d ViewFromMap(MapFrame frame, const Eigen::Isometry3d& T_map_camera) {
  Eigen::Isometry3d T_view_map = Eigen::Isometry3d::Identity();
  if (frame == MapFrame::kCamera) {
    T_view_map.linear() = LevelFromOptical();
    return T_view_map;
  }
  const Eigen::Vector3d ahead = T_map_camera.linear().col(2);
  const Eigen::Vector3d below(T_map_camera.translation().x(), T_map_camera.translation().y(), 0);
  const Eigen::Isometry3d T_map_view =
      Eigen::Translation3d(below) *
      Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ());
  return T_map_view.inverse();
}

ObliqueView::ObliqueView(double pixels_per_m, const Eigen::Vector2d& origin) : origin_(origin) {
  projection_ << 0, -1, 0,  //
      -std::sin(kElevation), 0, -std::cos(kElevation);
  projection_ *= pixels_per_m;
}

Eigen::Vector2d ObliqueView::Project(const Eigen::Vector3d& p_view) const {
  return origin_ + projection_ * p_view;
}

Eigen::Matrix2d ObliqueView::ProjectCovariance(const Eigen::Matrix3d& covariance_view) const {
  return projection_ * covariance_view * projection_.transpose();
}

double ObliqueView::Depth(const Eigen::Vector3d& p_view) {
  return std::cos(kElevation) * p_view.x() - std::sin(kElevation) * p_view.z();
}

}  // namespace fallen
