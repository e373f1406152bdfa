// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "fallen/classification/cluster_scene.hpp"
#include "fallen/geometry/kept_vector.hpp"
#include "fallen/geometry/oriented_box.hpp"

/// The parts that ComputeClusterFeatures is made of.
namespace fallen {

/// Two axes on the floor, and where they begin.
class FloorFrame {
 public:
  /// @param x_axis  Unit vector along the floor.
  FloorFrame(const Eigen::Vector2d& origin, const Eigen::Vector2d& x_axis)
      : origin_(origin), x_axis_(x_axis) {}

  Eigen::Vector2d Place(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d offset = p - origin_;
    return {offset.dot(x_axis_), x_axis_.x() * offset.y() - x_axis_.y() * offset.x()};
  }
  const Eigen::Vector2d& x_axis() const { return x_axis_; }

 private:
  Eigen::Vector2d origin_;
  Eigen::Vector2d x_axis_;
};

/// A member of a cluster, seen from the cluster.
struct PlacedCell {
  double along = 0;   ///< the main axis of the cells on the floor [m], 0 at their mean
  double across = 0;  ///< [m]
  float height = 0;   ///< above the floor [m]
  float score = 0;
};

/// A cluster with its members placed. Refers to what it is made from.
struct PlacedCluster {
  PlacedCluster(const ClusterScene& scene, const CellCluster& cluster, const OrientedBox& box);

  const ClusterScene& scene;
  const CellCluster& cluster;
  const OrientedBox& box;
  FloorFrame frame;            ///< main axis: towards the half with the higher mean
  double deviation_along = 0;  ///< standard deviations of the members' places [m]
  double deviation_across = 0;
  double least_along = 0;        ///< of the members
  double length = 0;             ///< greatest minus least `along`, not less than 1 mm
  KeptVector<PlacedCell> cells;  ///< as `cluster.cells`
};

/// Appends values to a row.
class FeatureRow {
 public:
  explicit FeatureRow(Eigen::RowVectorXf& values) : values_(values) {}
  template <class... Values>
  void Add(Values... values) {
    ((values_[next_++] = static_cast<float>(values)), ...);
  }
  void AddAll(std::span<const double> values) {
    for (const double value : values) Add(value);
  }

 private:
  Eigen::RowVectorXf& values_;
  Eigen::Index next_ = 0;
};

inline constexpr int kShapeColumns = 93;         ///< of AddShape
inline constexpr int kSurfaceColumns = 25;       ///< of AddSurface
inline constexpr int kSurroundingsColumns = 17;  ///< of AddSurroundings
inline constexpr int kLayerColumns = 80;         ///< of AddLayers
inline constexpr int kWholeColumns = 9;          ///< of AddWhole

/// Heights, outline, profile along the main axis.
void AddShape(const PlacedCluster& cluster, FeatureRow& row);
/// Normals, thickness and density of the members.
void AddSurface(const PlacedCluster& cluster, FeatureRow& row);
/// The other cells in the cluster's box and around it.
void AddSurroundings(const PlacedCluster& cluster, FeatureRow& row);
/// Ten layers of 5 cm, what is higher in the last.
void AddLayers(const PlacedCluster& cluster, FeatureRow& row);
/// The cluster that a part with `part_cells` members is a part of.
void AddWhole(const PlacedCluster& whole, std::size_t part_cells, FeatureRow& row);

}  // namespace fallen
