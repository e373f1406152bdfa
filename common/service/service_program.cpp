// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/service_program.hpp"

#include <unistd.h>

#include <optional>
#include <stdexcept>

#include "fallen/service/command_line.hpp"
#include "fallen/service/config_text.hpp"
#include "fallen/service/lcm_url.hpp"
#include "fallen/service/logging.hpp"
#include "fallen/service/version.hpp"

namespace fallen {
namespace {

std::string NoLcm(const std::string& url) {
  return "LCM: '" + url + "' cannot be opened: is there a multicast route? (fallen-doctor tells)";
}

}  // namespace

ServiceProgram::ServiceProgram(const std::string& service, const std::string& description,
                               Kind kind)
    : service_(service) {
  AddStandardFlags(cli_, "fallen-" + service, description);
  cli_.add_option("--config", config_file_, "Configuration (YAML); config/default.yaml says what")
      ->type_name("FILE");
  cli_.add_option("--lcm-url", lcm_url_, "LCM URL, before that of the configuration")
      ->type_name("URL");
  cli_.add_option("--camera", camera_, "Camera, as in the channel names: DEPTH_<CAMERA>")
      ->type_name("NAME");
  if (kind == Kind::kSource) return;
  cli_.add_flag("--lossless", lossless_,
                "Handle every frame in order, for a replay; else the newest, live");
  if (kind == Kind::kStateful) return;
  cli_.add_option("--worker", worker_, "Handle only frames with seq % n == k")->type_name("k/n");
}

int ServiceProgram::Run(int argc, const char* const* argv,
                        const std::function<int(ServiceContext&)>& body) {
  return RunCommandLine(cli_, argc, argv, [&] {
    StopSignal stop;  // before LCM starts its thread
    Configuration configuration = LoadConfiguration(
        config_file_.empty() ? std::nullopt : std::optional<std::filesystem::path>(config_file_));
    if (!lcm_url_.empty()) configuration.service.lcm_url = lcm_url_;
    if (!camera_.empty()) configuration.service.camera = camera_;
    configuration.service.Validate();
    StageOptions options;
    options.service = service_;
    options.camera = configuration.service.camera;
    options.pose_channel = configuration.service.pose_channel;
    options.depth_channel = configuration.service.depth_channel;
    options.lossless = lossless_;
    options.worker = WorkerShare::Parse(worker_);

    const std::string& url = configuration.service.lcm_url;
    RequireKnownLcmUrl(url);
    lcm::LCM lcm(url);
    if (!lcm.good()) throw std::runtime_error(NoLcm(url));
    SetUpLogging(service_);
    ServiceContext context{std::move(configuration), std::move(options), camera_, lcm, stop};
    return body(context);
  });
}

void ServiceContext::LogStart() const {
  LogInfo("fallen-" + options.service + " " + Version() + ", process " + std::to_string(getpid()) +
          (options.lossless ? ", lossless" : ", live"));
  const Configuration& config = configuration;
  LogInfo("configuration from " + (config.source.empty() ? "the defaults" : config.source));
  LogInfo("service: " + ConfigText(config.service));
  LogInfo("files: " + ConfigText(config.files));
  LogInfo("capture: " + ConfigText(config.capture));
  LogInfo("ground: " + ConfigText(config.ground));
  LogInfo("ndt: " + ConfigText(config.ndt));
  LogInfo("background: " + ConfigText(config.background));
  LogInfo("segmentation over the defaults: " + ConfigText(config.SegmentationOver({})));
  LogInfo("classification: " + ConfigText(config.classification));
  LogInfo("alarm: " + ConfigText(config.alarm));
  LogInfo("history: " + ConfigText(config.history));
  LogInfo("mqtt: " + ConfigText(config.mqtt));
  const std::string warning =
      ReceiveBufferWarning(config.service.lcm_url, SystemReceiveBufferLimit());
  if (!warning.empty()) LogWarning(warning);
}

int ServiceContext::Run(StageLoop& loop) const {
  if (lcm.getFileno() < 0) throw std::runtime_error(NoLcm(configuration.service.lcm_url));
  LogStart();
  return loop.Run([this] { return stop.Arrived(); });
}

}  // namespace fallen
