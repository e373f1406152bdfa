// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/background_subtraction/background_subtraction_service.hpp"

#include <utility>

#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

void ReportBackground(ServiceReporter& reporter, BackgroundStatus status) {
  switch (status) {
    case BackgroundStatus::kSubtracted:
      return reporter.SetState(ServiceState::kRunning, "");
    case BackgroundStatus::kNoEnvironmentMap:
      return reporter.SetState(ServiceState::kDegraded,
                               "no environment map: everything is foreground");
    case BackgroundStatus::kNoPose:
      return reporter.SetState(ServiceState::kDegraded, "no pose: everything is foreground");
  }
}

}  // namespace

BackgroundSubtractionService::BackgroundSubtractionService(lcm::LCM& lcm,
                                                           const StageOptions& options,
                                                           BackgroundSubtractor background)
    : background_(std::move(background)), loop_(lcm, options) {
  if (!background_.has_environment())
    ReportBackground(loop_.reporter(), BackgroundStatus::kNoEnvironmentMap);
  loop_.Connect<ndt_map_t, ndt_map_t>(
      channels::NdtMap(options.camera), channels::Foreground(options.camera),
      [this](const ndt_map_t& message) { return Subtract(message); });
}

ndt_map_t BackgroundSubtractionService::Subtract(const ndt_map_t& message) {
  const ForegroundMap foreground = background_.Subtract(NdtMapFromMessage(message));
  ReportBackground(loop_.reporter(), foreground.status);
  return ToMessage(FromMessage(message.header), foreground);
}

}  // namespace fallen
