// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/soft_threshold_encoding.hpp"

#include <stdexcept>
#include <string>

namespace fallen {

Eigen::VectorXd EncodeCluster(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                              const Codebook& codebook, double alpha) {
  if (descriptors.rows() == 0)
    throw std::invalid_argument("soft_threshold_encoding: got no descriptor, must be >= 1");
  if (descriptors.cols() != codebook.cols())
    throw std::invalid_argument("soft_threshold_encoding: the descriptors have " +
                                std::to_string(descriptors.cols()) + " values, the codebook " +
                                std::to_string(codebook.cols()));
  Eigen::VectorXd code = Eigen::VectorXd::Zero(codebook.rows());
  Eigen::VectorXf similarities(codebook.rows());
  for (Eigen::Index i = 0; i < descriptors.rows(); ++i) {
    const float norm = descriptors.row(i).norm();
    if (norm == 0) continue;
    // One row at a time, not one product of matrices: that would add up in an order of its own.
    similarities.noalias() = codebook * (descriptors.row(i).transpose() / norm);
    // [Coates11] Sec. 3.2; descriptors are not negative, so the encoder's other half is always
    // zero.
    code.array() += (similarities.array().cast<double>() - alpha).max(0.0);
  }
  return code / static_cast<double>(descriptors.rows());  // average pooling [Yang09]
}

}  // namespace fallen
