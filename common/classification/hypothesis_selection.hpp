// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"

/// What all ways of judging clusters share.
namespace fallen {

/// Sorts hypotheses by probability, likeliest first (ties: as they came), and drops each whose
/// centroid lies nearer than `min_separation_m` [m], along the floor, to one that is kept. In
/// place.
void KeepBestOfEachPlace(std::vector<PersonHypothesis>& hypotheses, double min_separation_m);

/// The smallest upright box around points [m], as FitUprightBox of cells, and `margin_m` more on
/// each side. @throws std::invalid_argument without points.
OrientedBox FitUprightBox(std::span<const Eigen::Vector3d> points, double margin_m);

}  // namespace fallen
