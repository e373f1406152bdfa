// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/growing_neural_gas.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "fallen/classification/gas_network.hpp"

namespace fallen {
namespace {

constexpr std::int64_t kProgressReports = 100;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("growing_neural_gas: " + what);
}

void CheckRate(const char* name, double value) {
  if (!(value > 0 && value < 1))
    Fail(std::string(name) + " is " + std::to_string(value) + ", must be in (0, 1)");
}

// The samples that have a direction, as unit vectors.
Codebook Directions(const Eigen::Ref<const IronDescriptors::Matrix>& samples) {
  if (!samples.allFinite()) Fail("a sample is not finite");
  Codebook directions(samples.rows(), samples.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < samples.rows(); ++i) {
    const float norm = samples.row(i).stableNorm();
    if (norm > 0) directions.row(count++) = samples.row(i) / norm;
  }
  directions.conservativeResize(count, Eigen::NoChange);
  return directions;
}

// A row of `directions` that differs from row `first`: a random one, or else the next that does.
Eigen::Index DrawOther(const Codebook& directions, Eigen::Index first, std::uint64_t draw) {
  const auto count = static_cast<std::uint64_t>(directions.rows());
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto candidate = static_cast<Eigen::Index>((draw % count + k) % count);
    if (directions.row(candidate) != directions.row(first)) return candidate;
  }
  Fail("all samples have the same direction, must be at least two");
}

// [Fritzke95] inserts every lambda samples. With many samples the last unit would then be old news
// for most of the training while the first ones were placed by a handful: growth is stretched to
// take half of the steps, the other half settles the full network.
std::int64_t InsertInterval(const GrowingNeuralGasConfig& config) {
  return std::max<std::int64_t>(config.insert_interval, config.steps / (2 * config.max_units));
}

}  // namespace

void GrowingNeuralGasConfig::Validate() const {
  if (max_units < 2 || max_units > 4096)
    Fail("max_units is " + std::to_string(max_units) + ", must be in [2, 4096]");
  if (steps < 1) Fail("steps is " + std::to_string(steps) + ", must be >= 1");
  if (insert_interval < 1)
    Fail("insert_interval is " + std::to_string(insert_interval) + ", must be >= 1");
  CheckRate("winner_rate", winner_rate);
  CheckRate("neighbor_rate", neighbor_rate);
  CheckRate("insert_error_decay", insert_error_decay);
  CheckRate("error_decay", error_decay);
  if (max_edge_age < 1) Fail("max_edge_age is " + std::to_string(max_edge_age) + ", must be >= 1");
}

Codebook TrainGrowingNeuralGas(const Eigen::Ref<const IronDescriptors::Matrix>& samples,
                               const GrowingNeuralGasConfig& config,
                               const std::function<void(double)>& progress) {
  config.Validate();
  const Codebook directions = Directions(samples);
  if (directions.rows() < 2)
    Fail("got " + std::to_string(directions.rows()) + " samples that are not zero, must be >= 2");

  // The standard fixes this generator's numbers, but not what its distributions make of them.
  std::mt19937_64 random(static_cast<std::uint64_t>(config.seed));
  const auto count = static_cast<std::uint64_t>(directions.rows());
  const auto first = static_cast<Eigen::Index>(random() % count);
  const Eigen::Index second = DrawOther(directions, first, random());
  GasNetwork network(directions.row(first).transpose(), directions.row(second).transpose(), config);

  const std::int64_t insert_interval = InsertInterval(config);
  const std::int64_t report_interval = std::max<std::int64_t>(1, config.steps / kProgressReports);
  for (std::int64_t step = 1; step <= config.steps; ++step) {
    network.Adapt(directions.row(static_cast<Eigen::Index>(random() % count)).transpose());
    if (step % insert_interval == 0) network.Insert();
    if (progress && step % report_interval == 0)
      progress(static_cast<double>(step) / static_cast<double>(config.steps));
  }
  return network.units();
}

}  // namespace fallen
