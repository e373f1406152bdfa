// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "fallen/classification/cluster_feature_blocks.hpp"
#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

constexpr int kSlices = 6;      // of the length, whatever it is
constexpr int kSteps = 8;       // of equal length
constexpr double kStep = 0.25;  // [m]
constexpr int kHeightBins = 12;
constexpr float kHeightBin = 0.06F;       // [m]
constexpr double kFootprintRaster = 0.1;  // [m]; coarser than a cell, so that gaps of one close
constexpr float kLow = 0.12F;             // [m], about the thickness of a limb

template <std::size_t Size>
double& Bin(std::array<double, Size>& bins, double position) {
  return bins[std::clamp(static_cast<int>(std::floor(position)), 0, static_cast<int>(Size) - 1)];
}

void AddHeights(const PlacedCluster& cluster, FeatureRow& row) {
  KeptVector<float> heights;
  for (const PlacedCell& cell : cluster.cells) heights.push_back(cell.height);
  std::sort(heights.begin(), heights.end());
  const auto count = static_cast<double>(heights.size());
  double sum = 0, sum_of_squares = 0;
  for (const float height : heights) sum += height;
  const double mean = sum / count;
  for (const float height : heights) sum_of_squares += (height - mean) * (height - mean);
  row.Add(heights.front(), mean, heights.back(), std::sqrt(sum_of_squares / count),
          heights[heights.size() / 4], heights[heights.size() * 3 / 4]);

  std::array<double, kHeightBins> histogram{};
  for (const float height : heights) Bin(histogram, height / kHeightBin) += 1 / count;
  row.AddAll(histogram);
  row.Add(static_cast<double>(std::lower_bound(heights.begin(), heights.end(), kLow) -
                              heights.begin()) /
          count);
}

// What the members cover on the floor [m^2].
double FootprintArea(const PlacedCluster& cluster) {
  KeptVector<std::pair<int, int>> footprint;
  footprint.reserve(cluster.cells.size());
  for (const PlacedCell& cell : cluster.cells)
    footprint.emplace_back(static_cast<int>(std::floor(cell.along / kFootprintRaster)),
                           static_cast<int>(std::floor(cell.across / kFootprintRaster)));
  std::sort(footprint.begin(), footprint.end());
  footprint.erase(std::unique(footprint.begin(), footprint.end()), footprint.end());
  return static_cast<double>(footprint.size()) * kFootprintRaster * kFootprintRaster;
}

void AddOutline(const PlacedCluster& cluster, FeatureRow& row) {
  const Eigen::Vector3d& size = cluster.box.size;
  const double area = FootprintArea(cluster);
  row.Add(size.x(), size.y(), size.z(), size.y() / size.x());
  row.Add(cluster.deviation_along, cluster.deviation_across);
  row.Add(area, area / (size.x() * size.y()));
}

void AddSlices(const PlacedCluster& cluster, FeatureRow& row) {
  struct Slice {
    int count = 0;
    double highest = 0;
    double height_sum = 0;
    double score_sum = 0;
    double left = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
  };
  std::array<Slice, kSlices> slices;
  for (const PlacedCell& cell : cluster.cells) {
    const double share = (cell.along - cluster.least_along) / cluster.length;
    Slice& slice = slices[std::clamp(static_cast<int>(share * kSlices), 0, kSlices - 1)];
    ++slice.count;
    slice.highest = std::max<double>(slice.highest, cell.height);
    slice.height_sum += cell.height;
    slice.score_sum += cell.score;
    slice.left = std::min(slice.left, cell.across);
    slice.right = std::max(slice.right, cell.across);
  }
  for (const Slice& slice : slices) {
    if (slice.count == 0) {
      row.Add(0, 0, 0, 0, 0, 0);
      continue;
    }
    row.Add(slice.count / static_cast<double>(cluster.cells.size()), slice.highest,
            slice.height_sum / slice.count, slice.right - slice.left,
            (slice.right + slice.left) / 2, slice.score_sum / slice.count);
  }
}

void AddSteps(const PlacedCluster& cluster, FeatureRow& row) {
  std::array<double, kSteps> counts{};
  std::array<double, kSteps> highest{};
  for (const PlacedCell& cell : cluster.cells) {
    const double step = cell.along / kStep + kSteps / 2;
    Bin(counts, step) += 1;
    Bin(highest, step) = std::max<double>(Bin(highest, step), cell.height);
  }
  row.AddAll(counts);
  row.AddAll(highest);
}

void AddScores(const PlacedCluster& cluster, FeatureRow& row) {
  KeptVector<float> scores;
  double positive = 0;
  for (const PlacedCell& cell : cluster.cells) {
    scores.push_back(cell.score);
    positive += std::max(cell.score, 0.0F);
  }
  std::sort(scores.begin(), scores.end());
  for (const double quantile : {0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0})
    row.Add(scores[static_cast<std::size_t>(quantile * static_cast<double>(scores.size() - 1))]);
  double sum = 0, sum_of_squares = 0;
  for (const float score : scores) sum += score;
  const double mean = sum / static_cast<double>(scores.size());
  for (const float score : scores) sum_of_squares += (score - mean) * (score - mean);
  row.Add(mean, std::sqrt(sum_of_squares / static_cast<double>(scores.size())), positive);
}

void AddViewpoint(const PlacedCluster& cluster, FeatureRow& row) {
  const SegmentedMap& segmented = cluster.scene.segmented;
  const Eigen::Vector3d camera = segmented.T_map_camera.translation();
  const Eigen::Vector2d to_camera = (camera - cluster.box.center).head<2>();
  const double distance = to_camera.norm();
  row.Add(distance, segmented.ground.plane.SignedHeight(camera),
          distance > 0 ? std::abs(to_camera.dot(cluster.frame.x_axis())) / distance : 0.0);
}

}  // namespace

void AddShape(const PlacedCluster& cluster, FeatureRow& row) {
  AddHeights(cluster, row);
  AddOutline(cluster, row);
  AddSlices(cluster, row);
  AddSteps(cluster, row);
  AddScores(cluster, row);
  AddViewpoint(cluster, row);
}

void AddWhole(const PlacedCluster& whole, std::size_t part_cells, FeatureRow& row) {
  double score_sum = 0;
  float highest = whole.cells.front().height;
  for (const PlacedCell& cell : whole.cells) {
    score_sum += cell.score;
    highest = std::max(highest, cell.height);
  }
  const auto count = static_cast<double>(whole.cells.size());
  const Eigen::Vector3d& size = whole.box.size;
  const double area = FootprintArea(whole);
  row.Add(std::log(count), score_sum / count, highest, size.x(), size.y(), size.z(), area,
          area / (size.x() * size.y()), static_cast<double>(part_cells) / count);
}

}  // namespace fallen
