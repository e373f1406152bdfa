// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace fallen {
namespace {

constexpr int kSlices = 5;
constexpr float kFootprintRaster = 0.1F;  // [m]; coarser than a cell, so that gaps of one close
constexpr double kAround = 0.1;           // [m]
constexpr double kBeside = 0.4;           // [m]
constexpr double kAbove = 0.5;            // [m]
constexpr float kLow = 0.12F;             // [m], about the thickness of a limb
constexpr double kMinDistance = 1e-9;

// A cell's mean in the box's frame (x along, y across, origin at its centre) and above the floor.
struct PlacedCell {
  float along = 0;
  float across = 0;
  float height = 0;
};

class BoxFrame {
 public:
  BoxFrame(const OrientedBox& box, const Plane& ground)
      : center_(box.center.head<2>()),
        x_axis_(std::cos(box.yaw), std::sin(box.yaw)),
        ground_(ground) {}

  PlacedCell Place(const NdtCell& cell) const {
    const Eigen::Vector3d mean = cell.mean.cast<double>();
    const Eigen::Vector2d offset = mean.head<2>() - center_;
    return {static_cast<float>(offset.dot(x_axis_)),
            static_cast<float>(x_axis_.x() * offset.y() - x_axis_.y() * offset.x()),
            static_cast<float>(ground_.SignedHeight(mean))};
  }

 private:
  Eigen::Vector2d center_;
  Eigen::Vector2d x_axis_;
  Plane ground_;
};

// Appends values to a row.
class Row {
 public:
  explicit Row(Eigen::RowVectorXf& values) : values_(values) {}
  template <class... Values>
  void Add(Values... values) {
    ((values_[next_++] = static_cast<float>(values)), ...);
  }
  Eigen::Index next() const { return next_; }

 private:
  Eigen::RowVectorXf& values_;
  Eigen::Index next_ = 0;
};

struct Moments {
  double mean = 0;
  double deviation = 0;
};

Moments MomentsOf(const std::vector<float>& values) {
  double sum = 0, sum_of_squares = 0;
  for (const float value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const float value : values) sum_of_squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(sum_of_squares / static_cast<double>(values.size()))};
}

void AddScores(const SegmentedMap& segmented, const CellCluster& cluster, Row& row) {
  std::vector<float> scores;
  for (const std::int32_t i : cluster.cells) scores.push_back(segmented.cells[i].score);
  const Moments moments = MomentsOf(scores);
  row.Add(moments.mean, *std::max_element(scores.begin(), scores.end()), moments.deviation);
}

void AddHeights(const std::vector<PlacedCell>& cells, Row& row) {
  std::vector<float> heights;
  for (const PlacedCell& cell : cells) heights.push_back(cell.height);
  const Moments moments = MomentsOf(heights);
  std::sort(heights.begin(), heights.end());
  row.Add(heights.front(), moments.mean, heights.back(), moments.deviation,
          heights[heights.size() / 4], heights[heights.size() * 3 / 4]);
}

