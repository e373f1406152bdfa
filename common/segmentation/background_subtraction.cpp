// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/background_subtraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "fallen/iron/neighbor_grid.hpp"
#include "fallen/simd/lanes.hpp"

namespace fallen {
namespace {

constexpr float kMinBucket_m = 0.05F;  // of the search grid, for thresholds near zero

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

std::vector<Eigen::Vector3f> MeansOf(const std::vector<NdtCell>& cells) {
  std::vector<Eigen::Vector3f> means;
  means.reserve(cells.size());
  for (const NdtCell& cell : cells) means.push_back(cell.mean);
  return means;
}

}  // namespace

void BackgroundConfig::Validate() const {
  CheckThreshold("static_threshold_m", static_threshold_m);
  CheckThreshold("dynamic_threshold_m", dynamic_threshold_m);
}

// The environment's cells in a grid: a search looks at the few buckets around a place, however
// large the map is.
struct BackgroundSubtractor::Index {
  Index(const EnvironmentMap& environment, const BackgroundConfig& config)
      : cell_size_m(environment.cell_size_m),
        radius_m(static_cast<float>(config.static_threshold_m + config.dynamic_threshold_m)),
        grid(MeansOf(environment.cells), std::max(radius_m, kMinBucket_m)) {
    normals.reserve(environment.cells.size());
    for (const CellNormal& cell_normal : ComputeNormals(environment.cells))
      normals.push_back(cell_normal.normal);
  }

  double cell_size_m;
  float radius_m;
  NeighborGrid grid;
  std::vector<Eigen::Vector3f> normals;
};

// Cells that have an environment cell near, so near that the normals decide. Gathered until they
// fill the lanes in which normals are computed.
struct BackgroundSubtractor::OpenCells {
  struct Match {
    std::size_t cell;
    std::int32_t nearest;  // environment cell
    double distance_m;
  };
  std::size_t count = 0;
  std::array<Match, kMostLanes> matches;
  std::array<NdtCell, kMostLanes> cells;
};

BackgroundSubtractor::BackgroundSubtractor(const BackgroundConfig& config) : config_(config) {
  config_.Validate();
}

BackgroundSubtractor::BackgroundSubtractor(const EnvironmentMap& environment,
                                           const BackgroundConfig& config)
    : config_(config) {
  config_.Validate();
  CheckEnvironment(environment);
  index_ = std::make_unique<Index>(environment, config_);
}

BackgroundSubtractor::~BackgroundSubtractor() = default;
BackgroundSubtractor::BackgroundSubtractor(BackgroundSubtractor&&) noexcept = default;
BackgroundSubtractor& BackgroundSubtractor::operator=(BackgroundSubtractor&&) noexcept = default;

bool BackgroundSubtractor::has_environment() const { return index_ != nullptr; }

ForegroundMap BackgroundSubtractor::Subtract(NdtMap map) const {
  ForegroundMap foreground;
  foreground.map = std::move(map);
  Subtract(foreground);
  return foreground;
}

void BackgroundSubtractor::Subtract(ForegroundMap& foreground) const {
  const std::vector<NdtCell>& cells = foreground.map.cells;
  foreground.is_foreground.assign(cells.size(), 1);
  if (!has_environment()) {
    foreground.status = BackgroundStatus::kNoEnvironmentMap;
    return;
  }
  if (foreground.map.cell_size_m != index_->cell_size_m)
    Fail("the map's cell size is " + std::to_string(foreground.map.cell_size_m) +
         " m, the environment map's " + std::to_string(index_->cell_size_m) +
         " m: make an environment map of the same cell size");
  if (foreground.map.frame != MapFrame::kWorld) {
    foreground.status = BackgroundStatus::kNoPose;
    return;
  }

  foreground.status = BackgroundStatus::kSubtracted;
  OpenCells open;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].mean.allFinite()) continue;
    // What is nearer than the smallest threshold is background, whichever cell it is near to.
    const NearestPoint nearest =
        index_->grid.FindNearest(cells[i].mean, index_->radius_m, config_.static_threshold_m);
    if (nearest.index < 0) continue;
    const double distance_m = std::sqrt(static_cast<double>(nearest.sq_distance));
    if (distance_m < config_.static_threshold_m) {
      foreground.is_foreground[i] = 0;
      continue;
    }
    open.matches[open.count] = {i, nearest.index, distance_m};
    open.cells[open.count] = cells[i];
    if (++open.count == open.cells.size()) DecideByNormals(open, foreground);
  }
  DecideByNormals(open, foreground);
}

// Normals decide only between the smallest and the largest threshold.
void BackgroundSubtractor::DecideByNormals(OpenCells& open, ForegroundMap& foreground) const {
  std::array<CellNormal, kMostLanes> normals;
  ComputeNormals(std::span(open.cells).first(open.count), IronConfig{},
                 std::span(normals).first(open.count));
  for (std::size_t k = 0; k < open.count; ++k) {
    const OpenCells::Match& match = open.matches[k];
    foreground.is_foreground[match.cell] =
        !(match.distance_m < Threshold(config_, index_->normals[match.nearest], normals[k].normal));
  }
  open.count = 0;
}

}  // namespace fallen
