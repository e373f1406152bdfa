// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>

#include "fallen/service/command_line.hpp"
#include "fallen/service/service_program.hpp"
#include "services/depth_capture/capture_plan.hpp"
#include "services/depth_capture/depth_capture_service.hpp"

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  fallen::CaptureFlags flags;
  ServiceProgram program("depth-capture",
                         "Publishes depth images from an OpenNI2 camera or an .oni file",
                         ServiceProgram::Kind::kSource);
  fallen::AddCaptureFlags(program.cli(), flags);
  return program.Run(argc, argv, [&](fallen::ServiceContext& context) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const std::int64_t now_us = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
    fallen::DepthCaptureService service(
        context.lcm, context.options.camera,
        MakeCapturePlan(flags, context.configuration.capture, now_us));
    context.LogStart();
    service.Run([&] { return context.stop.Arrived(); });
    return fallen::kExitSuccess;
  });
}
