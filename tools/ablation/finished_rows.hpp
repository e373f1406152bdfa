// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/ablation/ablation_rows.hpp"

namespace fallen {

/// Finished rows, a JSON file each, so that an ablation that was stopped goes on where it was.
class FinishedRows {
 public:
  /// @param data  What was learnt and judged from: rows of other data are not taken.
  /// @throws std::runtime_error if the folder cannot be made.
  FinishedRows(std::filesystem::path folder, std::string data);

  /// The row's result, if it is finished with the same settings on the same data.
  std::optional<nlohmann::json> Find(const AblationRow& row) const;

  /// Keeps a result. @throws std::runtime_error.
  /// @param figures   As of FiguresJson.
  /// @param outcomes  As of OutcomesJson.
  void Keep(const AblationRow& row, const nlohmann::json& figures,
            const nlohmann::json& outcomes) const;

  /// Where the first row's model is kept.
  std::filesystem::path model_file() const { return folder_ / "first-row.model"; }

 private:
  std::filesystem::path FileOf(const AblationRow& row) const;

  std::filesystem::path folder_;
  std::string data_;
};

/// The finished rows in their order, as a Markdown table: miss rates at 0.01 and 0.1 false
/// positives per frame and the log-average miss rate, with their intervals; and how far the last is
/// from the first row's, where `difference` (as of DifferenceJson) is there.
std::string MarkdownTable(const std::vector<nlohmann::json>& results);

}  // namespace fallen
