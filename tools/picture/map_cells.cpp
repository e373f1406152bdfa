// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/map_cells.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tools/picture/oblique_view.hpp"

namespace fallen {
namespace {

/// Where the light comes from (frame view): from above, the left, and the camera.
const Eigen::Vector3d kLight = Eigen::Vector3d(-0.45, 0.35, 0.82).normalized();
/// Brightness of a surface that the light only grazes.
constexpr double kAmbient = 0.62;

using Place = std::array<float, 3>;
Place PlaceOf(const Eigen::Vector3f& mean) { return {mean.x(), mean.y(), mean.z()}; }

double Brightness(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const Eigen::Vector3d normal = axes.eigenvectors().col(0);
  return kAmbient + (1 - kAmbient) * std::abs(normal.dot(kLight));
}

DrawnCell Draw(const NdtCell& cell, const Color& color, const Eigen::Isometry3d& T_view_map) {
  const Eigen::Matrix3d R = T_view_map.linear();
  const Eigen::Matrix3d covariance = R * cell.CovarianceMatrix().cast<double>() * R.transpose();
  return {T_view_map * cell.mean.cast<double>(), covariance, Shade(color, Brightness(covariance))};
}

}  // namespace

std::vector<DrawnCell> CellsToDraw(const FrameResult& result, const Eigen::Isometry3d& T_view_map) {
  std::map<Place, float> scores;
  for (const ScoredCell& scored : result.segmented.cells)
    scores[PlaceOf(scored.mean)] = scored.score;

  std::vector<DrawnCell> cells;
  const ForegroundMap& foreground = result.foreground;
  for (std::size_t i = 0; i < foreground.map.cells.size(); ++i) {
    const NdtCell& cell = foreground.map.cells[i];
    const auto score = scores.find(PlaceOf(cell.mean));
    Color color = palette::kUnscoredCell;
    if (!foreground.is_foreground[i]) color = palette::kBackgroundCell;
    if (score != scores.end()) color = ScoreColor(score->second);
    cells.push_back(Draw(cell, color, T_view_map));
  }
  std::stable_sort(cells.begin(), cells.end(), [](const DrawnCell& a, const DrawnCell& b) {
    return ObliqueView::Depth(a.mean) > ObliqueView::Depth(b.mean);
  });
  return cells;
}

}  // namespace fallen
