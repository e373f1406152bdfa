// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace fallen {

/// Multivariate normal distribution of the cluster codes of fallen persons (the paper, Sec. III-F).
///
/// [Ledoit04] Ledoit, Wolf: A well-conditioned estimator for large-dimensional covariance matrices.
///            J. Multivariate Analysis 88, 2004.
class MahalanobisModel {
 public:
  /// Of no dimension; has no distances.
  MahalanobisModel() = default;
  /// @param mean        K values.
  /// @param covariance  K x K, symmetric positive definite.
  /// @throws std::invalid_argument if it is not, or sizes disagree, or a value is not finite.
  MahalanobisModel(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance);

  /// sqrt((x - mean)' covariance^-1 (x - mean)).
  /// @throws std::invalid_argument if `code` has another size than the mean or is not finite.
  double Distance(const Eigen::Ref<const Eigen::VectorXd>& code) const;

  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& covariance() const { return covariance_; }

 private:
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd lower_;  // Cholesky factor: covariance = lower lower'
};

/// A fitted model and how far its covariance was drawn towards a multiple of the identity.
struct MahalanobisFit {
  MahalanobisModel model;
  double shrinkage = 0;  ///< (0, 1], [Ledoit04]
};

/// Fits mean and shrunken covariance to `codes`, one a row.
/// @throws std::invalid_argument for fewer than two rows, codes that are all alike or not finite.
MahalanobisFit FitMahalanobis(const Eigen::Ref<const Eigen::MatrixXd>& codes);

}  // namespace fallen