void AddOutline(const std::vector<PlacedCell>& cells, const OrientedBox& box, Row& row) {
  row.Add(box.size.x(), box.size.y(), box.size.z(), box.size.y() / box.size.x());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::set<std::pair<int, int>> footprint;
  for (const PlacedCell& cell : cells) {
    mean += Eigen::Vector2d(cell.along, cell.across);
    footprint.emplace(static_cast<int>(std::floor(cell.along / kFootprintRaster)),
                      static_cast<int>(std::floor(cell.across / kFootprintRaster)));
  }
  mean /= static_cast<double>(cells.size());
  double xx = 0, xy = 0, yy = 0;
  for (const PlacedCell& cell : cells) {
    const Eigen::Vector2d d = Eigen::Vector2d(cell.along, cell.across) - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double middle = (xx + yy) / 2;
  const double spread = std::hypot((xx - yy) / 2, xy);
  const auto count = static_cast<double>(cells.size());
  row.Add(std::sqrt((middle + spread) / count),
          std::sqrt(std::max(middle - spread, 0.0) / count));
  const double area = static_cast<double>(footprint.size()) * kFootprintRaster * kFootprintRaster;
  row.Add(area, area / (box.size.x() * box.size.y()));
}

void AddSurface(const SegmentedMap& segmented, const CellCluster& cluster, Row& row) {
  std::vector<NdtCell> cells;
  for (const std::int32_t i : cluster.cells) cells.push_back(segmented.cells[i].cell);
  const Eigen::Vector3f up = segmented.ground.plane.normal.cast<float>();
  double cosine_sum = 0, flatness_sum = 0, breadth_sum = 0;
  int level = 0, upright = 0;
  for (const CellNormal& normal : ComputeNormals(cells, segmented.iron)) {
    const float cosine = std::abs(normal.normal.dot(up));
    cosine_sum += cosine;
    level += cosine > 0.9F;
    upright += cosine < 0.3F;
    const Eigen::Vector3f& lambda = normal.eigenvalues;
    flatness_sum += lambda[1] > 0 ? lambda[0] / lambda[1] : 0.0F;
    breadth_sum += lambda[2] > 0 ? lambda[1] / lambda[2] : 0.0F;
  }
  const auto count = static_cast<double>(cells.size());
  row.Add(cosine_sum / count, level / count, upright / count, flatness_sum / count,
          breadth_sum / count);
}

void AddViewpoint(const SegmentedMap& segmented, const OrientedBox& box, Row& row) {
  const Eigen::Vector3d camera = segmented.T_map_camera.translation();
  row.Add((camera - box.center).head<2>().norm(), segmented.ground.plane.SignedHeight(camera));
}

void AddSurroundings(const SegmentedMap& segmented, const CellCluster& cluster,
                     const BoxFrame& frame, const OrientedBox& box, float lowest, float highest,
                     Row& row) {
  const Eigen::Vector2d half = box.size.head<2>() / 2;
  int within = 0, above = 0, below = 0, beside = 0;
  double score_sum = 0;
  auto member = cluster.cells.begin();  // ascending
  for (std::size_t i = 0; i < segmented.cells.size(); ++i) {
    if (member != cluster.cells.end() && *member == static_cast<std::int32_t>(i)) {
      ++member;
      continue;
    }
    const PlacedCell cell = frame.Place(segmented.cells[i].cell);
    const double out =
        std::max(std::abs(cell.along) - half.x(), std::abs(cell.across) - half.y());
    if (out > kBeside || cell.height > highest + kAbove) continue;
    if (out > kAround) {
      beside += cell.height <= highest;
    } else if (cell.height > highest) {
      ++above;
    } else if (cell.height < lowest) {
      ++below;
    } else {
      ++within;
      score_sum += segmented.cells[i].score;
    }
  }
  const auto own = static_cast<double>(cluster.cells.size());
  row.Add(within / own, above / own, below / own, beside / own,
          within > 0 ? score_sum / within : 0.0);
}

void AddProfile(const std::vector<PlacedCell>& cells, const OrientedBox& box, Row& row) {
  struct Slice {
    int count = 0;
    float highest = 0;
    float left = std::numeric_limits<float>::infinity();
    float right = -std::numeric_limits<float>::infinity();
  };
  std::array<Slice, kSlices> slices;
  int first_half = 0;
  for (const PlacedCell& cell : cells) {
    const double share = cell.along / box.size.x() + 0.5;
    Slice& slice = slices[std::clamp(static_cast<int>(share * kSlices), 0, kSlices - 1)];
    ++slice.count;
    slice.highest = std::max(slice.highest, cell.height);
    slice.left = std::min(slice.left, cell.across);
    slice.right = std::max(slice.right, cell.across);
    first_half += share < 0.5;
  }
  if (2 * first_half < static_cast<int>(cells.size())) std::reverse(slices.begin(), slices.end());
  for (const Slice& slice : slices)
    row.Add(slice.count / static_cast<double>(cells.size()), slice.highest,
            slice.count > 0 ? slice.right - slice.left : 0.0F);
}

}  // namespace

Eigen::RowVectorXf ComputeClusterFeatures(const SegmentedMap& segmented, const CellCluster& cluster,
                                          const OrientedBox& box, const Eigen::VectorXd& code,
                                          double mahalanobis_distance) {
  if (cluster.cells.empty())
    throw std::invalid_argument("cluster_features: the cluster has no cells");
  if (!segmented.ground.ok())
    throw std::invalid_argument("cluster_features: the map has no floor");
  const BoxFrame frame(box, segmented.ground.plane);
  std::vector<PlacedCell> cells;
  for (const std::int32_t i : cluster.cells) cells.push_back(frame.Place(segmented.cells[i].cell));
  const auto by_height = [](const PlacedCell& a, const PlacedCell& b) {
    return a.height < b.height;
  };
  const auto [lowest, highest] = std::minmax_element(cells.begin(), cells.end(), by_height);

  Eigen::RowVectorXf values(kClusterShapeFeatures + code.size());
  Row row(values);
  row.Add(std::log(static_cast<double>(cells.size())));
  AddScores(segmented, cluster, row);
  row.Add(std::log(std::max(mahalanobis_distance, kMinDistance)));
  AddHeights(cells, row);
  AddOutline(cells, box, row);
  AddSurface(segmented, cluster, row);
  AddViewpoint(segmented, box, row);
  AddSurroundings(segmented, cluster, frame, box, lowest->height, highest->height, row);
  AddProfile(cells, box, row);
  const auto low = std::count_if(cells.begin(), cells.end(),
                                 [](const PlacedCell& cell) { return cell.height < kLow; });
  row.Add(static_cast<double>(low) / static_cast<double>(cells.size()));
  values.tail(code.size()) = code.transpose().cast<float>();
  return values;
}

}  // namespace fallen
