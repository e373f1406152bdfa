// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fallen/classification/growing_neural_gas.hpp"

/// Soft-threshold encoding and average pooling (the paper, Sec. III-E).
///
/// [Coates11] Coates, Ng: The importance of encoding versus training with sparse coding and vector
///            quantization. ICML 2011.
/// [Yang09]   Yang, Yu, Gong, Huang: Linear spatial pyramid matching using sparse coding. CVPR
/// 2009.
namespace fallen {

/// Code of a cluster: the mean over its descriptors x of f_k = max(0, cos(d_k, x) - alpha).
/// Zero descriptors give a zero code. Deterministic: rows are summed in their order, in double.
/// @throws std::invalid_argument if the dimensions disagree or there is no row.
Eigen::VectorXd EncodeCluster(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                              const Codebook& codebook, double alpha);
/// Likewise, into memory that is there.
void EncodeCluster(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                   const Codebook& codebook, double alpha, Eigen::VectorXd& code);

}  // namespace fallen
