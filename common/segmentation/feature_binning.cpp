// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/feature_binning.hpp"

#include <algorithm>

#include "fallen/segmentation/parallel_for.hpp"

namespace fallen {
namespace {

// A cut with low <= cut < high, although floats may have no value between the two.
float Between(float low, float high) {
  const float middle = low / 2 + high / 2;
  return middle >= low && middle < high ? middle : low;
}

}  // namespace

std::vector<float> QuantileCuts(std::span<const float> sorted_values, int max_bins) {
  struct Run {
    float value;
    std::size_t count;
  };
  std::vector<Run> runs;
  for (const float value : sorted_values) {
    if (runs.empty() || value != runs.back().value) runs.push_back({value, 0});
    ++runs.back().count;
  }

  std::vector<float> cuts;
  const bool part_all = runs.size() <= static_cast<std::size_t>(max_bins);
  std::size_t values_left = sorted_values.size();  // in this bin and the following ones
  std::size_t in_bin = 0;
  for (std::size_t r = 0; r + 1 < runs.size(); ++r) {
    in_bin += runs[r].count;
    const std::size_t bins_left = static_cast<std::size_t>(max_bins) - cuts.size();
    if (bins_left <= 1) break;
    const bool is_full = in_bin * bins_left >= values_left;
    const bool next_fills_one = runs[r + 1].count * bins_left >= values_left;
    if (!part_all && !is_full && !next_fills_one) continue;
    cuts.push_back(Between(runs[r].value, runs[r + 1].value));
    values_left -= in_bin;
    in_bin = 0;
  }
  return cuts;
}

BinnedFeatures BinFeatures(const Eigen::Ref<const FeatureMatrix>& features, int max_bins,
                           int threads) {
  BinnedFeatures binned;
  binned.sample_count = static_cast<std::size_t>(features.rows());
  binned.cuts.resize(static_cast<std::size_t>(features.cols()));
  binned.bins.resize(binned.sample_count * binned.cuts.size());
  ParallelFor(static_cast<int>(features.cols()), threads, [&](int feature) {
    const Eigen::VectorXf values = features.col(feature);
    std::vector<float> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const std::vector<float> cuts = QuantileCuts(sorted, max_bins);
    std::uint8_t* column =
        binned.bins.data() + static_cast<std::size_t>(feature) * binned.sample_count;
    std::transform(values.begin(), values.end(), column, [&](float value) {
      const auto cut = std::lower_bound(cuts.begin(), cuts.end(), value);
      return static_cast<std::uint8_t>(cut - cuts.begin());
    });
    binned.cuts[static_cast<std::size_t>(feature)] = cuts;
  });
  return binned;
}

}  // namespace fallen
