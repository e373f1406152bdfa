// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/place_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fallen {
namespace {

// More are not kept: the one that says least goes. At 15 degrees two rounds are 48.
constexpr std::size_t kMaxViewpoints = 64;
// Nearer than this the direction to the camera means nothing [m].
constexpr double kMinDistance_m = 0.05;

}  // namespace

PlaceEvidence::Viewpoint& PlaceEvidence::FindOrAdd(const Eigen::Vector3d& camera_offset,
                                                   const AlarmConfig& config) {
  const double distance = std::max(camera_offset.norm(), kMinDistance_m);
  const Eigen::Vector3d direction = camera_offset / distance;
  const double min_cosine = std::cos(config.view_angle_deg * std::numbers::pi / 180);
  const double max_log_ratio = std::log(config.view_distance_ratio);
  Viewpoint* best = nullptr;
  double best_cosine = min_cosine;
  for (Viewpoint& viewpoint : viewpoints_) {
    const double cosine = viewpoint.direction.dot(direction);
    if (cosine < best_cosine) continue;
    if (std::abs(std::log(viewpoint.distance_m / distance)) > max_log_ratio) continue;
    best = &viewpoint;
    best_cosine = cosine;
  }
  if (best) return *best;
  if (viewpoints_.size() >= kMaxViewpoints)
    viewpoints_.erase(std::min_element(
        viewpoints_.begin(), viewpoints_.end(),
        [](const auto& a, const auto& b) { return std::abs(a.value) < std::abs(b.value); }));
  viewpoints_.push_back({direction, distance});
  return viewpoints_.back();
}

void PlaceEvidence::Add(double log_odds, const Eigen::Vector3d& camera_offset, double seconds,
                        const AlarmConfig& config) {
  Viewpoint& current = FindOrAdd(camera_offset, config);
  const double kept = std::exp(-seconds / config.memory_s);
  for (Viewpoint& viewpoint : viewpoints_)
    if (&viewpoint != &current) viewpoint.value *= kept;
  current.value += (1 - std::exp(-seconds / config.settle_s)) * (log_odds - current.value);
  current.has_supported = current.has_supported || log_odds > 0;
}

double PlaceEvidence::log_odds() const {
  double sum = 0;
  for (const Viewpoint& viewpoint : viewpoints_) sum += viewpoint.value;
  return sum;
}

int PlaceEvidence::supporting_views() const {
  return static_cast<int>(std::count_if(viewpoints_.begin(), viewpoints_.end(),
                                        [](const Viewpoint& v) { return v.has_supported; }));
}

}  // namespace fallen
