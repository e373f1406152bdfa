// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "tools/common/tool.hpp"
#include "tools/doctor/camera_checks.hpp"
#include "tools/doctor/file_checks.hpp"
#include "tools/doctor/network_checks.hpp"
#include "tools/doctor/program_checks.hpp"

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-doctor",
      "Looks whether this machine can run the detector, and says what mends what is wrong.\n"
      "Exit status: 0, also with warnings; 1 with errors: no person would be found; 2 wrong call");
  std::optional<std::string> config_file;
  std::string lcm_url;
  bool as_json = false;
  parser->add_option("--config", config_file, "Configuration to check")->type_name("FILE");
  parser->add_option("--lcm-url", lcm_url, "LCM URL, before that of the configuration");
  parser->add_flag("--json", as_json, "Print the findings as JSON");

  return fallen::RunTool(*parser, argc, argv, [&] {
    const fallen::CheckedConfiguration checked = fallen::CheckConfiguration(config_file);
    const fallen::Configuration& configuration = checked.configuration;
    std::vector<fallen::Finding> findings{checked.finding};
    const auto add = [&](const std::vector<fallen::Finding>& more) {
      findings.insert(findings.end(), more.begin(), more.end());
    };
    add(fallen::CheckFiles(configuration));
    add(fallen::CheckNetwork(lcm_url.empty() ? configuration.service.lcm_url : lcm_url));
    const char* search_path = std::getenv("PATH");
    add(fallen::CheckPrograms(search_path == nullptr ? "" : search_path));
    add(fallen::CheckCameras(configuration.capture.device_uri));
    (as_json ? fallen::PrintFindingsAsJson : fallen::PrintFindings)(std::cout, findings);
    return fallen::ExitStatusOf(findings);
  });
}
