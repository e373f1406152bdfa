// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/segmentation/boosted_trees.hpp"

namespace fallen {

/// Features cut into at most 256 bins each, so that a tree's split is searched in a histogram.
///
/// A value x lies in bin k if cuts[k - 1] < x <= cuts[k]: "bin <= k" and "x <= cuts[k]" agree, and
/// a tree that was grown on bins decides the same on values.
struct BinnedFeatures {
  std::size_t sample_count = 0;
  std::vector<std::vector<float>> cuts;  ///< per feature: ascending, one less than its bins
  std::vector<std::uint8_t> bins;        ///< column-major: feature * sample_count + sample

  int feature_count() const { return static_cast<int>(cuts.size()); }
  const std::uint8_t* column(int feature) const {
    return bins.data() + static_cast<std::size_t>(feature) * sample_count;
  }
};

/// Cuts between bins of about equal numbers of values; midway between the values they part. A value
/// that fills a bin by itself gets one by itself, and up to `max_bins` distinct values are all
/// parted.
/// @param sorted_values  Ascending and finite.
std::vector<float> QuantileCuts(std::span<const float> sorted_values, int max_bins);

/// Bins all columns of `features`, which must be finite.
BinnedFeatures BinFeatures(const Eigen::Ref<const FeatureMatrix>& features, int max_bins,
                           int threads);

}  // namespace fallen
