// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "fallen/service/configuration.hpp"
#include "fallen/service/stage_loop.hpp"
#include "fallen/service/stop_signal.hpp"

/// What the main() of every service does: flags, configuration, LCM, log, run.
namespace fallen {

/// What a service program works with once its call has been understood.
struct ServiceContext {
  Configuration configuration;  ///< with the command line's overrides
  StageOptions options;
  std::string chosen_camera;  ///< that of --camera; empty: not given
  lcm::LCM& lcm;
  StopSignal& stop;

  /// Logs version, URL and the whole configuration, and warns of buffers that are too small.
  void LogStart() const;
  /// LogStart, then runs the loop until a signal comes. @return Exit status.
  int Run(StageLoop& loop) const;
};

/// One service's command line and life. `cli()` takes the flags that only this service has.
class ServiceProgram {
 public:
  /// Which of the common flags apply.
  enum class Kind {
    kSource,     ///< makes frames: neither --lossless nor --worker
    kStateful,   ///< --lossless
    kStateless,  ///< --lossless and --worker
  };

  /// @param service  As in "fallen-<service>".
  ServiceProgram(const std::string& service, const std::string& description, Kind kind);

  CLI::App& cli() { return cli_; }

  /// Parses, loads, opens LCM and calls `body`.
  /// @return Exit status of `body`; 2, with one line on stderr, for a wrong call and for whatever
  ///         `body` throws while it sets up.
  int Run(int argc, const char* const* argv, const std::function<int(ServiceContext&)>& body);

 private:
  CLI::App cli_;
  std::string service_;
  std::string config_file_;
  std::string lcm_url_;
  std::string camera_;
  std::string worker_ = "0/1";
  bool lossless_ = false;
};

}  // namespace fallen
