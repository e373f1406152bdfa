// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/config_text.hpp"
#include "fallen/service/load_files.hpp"
#include "fallen/service/logging.hpp"
#include "fallen/service/service_program.hpp"
#include "services/cell_segmentation/cell_segmentation_service.hpp"

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  ServiceProgram program(
      "cell-segmentation",
      "Finds the cells of a foreground map that are like a person, and clusters them",
      ServiceProgram::Kind::kStateless);
  std::string model_file;
  program.cli()
      .add_option("--model", model_file, "Trained model, before that of the configuration")
      ->type_name("FILE");
  return program.Run(argc, argv, [&](fallen::ServiceContext& context) {
    const fallen::Model model = fallen::LoadModelFor(context.configuration, model_file);
    const auto settings = context.configuration.SegmentationOver(model.segmentation);
    fallen::CellSegmentationService service(context.lcm, context.options, model.cells, settings);
    fallen::LogInfo("segmentation over the model's: " + fallen::ConfigText(settings));
    return context.Run(service.loop());
  });
}
