// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_v_disparity.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fallen {
namespace {

// A floor at height h under a camera that looks down by the pitch t appears at row r (tangent of
// the angle below the optical axis, along the image's down) with the inverse depth
//   w = (r cos t + sin t) / h,
// the line that is looked for.
constexpr int kRows = 160;  // 3 pixels of a VGA image each
constexpr int kInverseDepths = 400;
constexpr double kMaxInverseDepth = 4;  // [1/m]: 0.25 m, nearer than any sensor measures
constexpr double kInverseDepthStep = kMaxInverseDepth / kInverseDepths;
constexpr double kPitchStep_rad = 0.02;
constexpr double kLogHeightStep = 0.03;     // 3 cm at 1 m, the default inlier distance
constexpr int kMaxLines = 12;               // longest lines that are tried
constexpr double kNoVerticalInImage = 0.1;  // camera within 6 degrees of straight down: no rows
constexpr int kLineFits = 5;

struct Line {
  double pitch_rad = 0;
  double height_m = 0;
};

// Down in the image, as a unit vector in (x, y).
using ImageDown = Eigen::Vector2d;

// The median roll of the surfaces that could be a floor: tables and shelves are level as well.
ImageDown DownFromSurfaces(const std::vector<GroundPoint>& level) {
  std::vector<double> rolls;
  rolls.reserve(level.size());
  for (const GroundPoint& point : level)
    rolls.push_back(std::atan2(-point.normal.x(), -point.normal.y()));
  const auto middle = rolls.begin() + static_cast<std::ptrdiff_t>(rolls.size() / 2);
  std::nth_element(rolls.begin(), middle, rolls.end());
  return {std::sin(*middle), std::cos(*middle)};
}

double RowOf(const GroundPoint& point, const ImageDown& down) {
  return point.ray.x() * down.x() + point.ray.y() * down.y();
}

// Rows x inverse depths, and what it takes to go between bins and values.
class VDisparity {
 public:
  VDisparity(const std::vector<GroundPoint>& level, const ImageDown& down)
      : counts_(static_cast<std::size_t>(kRows) * kInverseDepths) {
    first_row_ = RowOf(level.front(), down);
    double last_row = first_row_;
    for (const GroundPoint& point : level) {
      const double row = RowOf(point, down);
      first_row_ = std::min(first_row_, row);
      last_row = std::max(last_row, row);
    }
    row_step_ = std::max((last_row - first_row_) / kRows, 1e-6);
    for (const GroundPoint& point : level) {
      const int row =
          std::min(static_cast<int>((RowOf(point, down) - first_row_) / row_step_), kRows - 1);
      const double bin = point.inverse_depth / kInverseDepthStep;
      if (bin < kInverseDepths) ++counts_[Index(row, static_cast<int>(bin))];
    }
  }

  double RowValue(int row) const { return first_row_ + (row + 0.5) * row_step_; }
  static double InverseDepthValue(int bin) { return (bin + 0.5) * kInverseDepthStep; }
  int count(int row, int bin) const { return counts_[Index(row, bin)]; }

 private:
  static std::size_t Index(int row, int bin) {
    return static_cast<std::size_t>(row) * kInverseDepths + static_cast<std::size_t>(bin);
  }

