// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fallen/classification/calibration.hpp"
#include "fallen/classification/feature_network.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/network_t.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/trees_t.hpp"

/// Parts that the messages of several models share. Internal to this folder.
///
/// All throw std::invalid_argument for what could not be read; the parts' own Validate does the
/// rest.
namespace fallen {

/// The matrix of `rows`, each as long as it should be, all finite.
template <class Matrix, class Value>
Matrix MatrixFromRows(const std::string& field, const std::vector<std::vector<Value>>& rows,
                      std::int64_t row_count, std::int64_t column_count) {
  checks::Count(field + "'s rows", row_count, rows.size());
  Matrix matrix(row_count, column_count);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    checks::Count(field + "'s columns", column_count, rows[row].size());
    checks::AllFinite(field, std::span<const Value>(rows[row]));
    for (std::size_t column = 0; column < rows[row].size(); ++column)
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = rows[row][column];
  }
  return matrix;
}

/// The rows of a matrix, as a message holds them.
template <class Matrix>
auto RowsOfMatrix(const Matrix& matrix) {
  std::vector<std::vector<typename Matrix::Scalar>> rows(static_cast<std::size_t>(matrix.rows()));
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      rows[static_cast<std::size_t>(row)].push_back(matrix(row, column));
  return rows;
}

trees_t TreesToMessage(const BoostedTrees& trees);
BoostedTrees TreesFromMessage(const std::string& field, const trees_t& message);

network_t NetworkToMessage(const FeatureNetwork& network);
FeatureNetwork NetworkFromMessage(const std::string& field, const network_t& message);

/// Sets the fields calibration_* and operating_point_* of a model's message.
template <class ModelMessage>
void CalibrationToMessage(const Calibration& calibration, ModelMessage& message) {
  message.calibration_slope = calibration.slope;
  message.calibration_intercept = calibration.intercept;
  for (const auto& point : calibration.operating_points) {
    message.operating_point_min_probability.push_back(point.min_probability);
    message.operating_point_false_positives_per_frame.push_back(point.false_positives_per_frame);
    message.operating_point_miss_rate.push_back(point.miss_rate);
  }
  message.operating_point_count = static_cast<std::int32_t>(calibration.operating_points.size());
}

/// @param owner  Name of the message, for error texts.
template <class ModelMessage>
Calibration CalibrationFromMessage(const std::string& owner, const ModelMessage& message) {
  const auto count = message.operating_point_count;
  for (const std::size_t elements : {message.operating_point_min_probability.size(),
                                     message.operating_point_false_positives_per_frame.size(),
                                     message.operating_point_miss_rate.size()})
    checks::Count(owner + ".operating_point_count", count, elements);
  Calibration calibration;
  calibration.slope = message.calibration_slope;
  calibration.intercept = message.calibration_intercept;
  for (std::int32_t i = 0; i < count; ++i)
    calibration.operating_points.push_back({message.operating_point_min_probability[i],
                                            message.operating_point_false_positives_per_frame[i],
                                            message.operating_point_miss_rate[i]});
  return calibration;
}

}  // namespace fallen
