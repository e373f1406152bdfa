// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/gas_network.hpp"

#include <algorithm>
#include <cassert>

namespace fallen {

GasNetwork::GasNetwork(const Unit& first, const Unit& second, const GrowingNeuralGasConfig& config)
    : config_(config),
      max_units_(config.max_units),
      units_(Codebook::Zero(config.max_units, first.size())),
      errors_(Eigen::VectorXd::Zero(config.max_units)),
      ages_(static_cast<std::size_t>(config.max_units) * static_cast<std::size_t>(config.max_units),
            kNoEdge) {
  assert(config.max_units >= 2 && first.size() == second.size());
  units_.row(0) = first.transpose();
  units_.row(1) = second.transpose();
  SetEdge(0, 1, 0);
}

void GasNetwork::Adapt(const Eigen::Ref<const Unit>& sample) {
  cosines_.noalias() = units() * sample;
  int winner = 0;
  int second = -1;
  for (int unit = 1; unit < unit_count_; ++unit) {
    if (cosines_[unit] > cosines_[winner]) {
      second = winner;
      winner = unit;
    } else if (second < 0 || cosines_[unit] > cosines_[second]) {
      second = unit;
    }
  }

  errors_[winner] += std::max(0.0, 1.0 - static_cast<double>(cosines_[winner]));
  MoveTowards(winner, sample, config_.winner_rate);
  for (int unit = 0; unit < unit_count_; ++unit) {
    if (Age(winner, unit) == kNoEdge) continue;
    MoveTowards(unit, sample, config_.neighbor_rate);
    SetEdge(winner, unit, Age(winner, unit) + 1);
  }
  SetEdge(winner, second, 0);

  // Only edges of the winner have aged: only they, and units at their ends, can fall away. The
  // winner keeps its edge to the second. From the back, so that removal does not skip a unit.
  for (int unit = unit_count_ - 1; unit >= 0; --unit) {
    if (Age(winner, unit) <= config_.max_edge_age) continue;
    SetEdge(winner, unit, kNoEdge);
    if (!IsIsolated(unit)) continue;
    if (winner == unit_count_ - 1) winner = unit;  // the last unit takes the removed one's place
    Remove(unit);
  }
  errors_.head(unit_count_) *= config_.error_decay;
}

void GasNetwork::Insert() {
  if (unit_count_ >= max_units_) return;
  int worst = 0;
  for (int unit = 1; unit < unit_count_; ++unit)
    if (errors_[unit] > errors_[worst]) worst = unit;
  const int neighbor = NeighborOfLargestError(worst);
  const Unit middle = (units_.row(worst) + units_.row(neighbor)).transpose();
  // Opposite units have no middle on the sphere; they are no neighbours in any sense either.
  if (!(middle.norm() > 0)) return;

  const int added = unit_count_++;
  units_.row(added) = middle.normalized().transpose();
  SetEdge(worst, neighbor, kNoEdge);
  SetEdge(worst, added, 0);
  SetEdge(neighbor, added, 0);
  errors_[worst] *= config_.insert_error_decay;
  errors_[neighbor] *= config_.insert_error_decay;
  errors_[added] = errors_[worst];
}

void GasNetwork::SetEdge(int a, int b, int age) {
  Age(a, b) = age;
  Age(b, a) = age;
}

void GasNetwork::MoveTowards(int unit, const Eigen::Ref<const Unit>& sample, double rate) {
  const auto weight = static_cast<float>(rate);
  const Unit moved = units_.row(unit).transpose() * (1 - weight) + sample * weight;
  const float norm = moved.norm();
  if (norm > 0) units_.row(unit) = moved.transpose() / norm;
}

bool GasNetwork::IsIsolated(int unit) const {
  for (int other = 0; other < unit_count_; ++other)
    if (edge_age(unit, other) != kNoEdge) return false;
  return true;
}

void GasNetwork::Remove(int unit) {
  const int last = --unit_count_;
  units_.row(unit) = units_.row(last);
  errors_[unit] = errors_[last];
  for (int other = 0; other < last; ++other) {
    SetEdge(unit, other, other == unit ? kNoEdge : Age(last, other));
    SetEdge(last, other, kNoEdge);
  }
}

int GasNetwork::NeighborOfLargestError(int unit) const {
  int largest = -1;
  for (int other = 0; other < unit_count_; ++other) {
    if (edge_age(unit, other) == kNoEdge) continue;
    if (largest < 0 || errors_[other] > errors_[largest]) largest = other;
  }
  return largest;
}

}  // namespace fallen
