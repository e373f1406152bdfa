// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/model_training.hpp"

#include <set>

#include "fallen/service/config_text.hpp"
#include "tools/train/cell_training.hpp"
#include "tools/train/cluster_training.hpp"
#include "tools/train/gate_training.hpp"

namespace fallen {
namespace {

std::vector<const ObservedFrame*> AllFrames(const std::vector<ObservedRecording>& recordings) {
  std::vector<const ObservedFrame*> frames;
  for (const ObservedRecording& recording : recordings)
    for (const ObservedFrame& frame : recording.frames) frames.push_back(&frame);
  return frames;
}

nlohmann::json DataReport(const std::vector<ObservedRecording>& recordings) {
  std::set<std::string> persons, rooms;
  std::int64_t frames = 0, positives = 0, damaged = 0;
  for (const ObservedRecording& recording : recordings) {
    if (!recording.origin.person.empty()) persons.insert(recording.origin.person);
    if (!recording.origin.room.empty()) rooms.insert(recording.origin.room);
    frames += static_cast<std::int64_t>(recording.frames.size());
    damaged += recording.damaged;
    for (const ObservedFrame& frame : recording.frames) positives += frame.is_positive() ? 1 : 0;
  }
  return {{"recordings", recordings.size()}, {"persons", persons.size()},
          {"rooms", rooms.size()},           {"maps", frames},
          {"maps_with_person", positives},   {"damaged_messages", damaged}};
}

// Clusters as unseen recordings give them: each half of the recordings is segmented by a cell
// classifier that was trained on the other half, for one that knows the cells finds them too well.
ClusterSamples CrossFitClusterSamples(const std::vector<ObservedRecording>& recordings,
                                      const ClusterModel& clusters, const TrainingConfig& config,
                                      double cell_size_m, int jobs,
                                      const TrainingProgress& progress) {
  std::vector<RecordingOrigin> origins;
  for (const ObservedRecording& recording : recordings) origins.push_back(recording.origin);
  const RecordingSplit halves =
      SplitByPersonAndRoom(origins, 0.5, static_cast<std::uint64_t>(config.sampling.seed));
  const auto frames_of = [&](const std::vector<std::size_t>& half) {
    std::vector<const ObservedFrame*> frames;
    for (const std::size_t i : half)
      for (const ObservedFrame& frame : recordings[i].frames) frames.push_back(&frame);
    return frames;
  };
  const auto first = frames_of(halves.training);
  const auto second = frames_of(halves.validation);
  std::vector<ClusterSamples> parts;
  for (const auto& [learnt, unseen] : {std::pair(&first, &second), std::pair(&second, &first)}) {
    const CellModel cells = TrainCellModel(CollectCellSamples(*learnt, config, jobs, progress),
                                           cell_size_m, config, jobs, progress);
    parts.push_back(CollectClusterSamples(*unseen, cells, clusters, config, jobs, progress));
  }
  return JoinSamples(parts);
}

// Share of the weight on the wrong side of zero.
double CellError(const CellModel& model, const CellSamples& samples) {
  const std::vector<float> scores = PredictScores(model.trees, samples.features);
  double wrong = 0, all = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    all += samples.weights[i];
    if ((scores[i] > 0) != (samples.labels[i] > 0)) wrong += samples.weights[i];
  }
  return wrong / all;
}

nlohmann::json GateReport(const CellGate& gate, const CellSamples& unseen) {
  const GateFigures figures = MeasureGate(gate, unseen);
  return {{"trees", gate.trees.roots.size()},
          {"min_score", gate.min_score},
          {"turned_away_score", gate.turned_away_score},
          {"validation_person_share_passed", figures.person_share},
          {"validation_other_share_passed", figures.other_share}};
}

}  // namespace

TrainedModel TrainModel(const std::vector<ObservedRecording>& training,
                        const std::vector<ObservedRecording>& validation,
                        const TrainingConfig& config, double cell_size_m, int jobs,
                        const TrainingProgress& progress) {
  config.Validate();
  const std::vector<const ObservedFrame*> training_frames = AllFrames(training);
  const std::vector<const ObservedFrame*> validation_frames = AllFrames(validation);
  TrainedModel result;
  Model& model = result.model;
  model.segmentation = config.segmentation;

  const CellSamples samples = CollectCellSamples(training_frames, config, jobs, progress);
  model.cells = TrainCellModel(samples, cell_size_m, config, jobs, progress);
  const CellSamples unseen = CollectCellSamples(validation_frames, config, jobs, progress);
  const ClusterTraining clusters = TrainClusterModel(training_frames, samples.person_descriptors,
                                                     model.cells, config, jobs, progress);
  model.clusters = clusters.model;
  if (config.sampling.cluster_score == ClusterScore::kBoosted) {
    const ClusterSamples of_clusters =
        CrossFitClusterSamples(training, model.clusters, config, cell_size_m, jobs, progress);
    model.clusters.trees = TrainClusterTrees(of_clusters, config.cluster_boosting, jobs, progress);
    model.clusters.network = TrainClusterNetwork(of_clusters, config.cluster_network, progress);
    model.clusters.network_share = config.sampling.network_share;
  }
  const CalibrationResult calibration =
      CalibrateOnFrames(validation_frames, model.cells, model.clusters, config, jobs, progress);
  model.clusters.calibration = calibration.calibration;

  nlohmann::json points = nlohmann::json::array();
  for (const Calibration::OperatingPoint& point : calibration.calibration.operating_points)
    points.push_back({{"min_probability", point.min_probability},
                      {"false_positives_per_frame", point.false_positives_per_frame},
                      {"miss_rate", point.miss_rate}});
  result.report = {{"training", DataReport(training)},
                   {"validation", DataReport(validation)},
                   {"settings", ConfigText(config)},
                   {"gate", GateReport(model.cells.gate, unseen)},
                   {"cells",
                    {{"training_samples", samples.labels.size()},
                     {"training_error", CellError(model.cells, samples)},
                     {"validation_samples", unseen.labels.size()},
                     {"validation_error", CellError(model.cells, unseen)},
                     {"trees", model.cells.trees.roots.size()},
                     {"nodes", model.cells.trees.nodes.size()}}},
                   {"clusters",
                    {{"code_words", model.clusters.codebook.rows()},
                     {"training_person_clusters", clusters.person_clusters},
                     {"shrinkage", clusters.shrinkage},
                     {"trees", model.clusters.trees.roots.size()},
                     {"network_layers", model.clusters.network.layers.size()},
                     {"validation_person_clusters", calibration.person_clusters},
                     {"validation_other_clusters", calibration.other_clusters}}},
                   {"validation_figures",
                    {{"frames", calibration.tradeoff.frames},
                     {"positives", calibration.tradeoff.positives},
                     {"miss_rate_at_0.01_fppf", calibration.tradeoff.MissRateAt(0.01)},
                     {"miss_rate_at_0.1_fppf", calibration.tradeoff.MissRateAt(0.1)},
                     {"log_average_miss_rate", calibration.tradeoff.LogAverageMissRate()},
                     {"segmentation_miss_rate", calibration.tradeoff.points.back().miss_rate},
                     {"operating_points", points}}}};
  return result;
}

std::string SummaryText(const nlohmann::json& report) {
  std::string text;
  for (const char* part : {"training", "validation", "gate", "cells", "clusters"})
    text += std::string(part) + " " + report.at(part).dump() + "\n";
  nlohmann::json figures = report.at("validation_figures");
  figures.erase("operating_points");
  return text + "validation figures " + figures.dump() + "\n";
}

}  // namespace fallen
