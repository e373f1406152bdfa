// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/cell_samples.hpp"

#include <algorithm>
#include <atomic>
#include <random>
#include <stdexcept>

#include "fallen/segmentation/parallel_for.hpp"

namespace fallen {
namespace {

struct FrameCells {
  std::vector<std::int32_t> person;
  std::vector<std::int32_t> other;
};

FrameCells EligibleCells(const ObservedFrame& frame, const TrainingConfig& config) {
  const double max_height_m = config.segmentation.max_height_m;
  const bool takes_others =
      config.sampling.positives == PositiveCells::kInScene || !frame.person_box;
  FrameCells cells;
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const Eigen::Vector3d mean = frame.map.cells[i].mean.cast<double>();
    if (frame.map.ground.ok() && frame.map.ground.plane.SignedHeight(mean) > max_height_m) continue;
    if (frame.labels[i] == CellLabel::kPerson) cells.person.push_back(static_cast<int>(i));
    if (frame.labels[i] == CellLabel::kOther && takes_others)
      cells.other.push_back(static_cast<int>(i));
  }
  return cells;
}

// Keeps each index with probability `share`.
std::vector<std::int32_t> Thin(const std::vector<std::int32_t>& indices, double share,
                               std::mt19937_64& random) {
  if (share >= 1) return indices;
  std::vector<std::int32_t> kept;
  for (const std::int32_t index : indices)
    if (static_cast<double>(random() >> 11) * 0x1.0p-53 < share) kept.push_back(index);
  return kept;
}

// What one frame gives.
struct FrameSamples {
  FeatureMatrix features;
  std::vector<std::int8_t> labels;
  IronDescriptors::Matrix person_descriptors;
};

FrameSamples SampleFrame(const ObservedFrame& observed, const TrainingConfig& config,
                         double person_share, double other_share, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const bool isolates =
      config.sampling.positives == PositiveCells::kIsolated && observed.person_box.has_value();
  const ObservedFrame alone = isolates ? IsolatePerson(observed) : ObservedFrame{};
  const ObservedFrame& frame = isolates ? alone : observed;
  const FrameCells eligible = EligibleCells(frame, config);
  const auto person = Thin(eligible.person, person_share, random);
  const auto other = Thin(eligible.other, other_share, random);
  std::vector<std::uint8_t> wanted(frame.map.cells.size(), 0);
  for (const std::int32_t i : person) wanted[i] = 1;
  for (const std::int32_t i : other) wanted[i] = 1;

  auto normals = ComputeNormals(frame.map.cells, config.iron);
  if (config.signs == NormalSigns::kOriented)
    OrientNormals(frame.map.cells, frame.map.T_map_camera.translation().cast<float>(), normals);
  const IronDescriptors descriptors =
      ComputeIronDescriptors(frame.map.cells, normals, wanted, config.iron, config.signs);
  FrameSamples samples;
  std::vector<std::int32_t> indices;
  for (const auto* part : {&person, &other})
    for (const std::int32_t i : *part) {
      if (!descriptors.valid(i)) continue;
      indices.push_back(i);
      samples.labels.push_back(part == &person ? 1 : -1);
    }
  samples.features =
      ComputeCellFeatures(frame.map, normals, descriptors, indices, config.sampling.features);
  const auto persons = std::count(samples.labels.begin(), samples.labels.end(), 1);
  samples.person_descriptors.resize(persons, config.iron.dimension());
  for (Eigen::Index row = 0; row < persons; ++row)
    samples.person_descriptors.row(row) = descriptors.values.row(indices[row]);
  return samples;
}

}  // namespace

CellSamples CollectCellSamples(std::span<const ObservedFrame* const> frames,
                               const TrainingConfig& config, int jobs,
                               const TrainingProgress& progress) {
  double person_cells = 0, other_cells = 0;
  for (const ObservedFrame* frame : frames) {
    const FrameCells cells = EligibleCells(*frame, config);
    person_cells += static_cast<double>(cells.person.size());
    other_cells += static_cast<double>(cells.other.size());
  }
  if (person_cells == 0 || other_cells == 0)
    throw std::runtime_error("training recordings hold " + std::to_string(person_cells) +
                             " cells of fallen persons and " + std::to_string(other_cells) +
                             " others, expected both: do the labels hold both?");
  const double person_share = config.sampling.max_person_cells / person_cells;
  const double other_share = config.sampling.max_other_cells / other_cells;

  std::vector<FrameSamples> parts(frames.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(frames.size()), jobs, [&](int i) {
    const auto seed = static_cast<std::uint64_t>(config.sampling.seed) * 1000003 + i;
    parts[i] = SampleFrame(*frames[i], config, person_share, other_share, seed);
    progress("descriptors", static_cast<double>(++done) / static_cast<double>(frames.size()));
  });

  Eigen::Index rows = 0, person_rows = 0;
  for (const FrameSamples& part : parts) {
    rows += part.features.rows();
    person_rows += part.person_descriptors.rows();
  }
  CellSamples samples;
  samples.features.resize(rows, CellFeatureCount(config.iron, config.sampling.features));
  samples.person_descriptors.resize(person_rows, config.iron.dimension());
  rows = person_rows = 0;
  for (FrameSamples& part : parts) {
    samples.features.middleRows(rows, part.features.rows()) = part.features;
    samples.person_descriptors.middleRows(person_rows, part.person_descriptors.rows()) =
        part.person_descriptors;
    samples.labels.insert(samples.labels.end(), part.labels.begin(), part.labels.end());
    rows += part.features.rows();
    person_rows += part.person_descriptors.rows();
    part = {};
  }
  const auto others = static_cast<double>(rows - person_rows);
  samples.weights.reserve(samples.labels.size());
  for (const std::int8_t label : samples.labels)
    samples.weights.push_back(
        static_cast<float>(0.5 / (label > 0 ? static_cast<double>(person_rows) : others)));
  return samples;
}

}  // namespace fallen
