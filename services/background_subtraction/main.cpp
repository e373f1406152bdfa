// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/load_files.hpp"
#include "fallen/service/service_program.hpp"
#include "services/background_subtraction/background_subtraction_service.hpp"

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  ServiceProgram program("background-subtraction",
                         "Marks the cells of a local NDT map that are not known background",
                         ServiceProgram::Kind::kStateless);
  std::string map_file;
  program.cli()
      .add_option("--map", map_file, "Environment map, before that of the configuration")
      ->type_name("FILE");
  return program.Run(argc, argv, [&](fallen::ServiceContext& context) {
    fallen::BackgroundSubtractionService service(
        context.lcm, context.options, fallen::LoadBackgroundFor(context.configuration, map_file));
    return context.Run(service.loop());
  });
}
