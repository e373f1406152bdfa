// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/load_files.hpp"
#include "fallen/service/service_program.hpp"
#include "services/cluster_classification/cluster_classification_service.hpp"

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  ServiceProgram program("cluster-classification",
                         "Decides which clusters of cells are fallen persons",
                         ServiceProgram::Kind::kStateless);
  std::string model_file;
  program.cli()
      .add_option("--model", model_file, "Trained model, before that of the configuration")
      ->type_name("FILE");
  return program.Run(argc, argv, [&](fallen::ServiceContext& context) {
    fallen::Model model = fallen::LoadModelFor(context.configuration, model_file);
    fallen::ClusterClassificationService service(context.lcm, context.options,
                                                 std::move(model.clusters),
                                                 context.configuration.classification);
    return context.Run(service.loop());
  });
}
