// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Calibrated probabilities and operating points.
///
/// [Platt99] Platt: Probabilistic outputs for support vector machines and comparisons to
/// regularized
///           likelihood methods. Advances in Large Margin Classifiers, 1999.
/// [Lin07]   Lin, Lin, Weng: A note on Platt's probabilistic outputs for support vector machines.
///           Machine Learning 68, 2007.
namespace fallen {

/// From the evidence for a person to p(fallen person | evidence), and from a wanted rate of false
/// positives to a threshold on it (the paper, Sec. III-F; the idea is of its reference [28]).
///
/// Evidence is any number that is greater for what looks more like a person: MahalanobisEvidence,
/// or the score of a classifier. p rises strictly with it, so that clusters far beyond those seen
/// in training still rank, and no two tie that differ.
struct Calibration {
  double slope = 1;      ///< of the logit in the evidence, > 0
  double intercept = 0;  ///< of the logit

  /// Operating points measured on the validation set: threshold on p against false positives per
  /// frame, both ascending in strictness (thresholds up, rates down).
  struct OperatingPoint {
    double min_probability = 0.5;
    double false_positives_per_frame = 0;
    double miss_rate = 0;
    bool operator==(const OperatingPoint&) const = default;
  };
  std::vector<OperatingPoint> operating_points;

  /// p(fallen | evidence), in (0, 1).
  /// @throws std::invalid_argument if the evidence is not finite.
  double Probability(double evidence) const;

  /// Lowest threshold on p whose measured rate is at most `false_positives_per_frame`; the
  /// strictest operating point if none is. @throws std::invalid_argument without operating points.
  double MinProbability(double false_positives_per_frame) const;

  /// @throws std::invalid_argument unless the slope is positive, all values are in range and the
  /// operating points get stricter from one to the next. None at all is valid: not yet measured.
  void Validate() const;
  bool operator==(const Calibration&) const = default;
};

/// The evidence that a Mahalanobis distance gives: -log d, so that a ratio of distances always
/// counts the same.
/// @throws std::invalid_argument if the distance is negative or not finite.
double MahalanobisEvidence(double distance);

/// Fits slope and intercept by maximum likelihood (Platt's targets against over-confidence).
/// [Platt99], computed as [Lin07]. Without operating points: those are measured on frames.
/// @throws std::invalid_argument if sizes disagree, a value is not finite, one class is missing, or
/// persons have no more evidence than others (the slope would not be positive).
/// Deterministic.
Calibration FitCalibration(std::span<const double> evidence,
                           std::span<const std::uint8_t> is_person);

}  // namespace fallen
