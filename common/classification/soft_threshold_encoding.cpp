// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/soft_threshold_encoding.hpp"

#include <stdexcept>
#include <string>

#include "fallen/geometry/kept_vector.hpp"

namespace fallen {

Eigen::VectorXd EncodeCluster(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                              const Codebook& codebook, double alpha) {
  Eigen::VectorXd code;
  EncodeCluster(descriptors, codebook, alpha, code);
  return code;
}

void EncodeCluster(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                   const Codebook& codebook, double alpha, Eigen::VectorXd& code) {
  if (descriptors.rows() == 0)
    throw std::invalid_argument("soft_threshold_encoding: got no descriptor, must be >= 1");
  if (descriptors.cols() != codebook.cols())
    throw std::invalid_argument("soft_threshold_encoding: the descriptors have " +
                                std::to_string(descriptors.cols()) + " values, the codebook " +
                                std::to_string(codebook.cols()));
  code.setZero(codebook.rows());
  KeptVector<float> similarity_memory, unit_memory;
  similarity_memory.resize(codebook.rows());
  unit_memory.resize(codebook.cols());
  Eigen::Map<Eigen::VectorXf> similarities(similarity_memory.data(), codebook.rows());
  Eigen::Map<Eigen::VectorXf> unit(unit_memory.data(), codebook.cols());
  for (Eigen::Index i = 0; i < descriptors.rows(); ++i) {
    const float norm = descriptors.row(i).norm();
    if (norm == 0) continue;
    // One row at a time, not one product of matrices: that would add up in an order of its own.
    unit = descriptors.row(i).transpose() / norm;
    similarities.noalias() = codebook * unit;
    // [Coates11] Sec. 3.2; descriptors are not negative, so the encoder's other half is always
    // zero.
    code.array() += (similarities.array().cast<double>() - alpha).max(0.0);
  }
  code /= static_cast<double>(descriptors.rows());  // average pooling [Yang09]
}

}  // namespace fallen
