// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "fallen/service/command_line.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"
#include "tools/log_check/log_report.hpp"
#include "tools/log_check/report_output.hpp"

namespace {

// The log without what is damaged, complete or not there at all.
fallen::LogReport CheckAndRepair(const std::filesystem::path& log,
                                 const std::filesystem::path& output,
                                 const std::function<void(double)>& progress) {
  if (output.empty()) return fallen::CheckLog(log, nullptr, progress);
  if (std::filesystem::exists(output))
    throw std::runtime_error(output.string() +
                             ": --repair: got a file that exists, expected a new one");
  fallen::PartialFile part(output);
  fallen::LogWriter writer(part.path());
  fallen::LogReport report = fallen::CheckLog(log, &writer, progress);
  writer.Close();
  part.Commit();
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  const auto parser =
      fallen::MakeToolParser("fallen-log-check",
                             "Lists what an LCM log holds and where it is damaged. Exit status: 0 "
                             "clean, 1 damaged (places that "
                             "cannot be read, or bad messages of our types), 2 wrong call");
  std::filesystem::path log;
  std::filesystem::path repaired;
  bool as_json = false;
  parser->add_option("log", log, "Log to check")->required();
  parser->add_option("--repair", repaired, "Write the events that are good to this new log");
  parser->add_flag("--json", as_json, "Print the report as JSON");

  return fallen::RunTool(*parser, argc, argv, [&] {
    const fallen::LogReport report = [&] {
      fallen::ProgressBar bar("check");
      return CheckAndRepair(log, repaired, [&](double share) { bar.Update(share); });
    }();
    std::cout << (as_json ? fallen::ReportJson(log.string(), report)
                          : fallen::ReportText(log.string(), report))
              << std::flush;
    return report.is_clean() ? fallen::kExitSuccess : fallen::kExitFailure;
  });
}
