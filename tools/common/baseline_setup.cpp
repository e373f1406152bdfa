// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/baseline_setup.hpp"

#include "fallen/messages/baseline_files.hpp"
#include "fallen/service/configuration.hpp"
#include "fallen/service/shipped_file.hpp"

namespace fallen {

BaselineDetector MakeBaselineDetector(const std::string& model, const DetectorOptions& options) {
  const Configuration configuration = LoadConfiguration(options.config);
  const std::filesystem::path file =
      model.empty() ? ShippedFilePath("baseline.model", "FALLEN_BASELINE_MODEL")
                    : std::filesystem::path(model);
  return BaselineDetector(LoadBaselineModel(file), configuration.ground,
                          configuration.classification);
}

}  // namespace fallen
