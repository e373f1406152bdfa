// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/calibration.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// Distances below it count as it: the logarithm needs a bottom. A cluster of the training set
// itself lies at about sqrt(code words).
constexpr double kMinDistance = 1e-9;
// Logits that still give a double inside (0, 1): 1 - 2^-52, and about the least normal number.
constexpr double kMaxLogit = 36;
constexpr double kMinLogit = -700;
// Newton's method of [Lin07]: its limits and constants.
constexpr int kMaxIterations = 100;
constexpr double kMinGradient = 1e-9;
constexpr double kMinStep = 1e-10;
constexpr double kRidge = 1e-12;
constexpr double kSufficientDecrease = 1e-4;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("calibration: " + what);
}

double Logistic(double logit) {
  if (logit >= 0) return 1 / (1 + std::exp(-logit));
  const double odds = std::exp(logit);
  return odds / (1 + odds);
}

struct LogisticSample {
  double x;
  double target;  // [0, 1]
};

// -log likelihood of (slope, intercept), in the form that does not overflow [Lin07].
double NegativeLogLikelihood(const std::vector<LogisticSample>& samples,
                             const Eigen::Vector2d& parameters) {
  double sum = 0;
  for (const auto& [x, target] : samples) {
    const double logit = parameters[0] * x + parameters[1];
    sum += std::max(logit, 0.0) - target * logit + std::log1p(std::exp(-std::abs(logit)));
  }
  return sum;
}

// [Lin07]: Newton's method with a line search that halves the step.
Eigen::Vector2d FitLogistic(const std::vector<LogisticSample>& samples,
                            const Eigen::Vector2d& start) {
  Eigen::Vector2d parameters = start;
  double value = NegativeLogLikelihood(samples, parameters);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = kRidge * Eigen::Matrix2d::Identity();
    for (const auto& [x, target] : samples) {
      const double p = Logistic(parameters[0] * x + parameters[1]);
      const Eigen::Vector2d direction(x, 1);
      gradient += (p - target) * direction;
      hessian += p * (1 - p) * direction * direction.transpose();
    }
    if (gradient.cwiseAbs().maxCoeff() < kMinGradient * static_cast<double>(samples.size())) break;
    const Eigen::Vector2d step = -hessian.inverse() * gradient;
    double scale = 1;
    for (; scale >= kMinStep; scale /= 2) {
      const Eigen::Vector2d candidate = parameters + scale * step;
      const double candidate_value = NegativeLogLikelihood(samples, candidate);
      if (candidate_value >= value + kSufficientDecrease * scale * gradient.dot(step)) continue;
      parameters = candidate;
      value = candidate_value;
      break;
    }
    if (scale < kMinStep) break;  // no step improves: as good as doubles can say
  }
  return parameters;
}

}  // namespace

double Calibration::Probability(double evidence) const {
  if (!std::isfinite(evidence)) Fail("the evidence is not finite");
  const double logit = slope * evidence + intercept;
  return Logistic(std::clamp(logit, kMinLogit, kMaxLogit));
}

double Calibration::MinProbability(double false_positives_per_frame) const {
  if (operating_points.empty()) Fail("there are no operating points to choose from");
  for (const OperatingPoint& point : operating_points)
    if (point.false_positives_per_frame <= false_positives_per_frame) return point.min_probability;
  return operating_points.back().min_probability;
}

void Calibration::Validate() const {
  if (!(slope > 0) || !std::isfinite(slope))
    Fail("slope is " + std::to_string(slope) + ", must be > 0 and finite");
  if (!std::isfinite(intercept)) Fail("intercept is not finite");
  for (std::size_t i = 0; i < operating_points.size(); ++i) {
    const OperatingPoint& point = operating_points[i];
    const std::string name = "operating point " + std::to_string(i);
    if (!(point.min_probability >= 0 && point.min_probability <= 1))
      Fail(name + " has min_probability " + std::to_string(point.min_probability) +
           ", must be in [0, 1]");
    if (!(point.false_positives_per_frame >= 0) || !std::isfinite(point.false_positives_per_frame))
      Fail(name + " has false_positives_per_frame " +
           std::to_string(point.false_positives_per_frame) + ", must be >= 0 and finite");
    if (!(point.miss_rate >= 0 && point.miss_rate <= 1))
      Fail(name + " has miss_rate " + std::to_string(point.miss_rate) + ", must be in [0, 1]");
    if (i == 0) continue;
    const OperatingPoint& before = operating_points[i - 1];
    if (point.min_probability < before.min_probability ||
        point.false_positives_per_frame > before.false_positives_per_frame)
      Fail(name + " is less strict than the one before it");
  }
}

double MahalanobisEvidence(double distance) {
  if (!(distance >= 0) || !std::isfinite(distance))
    Fail("a distance is " + std::to_string(distance) + ", must be >= 0 and finite");
  return -std::log(std::max(distance, kMinDistance));
}

Calibration FitCalibration(std::span<const double> evidence,
                           std::span<const std::uint8_t> is_person) {
  if (evidence.size() != is_person.size())
    Fail("got " + std::to_string(evidence.size()) + " values and " +
         std::to_string(is_person.size()) + " labels");
  const auto count = static_cast<double>(evidence.size());
  const auto persons = static_cast<double>(std::count_if(
      is_person.begin(), is_person.end(), [](std::uint8_t flag) { return flag != 0; }));
  if (persons == 0) Fail("no value is of a person");
  if (persons == count) Fail("all values are of persons");

  // [Platt99] Sec. 2.2: as if each class had been seen once more on the other side.
  const double person_target = (persons + 1) / (persons + 2);
  const double other_target = 1 / (count - persons + 2);
  std::vector<LogisticSample> samples;
  double mean = 0;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    if (!std::isfinite(evidence[i])) Fail("value " + std::to_string(i) + " is not finite");
    samples.push_back({evidence[i], is_person[i] ? person_target : other_target});
    mean += samples.back().x / count;
  }
  // Centred and scaled, so that Newton's steps are well conditioned.
  double variance = 0;
  for (LogisticSample& sample : samples) {
    sample.x -= mean;
    variance += sample.x * sample.x / count;
  }
  const double scale = variance > 0 ? std::sqrt(variance) : 1;
  for (LogisticSample& sample : samples) sample.x /= scale;
  const Eigen::Vector2d fitted =
      FitLogistic(samples, {0, std::log((persons + 1) / (count - persons + 1))});

  Calibration calibration;
  calibration.slope = fitted[0] / scale;
  calibration.intercept = fitted[1] - calibration.slope * mean;
  if (!(calibration.slope > 0))
    Fail("persons have no more evidence than others: slope is " +
         std::to_string(calibration.slope) + ", must be > 0");
  calibration.Validate();
  return calibration;
}

}  // namespace fallen
