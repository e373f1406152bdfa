// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/background_subtraction.hpp"

#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace fallen {
namespace {

constexpr std::size_t kDimension = 3;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);  // FLANN's index of nothing found

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("background_subtraction: " + what);
}

void CheckThreshold(const char* name, double value) {
  if (!(value >= 0) || !std::isfinite(value))
    Fail(std::string(name) + " is " + std::to_string(value) + ", must be >= 0 and finite");
}

void CheckEnvironment(const EnvironmentMap& environment) {
  if (!(environment.cell_size_m > 0) || !std::isfinite(environment.cell_size_m))
    Fail("the environment map's cell_size_m is " + std::to_string(environment.cell_size_m) +
         ", must be > 0 and finite");
  for (std::size_t i = 0; i < environment.cells.size(); ++i) {
    const NdtCell& cell = environment.cells[i];
    const auto is_finite = [](float value) { return std::isfinite(value); };
    if (!cell.mean.allFinite() ||
        !std::all_of(cell.covariance.begin(), cell.covariance.end(), is_finite))
      Fail("cell " + std::to_string(i) + " of the environment map is not finite");
  }
}

// The paper, Sec. III-D.1: parallel normals give both parts, perpendicular ones the static part.
double Threshold(const BackgroundConfig& config, const Eigen::Vector3f& normal_environment,
                 const Eigen::Vector3f& normal_local) {
  const double cosine =
      std::abs(normal_environment.cast<double>().dot(normal_local.cast<double>()));
  const double angle = std::acos(std::min(cosine, 1.0));
  return (1 - 2 * angle / std::numbers::pi) * config.dynamic_threshold_m +
         config.static_threshold_m;
}

std::vector<float> Coordinates(const std::vector<NdtCell>& cells) {
  std::vector<float> coordinates;
  coordinates.reserve(kDimension * cells.size());
  for (const NdtCell& cell : cells)
    coordinates.insert(coordinates.end(), cell.mean.begin(), cell.mean.end());
  return coordinates;
}

flann::Matrix<float> Rows(std::vector<float>& coordinates) {
  return {coordinates.data(), coordinates.size() / kDimension, kDimension};
}

}  // namespace

void BackgroundConfig::Validate() const {
  CheckThreshold("static_threshold_m", static_threshold_m);
  CheckThreshold("dynamic_threshold_m", dynamic_threshold_m);
}

struct BackgroundSubtractor::Index {
  using Tree = flann::KDTreeSingleIndex<flann::L2_Simple<float>>;  // exact, and the same every time

  struct Neighbors {
    std::vector<std::size_t> indices;  // of the nearest environment cell, or kNone
    std::vector<float> sq_distances;
  };

  explicit Index(const EnvironmentMap& environment)
      : cell_size_m(environment.cell_size_m), coordinates(Coordinates(environment.cells)) {
    if (environment.cells.empty()) return;  // FLANN does not take an empty set
    for (const CellNormal& cell_normal : ComputeNormals(environment.cells))
      normals.push_back(cell_normal.normal);
    tree.emplace(Rows(coordinates));
    tree->buildIndex();
  }

  Neighbors NearestWithin(const std::vector<NdtCell>& cells, double radius_m) const {
    Neighbors nearest{std::vector<std::size_t>(cells.size(), kNone),
                      std::vector<float>(cells.size())};
    if (!tree || cells.empty()) return nearest;
    std::vector<float> queries = Coordinates(cells);
    flann::Matrix<std::size_t> indices(nearest.indices.data(), cells.size(), 1);
    flann::Matrix<float> sq_distances(nearest.sq_distances.data(), cells.size(), 1);
    flann::SearchParams parameters;
    parameters.max_neighbors = 1;  // a radius for FLANN to prune by, and of these only the nearest
    tree->radiusSearch(Rows(queries), indices, sq_distances,
                       static_cast<float>(radius_m * radius_m), parameters);
    return nearest;
  }

  double cell_size_m;
  std::vector<float> coordinates;  // the tree points into it
  std::vector<Eigen::Vector3f> normals;
  std::optional<Tree> tree;
};

BackgroundSubtractor::BackgroundSubtractor(const BackgroundConfig& config) : config_(config) {
  config_.Validate();
}

BackgroundSubtractor::BackgroundSubtractor(const EnvironmentMap& environment,
                                           const BackgroundConfig& config)
    : config_(config) {
  config_.Validate();
  CheckEnvironment(environment);
  index_ = std::make_unique<Index>(environment);
}

BackgroundSubtractor::~BackgroundSubtractor() = default;
BackgroundSubtractor::BackgroundSubtractor(BackgroundSubtractor&&) noexcept = default;
BackgroundSubtractor& BackgroundSubtractor::operator=(BackgroundSubtractor&&) noexcept = default;

bool BackgroundSubtractor::has_environment() const { return index_ != nullptr; }

ForegroundMap BackgroundSubtractor::Subtract(NdtMap map) const {
  ForegroundMap foreground;
  foreground.is_foreground.assign(map.cells.size(), 1);
  foreground.map = std::move(map);
  const std::vector<NdtCell>& cells = foreground.map.cells;
  if (!has_environment()) {
    foreground.status = BackgroundStatus::kNoEnvironmentMap;
    return foreground;
  }
  if (foreground.map.cell_size_m != index_->cell_size_m)
    Fail("the map's cell size is " + std::to_string(foreground.map.cell_size_m) +
         " m, the environment map's " + std::to_string(index_->cell_size_m) +
         " m: make an environment map of the same cell size");
  if (foreground.map.frame != MapFrame::kWorld) {
    foreground.status = BackgroundStatus::kNoPose;
    return foreground;
  }

  foreground.status = BackgroundStatus::kSubtracted;
  const Index::Neighbors nearest =
      index_->NearestWithin(cells, config_.static_threshold_m + config_.dynamic_threshold_m);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (nearest.indices[i] == kNone) continue;
    const double distance = std::sqrt(static_cast<double>(nearest.sq_distances[i]));
    // Normals decide only between the smallest and the largest threshold.
    const bool is_background =
        distance < config_.static_threshold_m ||
        distance < Threshold(config_, index_->normals[nearest.indices[i]],
                             ComputeNormals(std::span(&cells[i], 1)).front().normal);
    foreground.is_foreground[i] = !is_background;
  }
  return foreground;
}

}  // namespace fallen
