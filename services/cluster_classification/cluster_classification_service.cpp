// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/cluster_classification/cluster_classification_service.hpp"

#include <utility>

#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

ClusterModel Validated(ClusterModel model) {
  model.Validate();
  return model;
}

}  // namespace

ClusterClassificationService::ClusterClassificationService(lcm::LCM& lcm,
                                                           const StageOptions& options,
                                                           ClusterModel model,
                                                           const ClassificationConfig& config)
    : classifier_(Validated(std::move(model))), config_(config), loop_(lcm, options) {
  config_.Validate();
  loop_.Connect<clusters_t, fallen_persons_t>(
      channels::Clusters(options.camera), channels::FallenPersons(options.camera),
      [this](const clusters_t& message) { return Classify(message); });
}

fallen_persons_t ClusterClassificationService::Classify(const clusters_t& message) {
  classifier_.Classify(FromMessage(message), config_, decision_);
  return ToMessage(FromMessage(message.header), decision_);
}

}  // namespace fallen
