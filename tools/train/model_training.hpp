// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fallen/detection/model.hpp"
#include "tools/train/observation.hpp"
#include "tools/train/training_config.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// A trained model and the record of its training.
struct TrainedModel {
  Model model;
  nlohmann::json report;  ///< data, settings and figures on the validation split
};

/// Trains all parts: cells on the training recordings, then codebook and Gaussian on the clusters
/// that they make, then the calibration on the validation recordings.
/// @throws std::runtime_error if the recordings hold too little to learn from.
/// Deterministic; `jobs` changes nothing but the time.
TrainedModel TrainModel(const std::vector<ObservedRecording>& training,
                        const std::vector<ObservedRecording>& validation,
                        const TrainingConfig& config, double cell_size_m, int jobs,
                        const TrainingProgress& progress);

/// The report's main figures, for people.
std::string SummaryText(const nlohmann::json& report);

}  // namespace fallen
