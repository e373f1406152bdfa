// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/service_program.hpp"
#include "services/ndt_mapping/ndt_mapping_service.hpp"

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  ServiceProgram program(
      "ndt-mapping", "Turns depth images and robot poses into a local NDT map without the floor",
      ServiceProgram::Kind::kStateful);
  return program.Run(argc, argv, [](fallen::ServiceContext& context) {
    const fallen::Configuration& config = context.configuration;
    fallen::NdtMappingService service(context.lcm, context.options, config.ground, config.ndt);
    return context.Run(service.loop());
  });
}
