// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace fallen {

/// Red, green, blue and opacity, [0, 1] each.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;
};

/// 0xRRGGBB.
std::uint32_t PackColor(const Color& color);

/// `color` made darker (`factor` < 1).
Color Shade(const Color& color, double factor);

/// Colour of a depth: bright near, dark far (viridis, which also colour-blind people can read).
/// @param share  0 at the near end, 1 at the far end; clamped.
Color DepthColor(double share);

/// Scores beyond this, either way, all look the same: smoothed scores are rarely larger.
inline constexpr double kScoreColorRange = 0.25;

/// Colour of a cell's score: blue for the negative, grey for 0, red for the positive (a person).
Color ScoreColor(double score);

/// What stands for what in all pictures.
namespace palette {
inline constexpr Color kPaper{1, 1, 1};
inline constexpr Color kInk{0.13, 0.13, 0.13};
inline constexpr Color kFaintInk{0.45, 0.45, 0.45};
inline constexpr Color kGrid{0.86, 0.86, 0.86};
inline constexpr Color kNoDepth{0.16, 0.16, 0.18};
inline constexpr Color kBackgroundCell{0.75, 0.82, 0.78};  ///< known from the environment map
inline constexpr Color kUnscoredCell{0.80, 0.80, 0.80};    ///< without a descriptor
inline constexpr Color kPerson{0.84, 0.00, 0.22};          ///< box of an accepted person
inline constexpr Color kCandidate{0.95, 0.60, 0.00};       ///< box of another cluster
inline constexpr Color kTruth{0.10, 0.55, 0.20};           ///< box of the ground truth
}  // namespace palette

}  // namespace fallen
