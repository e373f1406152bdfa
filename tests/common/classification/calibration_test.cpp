// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

struct Labelled {
  std::vector<double> evidence;
  std::vector<std::uint8_t> is_person;
};

Labelled Draw(int count, double slope, double intercept, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform_evidence(-5, 0);
  std::uniform_real_distribution<double> uniform(0, 1);
  Labelled data;
  for (int i = 0; i < count; ++i) {
    const double x = uniform_evidence(random);
    data.evidence.push_back(x);
    data.is_person.push_back(uniform(random) < 1 / (1 + std::exp(-slope * x - intercept)));
  }
  return data;
}

TEST(FitCalibration, RecoversTheParametersThatMadeTheData) {
  const Labelled data = Draw(40000, 3, 8, 1);
  const Calibration calibration = FitCalibration(data.evidence, data.is_person);
  // Standard error of the slope with so many samples: about 0.04.
  EXPECT_NEAR(calibration.slope, 3, 0.15);
  EXPECT_NEAR(calibration.intercept, 8, 0.4);
  EXPECT_TRUE(calibration.operating_points.empty());
}

TEST(FitCalibration, IsAMaximumOfTheLikelihoodWithPlattsTargets) {
  const Labelled data = Draw(60, 2, 5, 2);
  const Calibration fitted = FitCalibration(data.evidence, data.is_person);
  double persons = 0;
  for (const std::uint8_t flag : data.is_person) persons += flag;
  const double high = (persons + 1) / (persons + 2), low = 1 / (60 - persons + 2);
  const auto log_likelihood = [&](double slope, double intercept) {
    double sum = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      const double p = 1 / (1 + std::exp(-slope * data.evidence[i] - intercept));
      const double target = data.is_person[i] ? high : low;
      sum += target * std::log(p) + (1 - target) * std::log(1 - p);
    }
    return sum;
  };
  const double best = log_likelihood(fitted.slope, fitted.intercept);
  for (const double s : {-0.01, 0.0, 0.01})
    for (const double t : {-0.01, 0.0, 0.01})
      EXPECT_LE(log_likelihood(fitted.slope + s, fitted.intercept + t), best);
}

TEST(FitCalibration, StaysFiniteWhenTheClassesAreFarApart) {
  const std::vector<double> evidence{3, 2, 1, -1e6, -2e6, -3e6};
  const std::vector<std::uint8_t> is_person{1, 1, 1, 0, 0, 0};
  const Calibration calibration = FitCalibration(evidence, is_person);
  EXPECT_NO_THROW(calibration.Validate());
  EXPECT_GT(calibration.Probability(2), 0.5);
  EXPECT_LT(calibration.Probability(2), 0.95);  // three persons are no proof
  EXPECT_LT(calibration.Probability(-2e6), 0.5);
}

TEST(FitCalibration, RejectsOneClassAndBrokenValues) {
  const auto rejects = [](const std::vector<double>& d, const std::vector<std::uint8_t>& p) {
    EXPECT_THROW(FitCalibration(d, p), std::invalid_argument);
  };
  rejects({}, {});
  rejects({1, 2}, {1, 1});
  rejects({1, 2}, {0, 0});
  rejects({1, 2, 3}, {1, 0});
  rejects({1, std::nan("")}, {1, 0});
  rejects({1, std::numeric_limits<double>::infinity()}, {1, 0});
  rejects({1, 5}, {1, 0});        // persons with less than others
  rejects({1, 1, 1}, {1, 0, 1});  // nothing tells them apart
}

TEST(Calibration, ProbabilityRisesStrictlyWithEvidence) {
  Calibration calibration;
  calibration.slope = 4;
  calibration.intercept = 10;
  double before = 0;
  for (double evidence = -20; evidence < 5; evidence += 0.01) {
    const double p = calibration.Probability(evidence);
    EXPECT_LT(p, 1);
    EXPECT_GT(p, before);
    before = p;
  }
  EXPECT_NEAR(calibration.Probability(-2.5), 0.5, 1e-12);
  calibration.slope = 1e4;
  EXPECT_GT(calibration.Probability(-1e300), 0);
  EXPECT_LT(calibration.Probability(1e300), 1);
  EXPECT_THROW(calibration.Probability(std::nan("")), std::invalid_argument);
}

TEST(MahalanobisEvidence, FallsStrictlyWithDistanceAndHasATop) {
  EXPECT_NEAR(MahalanobisEvidence(std::exp(2.5)), -2.5, 1e-12);
  EXPECT_GT(MahalanobisEvidence(1), MahalanobisEvidence(1.01));
  EXPECT_TRUE(std::isfinite(MahalanobisEvidence(0)));
  EXPECT_THROW(MahalanobisEvidence(-1), std::invalid_argument);
  EXPECT_THROW(MahalanobisEvidence(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(Calibration, ChoosesTheLowestThresholdThatKeepsTheRate) {
  Calibration calibration;
  EXPECT_THROW(calibration.MinProbability(0.1), std::invalid_argument);
  calibration.operating_points = {
      {0.2, 1.0, 0.0}, {0.5, 0.1, 0.1}, {0.8, 0.1, 0.2}, {0.9, 0.02, 0.5}};
  EXPECT_NO_THROW(calibration.Validate());
  EXPECT_EQ(calibration.MinProbability(5), 0.2);
  EXPECT_EQ(calibration.MinProbability(0.5), 0.5);
  EXPECT_EQ(calibration.MinProbability(0.1), 0.5);
  EXPECT_EQ(calibration.MinProbability(0.05), 0.9);
  EXPECT_EQ(calibration.MinProbability(0.001), 0.9);  // the strictest there is
}

TEST(Calibration, ValidateRejectsValuesOutOfRange) {
  const auto rejects = [](auto&& change) {
    Calibration calibration;
    calibration.operating_points = {{0.2, 1.0, 0.0}, {0.5, 0.1, 0.1}};
    change(calibration);
    EXPECT_THROW(calibration.Validate(), std::invalid_argument);
  };
  rejects([](auto& c) { c.slope = 0; });
  rejects([](auto& c) { c.slope = std::nan(""); });
  rejects([](auto& c) { c.intercept = std::numeric_limits<double>::infinity(); });
  rejects([](auto& c) { c.operating_points[0].min_probability = -0.1; });
  rejects([](auto& c) { c.operating_points[1].min_probability = std::nan(""); });
  rejects([](auto& c) { c.operating_points[0].false_positives_per_frame = -1; });
  rejects([](auto& c) { c.operating_points[0].miss_rate = 1.5; });
  rejects([](auto& c) { c.operating_points[1].min_probability = 0.1; });
  rejects([](auto& c) { c.operating_points[1].false_positives_per_frame = 2; });
}

}  // namespace
}  // namespace fallen
