// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/mahalanobis.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

Eigen::MatrixXd Gaussian(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// [Ledoit04] Sec. 3.2 (Lemmas 3.2 to 3.5), sum by sum.
struct Transcription {
  Eigen::MatrixXd covariance;
  double shrinkage = 0;
};

double SqNorm(const Eigen::MatrixXd& a) {
  return (a * a.transpose()).trace() / static_cast<double>(a.rows());
}

Transcription LedoitWolf(const Eigen::MatrixXd& codes) {
  const Eigen::Index n = codes.rows(), p = codes.cols();
  const Eigen::RowVectorXd mean = codes.colwise().mean();
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(p, p);
  for (Eigen::Index k = 0; k < n; ++k)
    s += (codes.row(k) - mean).transpose() * (codes.row(k) - mean) / static_cast<double>(n);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(p, p);
  const double m = s.trace() / static_cast<double>(p);
  const double sq_d = SqNorm(s - m * identity);
  double sq_b_bar = 0;
  for (Eigen::Index k = 0; k < n; ++k)
    sq_b_bar += SqNorm((codes.row(k) - mean).transpose() * (codes.row(k) - mean) - s);
  sq_b_bar /= static_cast<double>(n) * static_cast<double>(n);
  const double sq_b = std::min(sq_b_bar, sq_d);
  const double sq_a = sq_d - sq_b;
  return {sq_b / sq_d * m * identity + sq_a / sq_d * s, sq_b / sq_d};
}

TEST(MahalanobisModel, AgreesWithADenseSolve) {
  std::mt19937 random(1);
  for (const Eigen::Index k : {1, 2, 7, 48, 128}) {
    const Eigen::MatrixXd factor = Gaussian(k, 2 * k, random);
    const Eigen::MatrixXd covariance = factor * factor.transpose();
    const Eigen::VectorXd mean = Gaussian(k, 1, random);
    const MahalanobisModel model(mean, covariance);
    for (int trial = 0; trial < 5; ++trial) {
      const Eigen::VectorXd x = 3 * Gaussian(k, 1, random);
      const Eigen::VectorXd d = x - mean;
      const double expected = std::sqrt(d.dot(covariance.fullPivLu().solve(d)));
      EXPECT_NEAR(model.Distance(x), expected, 1e-9 * expected);
    }
    EXPECT_EQ(model.Distance(mean), 0);
  }
}

TEST(MahalanobisModel, HasTheSameBitsWhenRebuiltFromItsValues) {
  std::mt19937 random(2);
  const MahalanobisModel model = FitMahalanobis(Gaussian(300, 64, random)).model;
  const MahalanobisModel rebuilt(model.mean(), model.covariance());
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd x = Gaussian(64, 1, random);
    EXPECT_EQ(rebuilt.Distance(x), model.Distance(x));
  }
}

TEST(MahalanobisModel, RejectsWhatIsNoDistribution) {
  const Eigen::Vector2d mean(0, 0);
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  EXPECT_NO_THROW(MahalanobisModel(mean, covariance));
  EXPECT_THROW(MahalanobisModel(Eigen::VectorXd(), Eigen::MatrixXd()), std::invalid_argument);
  EXPECT_THROW(MahalanobisModel(Eigen::Vector3d(0, 0, 0), covariance), std::invalid_argument);
  EXPECT_THROW(MahalanobisModel(Eigen::Vector2d(0, std::nan("")), covariance),
               std::invalid_argument);
  covariance(0, 1) = 0.5;
  EXPECT_THROW(MahalanobisModel(mean, covariance), std::invalid_argument);
  covariance << 1, 2, 2, 1;
  EXPECT_THROW(MahalanobisModel(mean, covariance), std::invalid_argument);
  covariance << 1, 0, 0, std::nan("");
  EXPECT_THROW(MahalanobisModel(mean, covariance), std::invalid_argument);
}

TEST(MahalanobisModel, RejectsCodesThatDoNotFit) {
  const MahalanobisModel model(Eigen::Vector2d(0, 0), Eigen::Matrix2d::Identity());
  EXPECT_THROW(model.Distance(Eigen::Vector3d(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(model.Distance(Eigen::Vector2d(0, std::nan(""))), std::invalid_argument);
  EXPECT_THROW(MahalanobisModel().Distance(Eigen::VectorXd()), std::invalid_argument);
}

TEST(FitMahalanobis, AgreesWithATranscriptionOfLedoitAndWolf) {
  std::mt19937 random(3);
  for (const auto& [n, p] :
       std::vector<std::pair<int, int>>{{3, 2}, {10, 30}, {50, 20}, {400, 8}}) {
    const Eigen::MatrixXd mixing = Gaussian(p, p, random);
    const Eigen::MatrixXd codes =
        (Gaussian(n, p, random) * mixing).rowwise() + Eigen::RowVectorXd::Constant(p, 5);
    const MahalanobisFit fit = FitMahalanobis(codes);
    const Transcription expected = LedoitWolf(codes);
    EXPECT_NEAR(fit.shrinkage, expected.shrinkage, 1e-9);
    const double scale = expected.covariance.cwiseAbs().maxCoeff();
    EXPECT_LT((fit.model.covariance() - expected.covariance).cwiseAbs().maxCoeff(), 1e-9 * scale);
    EXPECT_LT((fit.model.mean() - codes.colwise().mean().transpose()).norm(), 1e-12);
  }
}

TEST(FitMahalanobis, ShrinksFewSamplesMoreThanMany) {
  std::mt19937 random(4);
  Eigen::MatrixXd codes = Gaussian(5000, 10, random);
  for (int k = 0; k < 10; ++k) codes.col(k) *= k + 1;
  const MahalanobisFit many = FitMahalanobis(codes);
  EXPECT_LT(many.shrinkage, 0.01);
  for (int k = 0; k < 10; ++k)  // 5000 samples: 2 % standard error of a variance
    EXPECT_NEAR(many.model.covariance()(k, k) / ((k + 1) * (k + 1)), 1, k == 0 ? 0.4 : 0.1);
  EXPECT_GT(FitMahalanobis(codes.topRows(12)).shrinkage, 10 * many.shrinkage);
}

TEST(FitMahalanobis, IsPositiveDefiniteForTwoSamplesAndForDeadDimensions) {
  Eigen::MatrixXd two = Eigen::MatrixXd::Zero(2, 5);
  two.row(1).setConstant(2);
  EXPECT_TRUE(std::isfinite(FitMahalanobis(two).model.Distance(Eigen::VectorXd::Zero(5))));
  std::mt19937 random(5);
  Eigen::MatrixXd codes = Gaussian(500, 6, random);
  codes.col(2).setZero();  // a code word that no person ever uses
  const MahalanobisModel model = FitMahalanobis(codes).model;
  Eigen::VectorXd unusual = model.mean();
  unusual[2] += 0.5;
  EXPECT_GT(model.Distance(unusual), 1);
  const MahalanobisFit line = FitMahalanobis(Gaussian(10, 1, random));
  EXPECT_EQ(line.shrinkage, 1);  // in one dimension, a multiple of the identity is all there is
}

TEST(FitMahalanobis, RejectsTooFewAndEqualCodes) {
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd(0, 3)), std::invalid_argument);
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd::Ones(1, 3)), std::invalid_argument);
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd(3, 0)), std::invalid_argument);
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd::Constant(7, 3, 0.1)), std::invalid_argument);
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd::Zero(7, 3)), std::invalid_argument);
  EXPECT_THROW(FitMahalanobis(Eigen::MatrixXd::Constant(7, 3, std::nan(""))),
               std::invalid_argument);
}

}  // namespace
}  // namespace fallen
