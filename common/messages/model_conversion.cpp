// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "fallen/messages/classifier_conversion.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/map_conversion.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

const std::string kModel = "model_t";
// A code word more is a dimension of the covariance more: beyond it no training set is large
// enough.
constexpr std::int64_t kMaxUnits = 4096;

void SegmentationToMessage(const SegmentationConfig& config, model_t& message) {
  message.smoothing_radius_m = config.smoothing_radius_m;
  message.min_score = config.min_score;
  message.max_height_m = config.max_height_m;
  message.cluster_epsilon_m = config.cluster_epsilon_m;
  message.cluster_min_points = config.cluster_min_points;
  message.min_cluster_cells = config.min_cluster_cells;
  message.descriptors_on_foreground_only = config.descriptors_on_foreground_only ? 1 : 0;
}

SegmentationConfig SegmentationFromMessage(const model_t& message) {
  SegmentationConfig config;
  config.smoothing_radius_m = message.smoothing_radius_m;
  config.min_score = message.min_score;
  config.max_height_m = message.max_height_m;
  config.cluster_epsilon_m = message.cluster_epsilon_m;
  config.cluster_min_points = message.cluster_min_points;
  config.min_cluster_cells = message.min_cluster_cells;
  config.descriptors_on_foreground_only = checks::Boolean(
      kModel + ".descriptors_on_foreground_only", message.descriptors_on_foreground_only);
  return config;
}

void ClassifierToMessage(const ClusterModel& model, model_t& message) {
  const Eigen::Index units = model.codebook.rows();
  message.dimension = static_cast<std::int32_t>(model.codebook.cols());
  message.unit_count = static_cast<std::int32_t>(units);
  message.alpha = model.alpha;
  const Eigen::VectorXd& mean = model.gaussian.mean();
  const Eigen::MatrixXd& covariance = model.gaussian.covariance();
  if (mean.size() != units || covariance.rows() != units || covariance.cols() != units)
    checks::Fail(kModel + ".gaussian_mean", std::to_string(mean.size()) + " values",
                 std::to_string(units) + ", one a code word");
  message.gaussian_mean.assign(mean.data(), mean.data() + units);
  message.codebook = RowsOfMatrix(model.codebook);
  message.gaussian_covariance = RowsOfMatrix(covariance);
  message.cluster_trees = TreesToMessage(model.trees);
  message.cluster_network = NetworkToMessage(model.network);
  message.network_share = model.network_share;
  CalibrationToMessage(model.calibration, message);
}

ClusterModel ClassifierFromMessage(const model_t& message, const IronConfig& iron) {
  checks::InRange(kModel + ".unit_count", message.unit_count, 1, kMaxUnits);
  checks::InRange(kModel + ".dimension", message.dimension, iron.dimension(), iron.dimension());
  const auto units = message.unit_count;
  ClusterModel model;
  model.iron = iron;
  model.codebook =
      MatrixFromRows<Codebook>(kModel + ".codebook", message.codebook, units, message.dimension);
  model.alpha = message.alpha;
  checks::Count(kModel + ".gaussian_mean's values", units, message.gaussian_mean.size());
  model.gaussian =
      MahalanobisModel(Eigen::Map<const Eigen::VectorXd>(message.gaussian_mean.data(), units),
                       MatrixFromRows<Eigen::MatrixXd>(kModel + ".gaussian_covariance",
                                                       message.gaussian_covariance, units, units));
  model.trees = TreesFromMessage(kModel + ".cluster_trees", message.cluster_trees);
  model.network = NetworkFromMessage(kModel + ".cluster_network", message.cluster_network);
  model.network_share = message.network_share;
  model.calibration = CalibrationFromMessage(kModel, message);
  return model;
}

}  // namespace

model_t ToMessage(const Model& model) {
  model.Validate();
  if (model.cells.signs != NormalSigns::kArbitrary)
    checks::Fail(kModel + ".iron", "oriented normals", "arbitrary signs: no file says otherwise");
  model_t message{};
  message.description = model.description;
  checks::CheckText(kModel + ".description", message.description, limits::kMaxTextBytes);
  message.cell_size_m = model.cells.cell_size_m;
  message.iron = IronToMessage(model.cells.iron);
  message.gate_trees = TreesToMessage(model.cells.gate.trees);
  message.gate_min_score = model.cells.gate.min_score;
  message.gate_turned_away_score = model.cells.gate.turned_away_score;
  message.features = static_cast<std::int32_t>(model.cells.features);
  message.cell_trees = TreesToMessage(model.cells.trees);
  SegmentationToMessage(model.segmentation, message);
  ClassifierToMessage(model.clusters, message);
  return message;
}

Model FromMessage(const model_t& message) {
  Model model;
  checks::CheckText(kModel + ".description", message.description, limits::kMaxTextBytes);
  model.description = message.description;
  CheckCellSize(kModel, message.cell_size_m);
  model.cells.cell_size_m = message.cell_size_m;
  model.cells.iron = IronFromMessage(kModel, message.iron);
  model.cells.gate.trees = TreesFromMessage(kModel + ".gate_trees", message.gate_trees);
  model.cells.gate.min_score = message.gate_min_score;
  model.cells.gate.turned_away_score = message.gate_turned_away_score;
  checks::InRange(kModel + ".features", message.features, 0,
                  static_cast<int>(CellFeatureSet::kIronAndShape));
  model.cells.features = static_cast<CellFeatureSet>(message.features);
  model.cells.trees = TreesFromMessage(kModel + ".cell_trees", message.cell_trees);
  model.segmentation = SegmentationFromMessage(message);
  model.clusters = ClassifierFromMessage(message, model.cells.iron);
  model.Validate();  // the rest is the parts' own business
  return model;
}

}  // namespace fallen
