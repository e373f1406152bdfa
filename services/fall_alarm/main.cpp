// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string_view>

#include "fallen/service/load_files.hpp"
#include "fallen/service/logging.hpp"
#include "fallen/service/service_program.hpp"
#include "services/fall_alarm/fall_alarm_service.hpp"
#include "services/fall_alarm/history_tool.hpp"
#include "services/fall_alarm/mqtt_publisher.hpp"
#include "services/fall_alarm/open_history.hpp"

namespace {

int RunService(fallen::ServiceContext& context, const std::string& history_flag) {
  using namespace fallen;
  const Configuration& config = context.configuration;
  const std::filesystem::path file =
      HistoryFile(history_flag.empty() ? config.history.file : history_flag);
  const HistoryLock lock(file);
  const OpenedHistory opened = OpenHistoryAnyhow(file);
  if (!opened.note.empty()) LogError(opened.note);

  FallAlarmSetup setup;
  setup.config = config.alarm;
  setup.scope = LoadAlarmScopeFor(config);
  setup.camera = context.chosen_camera;
  setup.has_snapshots = config.history.snapshots;
  setup.has_broker = !config.mqtt.host.empty();
  setup.history_note = opened.note;
  FallAlarmService service(context.lcm, context.options, std::move(setup), *opened.history);
  std::unique_ptr<MqttPublisher> broker;
  if (!config.mqtt.host.empty())
    broker = std::make_unique<MqttPublisher>(
        config.mqtt, config.service.robot, *opened.history,
        MqttPublisher::Handlers{
            [&](const AlarmAnswer& answer) { service.Answer(answer); },
            [&](const std::string& trouble) { service.SetBrokerTrouble(trouble); }});
  return context.Run(service.loop());
}

}  // namespace

int main(int argc, char** argv) {
  using fallen::ServiceProgram;
  if (argc > 1 && std::string_view(argv[1]) == "history")
    return fallen::RunHistoryTool(argc - 1, argv + 1);
  ServiceProgram program("alarm",
                         "Raises, updates and clears alarms about falls, keeps their history and "
                         "tells an MQTT broker; `fallen-alarm history --help` for the history",
                         ServiceProgram::Kind::kStateful);
  std::string history;
  program.cli()
      .add_option("--history", history, "History (SQLite), before that of the configuration")
      ->type_name("FILE");
  return program.Run(argc, argv,
                     [&](fallen::ServiceContext& context) { return RunService(context, history); });
}
