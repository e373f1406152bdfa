// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/baseline_training.hpp"

#include <algorithm>
#include <stdexcept>

#include "fallen/evaluation/frame_outcome.hpp"
#include "fallen/service/config_text.hpp"
#include "tools/train/cluster_training.hpp"
#include "tools/train/operating_points.hpp"
#include "tools/train/settings_file.hpp"

namespace fallen {
namespace {

ClusterSamples SamplesOf(const std::vector<BaselineRecording>& recordings) {
  std::vector<ClusterSamples> parts;
  for (const BaselineRecording& recording : recordings)
    for (const BaselineFrame& frame : recording.frames) {
      ClusterSamples& part = parts.emplace_back();
      part.features = frame.clusters.features;
      for (const Eigen::Vector3d& centroid : frame.clusters.centroids)
        part.labels.push_back(frame.person_box && frame.person_box->Contains(centroid) ? 1 : -1);
      part.weights.assign(part.labels.size(), 1.0F);
    }
  return JoinSamples(parts);
}

Calibration Calibrate(const BoostedTrees& trees, const ClusterSamples& samples) {
  const std::vector<float> scores = PredictScores(trees, samples.features);
  const std::vector<double> evidence(scores.begin(), scores.end());
  std::vector<std::uint8_t> is_person;
  for (const std::int8_t label : samples.labels) is_person.push_back(label > 0 ? 1 : 0);
  Calibration calibration = FitCalibration(evidence, is_person);
  // A threshold is needed to judge clusters; the lowest lets the curve see all of them.
  calibration.operating_points = {{0.0, 1.0, 0.0}};
  return calibration;
}

DetectionErrorTradeoff Measure(const BaselineModel& model,
                               const std::vector<BaselineRecording>& recordings) {
  std::vector<FrameOutcome> outcomes;
  for (const BaselineRecording& recording : recordings)
    for (const BaselineFrame& frame : recording.frames)
      outcomes.push_back(JudgeFrame(JudgeClusters(frame.clusters, model, {}), frame.person_box,
                                    frame.cells_in_box));
  return ComputeTradeoff(outcomes);
}

nlohmann::json DataReport(const std::vector<BaselineRecording>& recordings,
                          const ClusterSamples& samples) {
  std::int64_t frames = 0, damaged = 0;
  for (const BaselineRecording& recording : recordings) {
    frames += static_cast<std::int64_t>(recording.frames.size());
    damaged += recording.damaged;
  }
  const auto persons = std::count(samples.labels.begin(), samples.labels.end(), 1);
  return {{"recordings", recordings.size()},
          {"frames", frames},
          {"person_clusters", persons},
          {"other_clusters", static_cast<std::int64_t>(samples.labels.size()) - persons},
          {"damaged_messages", damaged}};
}

}  // namespace

void BaselineTrainingConfig::Validate() const {
  if (sampling.frame_stride < 1 || sampling.validation_frame_stride < 1)
    throw std::invalid_argument("sampling: strides must be >= 1");
  baseline.Validate();
  boosting.Validate();
}

BaselineTrainingConfig LoadBaselineTrainingConfig(
    const std::optional<std::filesystem::path>& path) {
  return LoadSettings<BaselineTrainingConfig>(path);
}

TrainedBaseline TrainBaseline(const std::vector<BaselineRecording>& training,
                              const std::vector<BaselineRecording>& validation,
                              const BaselineTrainingConfig& config, int jobs,
                              const TrainingProgress& progress) {
  config.Validate();
  TrainedBaseline result;
  BaselineModel& model = result.model;
  model.config = config.baseline;
  const ClusterSamples samples = SamplesOf(training);
  const ClusterSamples unseen = SamplesOf(validation);
  model.trees = TrainClusterTrees(samples, config.boosting, jobs, progress);
  model.calibration = Calibrate(model.trees, unseen);
  const DetectionErrorTradeoff tradeoff = Measure(model, validation);
  model.calibration.operating_points = OperatingPointsOf(tradeoff);
  result.report = {{"training", DataReport(training, samples)},
                   {"validation", DataReport(validation, unseen)},
                   {"settings", ConfigText(config)},
                   {"trees", model.trees.roots.size()},
                   {"features", model.trees.feature_count},
                   {"validation_figures",
                    {{"frames", tradeoff.frames},
                     {"positives", tradeoff.positives},
                     {"miss_rate_at_0.01_fppf", tradeoff.MissRateAt(0.01)},
                     {"miss_rate_at_0.1_fppf", tradeoff.MissRateAt(0.1)},
                     {"log_average_miss_rate", tradeoff.LogAverageMissRate()},
                     {"segmentation_miss_rate", tradeoff.points.back().miss_rate}}}};
  return result;
}

}  // namespace fallen