  std::vector<int> counts_;
  double first_row_ = 0;
  double row_step_ = 0;
};

// Hough transform over pitch and logarithm of height; the longest lines first.
std::vector<Line> LongestLines(const VDisparity& histogram, double pitch_min, double pitch_max,
                               double height_min, double height_max) {
  const int pitches = static_cast<int>((pitch_max - pitch_min) / kPitchStep_rad) + 1;
  const double log_min = std::log(height_min);
  const int heights = static_cast<int>((std::log(height_max) - log_min) / kLogHeightStep) + 1;
  std::array<double, kInverseDepths> log_inverse_depth;
  for (int bin = 0; bin < kInverseDepths; ++bin)
    log_inverse_depth[static_cast<std::size_t>(bin)] = std::log(VDisparity::InverseDepthValue(bin));

  const auto cell = [&](int p, int h) { return static_cast<std::size_t>(p) * heights + h; };
  std::vector<int> votes(static_cast<std::size_t>(pitches) * heights);
  std::vector<double> log_drop(static_cast<std::size_t>(pitches));
  for (int row = 0; row < kRows; ++row) {
    for (int p = 0; p < pitches; ++p) {
      const double pitch = pitch_min + p * kPitchStep_rad;
      const double drop = histogram.RowValue(row) * std::cos(pitch) + std::sin(pitch);
      log_drop[static_cast<std::size_t>(p)] = drop > 0 ? std::log(drop) : -1e9;
    }
    for (int bin = 0; bin < kInverseDepths; ++bin) {
      const int count = histogram.count(row, bin);
      if (count == 0) continue;
      const double shift = log_inverse_depth[static_cast<std::size_t>(bin)] + log_min;
      for (int p = 0; p < pitches; ++p) {
        const double h = (log_drop[static_cast<std::size_t>(p)] - shift) / kLogHeightStep;
        if (h >= 0 && h < heights) votes[cell(p, static_cast<int>(h))] += count;
      }
    }
  }

  std::vector<Line> lines;
  for (int i = 0; i < kMaxLines; ++i) {
    const auto peak = std::max_element(votes.begin(), votes.end());
    if (*peak == 0) break;
    const int p = static_cast<int>((peak - votes.begin()) / heights);
    const int h = static_cast<int>((peak - votes.begin()) % heights);
    lines.push_back(
        {pitch_min + p * kPitchStep_rad, std::exp(log_min + (h + 0.5) * kLogHeightStep)});
    for (int dp = std::max(0, p - 2); dp <= std::min(pitches - 1, p + 2); ++dp)
      for (int dh = std::max(0, h - 2); dh <= std::min(heights - 1, h + 2); ++dh)
        votes[cell(dp, dh)] = 0;
  }
  return lines;
}

Plane PlaneFromLine(const Line& line, const ImageDown& down) {
  const double c = std::cos(line.pitch_rad);
  return {{-c * down.x(), -c * down.y(), -std::sin(line.pitch_rad)}, line.height_m};
}

// Reweighted least squares (Tukey) of inverse depth over rows.
Line FitLine(const std::vector<GroundPoint>& level, const ImageDown& down, const Line& start,
             double inlier_distance_m) {
  Line line = start;
  for (int fit = 0; fit < kLineFits; ++fit) {
    const Plane plane = PlaneFromLine(line, down);
    const double reach_m = (fit == 0 ? 3 : 2) * inlier_distance_m;  // the bins are coarse at first
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d vector = Eigen::Vector2d::Zero();
    for (const GroundPoint& point : level) {
      const double u = plane.SignedHeight(point.position.cast<double>()) / reach_m;
      if (std::abs(u) >= 1) continue;
      const double weight = (1 - u * u) * (1 - u * u);
      const Eigen::Vector2d row(RowOf(point, down), 1);
      information += weight * row * row.transpose();
      vector += weight * point.inverse_depth * row;
    }
    const Eigen::Vector2d slope_and_horizon = information.ldlt().solve(vector);
    const double length = slope_and_horizon.norm();
    if (!(length > 0) || !(slope_and_horizon(0) > 0)) return line;
    line = {std::atan2(slope_and_horizon(1), slope_and_horizon(0)), 1 / length};
  }
  return line;
}

}  // namespace

std::optional<Floor> FindFloorByVDisparity(const GroundScene& scene, const GroundPrior& prior,
                                           bool roll_known, const GroundConfig& config) {
  if (static_cast<int>(scene.level.size()) < MinInliers(scene, config)) return std::nullopt;
  const Eigen::Vector2d expected_down = -prior.up.head<2>();
  if (expected_down.norm() < kNoVerticalInImage) return std::nullopt;
  const ImageDown down = roll_known ? expected_down.normalized() : DownFromSurfaces(scene.level);

  const double expected_pitch = std::asin(std::clamp(-prior.up.z(), -1.0, 1.0));
  const std::vector<Line> lines =
      LongestLines(VDisparity(scene.level, down), expected_pitch - prior.max_tilt_rad,
                   expected_pitch + prior.max_tilt_rad, prior.min_height_m, prior.max_height_m);
  std::optional<Floor> best;
  for (const Line& line : lines) {
    const Line fitted = FitLine(scene.level, down, line, config.inlier_distance_m);
    const Plane plane = PlaneFromLine(fitted, down);
    if (!prior.Allows(plane)) continue;
    // The refinement in space takes out what roll is left.
    const std::optional<Floor> floor = AcceptFloor(scene, plane, prior, config);
    if (floor && (!best || floor->score > best->score)) best = floor;
  }
  return best;
}

}  // namespace fallen
