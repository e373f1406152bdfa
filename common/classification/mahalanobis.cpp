// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/mahalanobis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

// Entries across the diagonal may differ by rounding, this much of the largest entry.
constexpr double kSymmetryTolerance = 1e-9;
// Least shrinkage: for very few samples [Ledoit04]'s estimate can be zero, which would leave the
// covariance singular.
constexpr double kMinShrinkage = 1e-6;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("mahalanobis: " + what);
}

}  // namespace

MahalanobisModel::MahalanobisModel(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance)
    : mean_(mean), covariance_(covariance) {
  const std::string size = std::to_string(mean.size());
  if (mean.size() == 0) Fail("the mean is empty");
  if (covariance.rows() != mean.size() || covariance.cols() != mean.size())
    Fail("the covariance is " + std::to_string(covariance.rows()) + " x " +
         std::to_string(covariance.cols()) + ", must be " + size + " x " + size);
  if (!mean.allFinite() || !covariance.allFinite()) Fail("a value is not finite");
  const double asymmetry = (covariance - covariance.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > kSymmetryTolerance * covariance.cwiseAbs().maxCoeff())
    Fail("the covariance is not symmetric");
  const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance_);
  if (cholesky.info() != Eigen::Success) Fail("the covariance is not positive definite");
  lower_ = cholesky.matrixL();
}

double MahalanobisModel::Distance(const Eigen::Ref<const Eigen::VectorXd>& code) const {
  if (code.size() != mean_.size() || mean_.size() == 0)
    Fail("the code has " + std::to_string(code.size()) + " values, the model " +
         std::to_string(mean_.size()));
  if (!code.allFinite()) Fail("a value of the code is not finite");
  // With covariance = L L', x' covariance^-1 x is the squared length of L^-1 x.
  KeptVector<double> memory;
  memory.resize(code.size());
  Eigen::Map<Eigen::VectorXd> solved(memory.data(), code.size());
  solved = code - mean_;
  lower_.triangularView<Eigen::Lower>().solveInPlace(solved);
  return solved.norm();
}

MahalanobisFit FitMahalanobis(const Eigen::Ref<const Eigen::MatrixXd>& codes) {
  if (codes.rows() < 2) Fail("got " + std::to_string(codes.rows()) + " codes to fit, must be >= 2");
  if (codes.cols() < 1) Fail("the codes are empty");
  if (!codes.allFinite()) Fail("a value of a code is not finite");

  // Names and normalisation of [Ledoit04] Sec. 3.2: the norm of a p x p matrix is divided by p, and
  // the sample covariance S by n.
  const auto n = static_cast<double>(codes.rows());
  const auto p = static_cast<double>(codes.cols());
  const Eigen::VectorXd mean = codes.colwise().mean();
  const Eigen::MatrixXd centered = codes.rowwise() - mean.transpose();
  const Eigen::MatrixXd sample = centered.transpose() * centered / n;
  const double m = sample.trace() / p;
  // Against the rounding of the mean: codes that are all alike leave no more than this.
  const double rounding = 1e-24 * codes.squaredNorm() / (n * p);
  if (!(m > rounding)) Fail("the codes are all alike");

  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(codes.cols(), codes.cols());
  const double sq_d = (sample - m * identity).squaredNorm() / p;
  // The mean of |x x' - S|^2 over the samples x: since S is the mean of x x', the mixed terms add
  // up to -2 |S|^2.
  const double spread = centered.rowwise().squaredNorm().array().square().sum() / n;
  const double sq_b_bar = (spread - sample.squaredNorm()) / (n * p);
  const double sq_b = std::clamp(sq_b_bar, 0.0, sq_d);

  MahalanobisFit fit;
  fit.shrinkage = sq_d > 0 ? std::max(sq_b / sq_d, kMinShrinkage) : 1.0;
  const Eigen::MatrixXd shrunken = fit.shrinkage * m * identity + (1 - fit.shrinkage) * sample;
  fit.model = MahalanobisModel(mean, (shrunken + shrunken.transpose()) / 2);
  return fit;
}

}  // namespace fallen
