// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/alarm_history.hpp"

#include <cstdlib>
#include <stdexcept>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"

namespace fallen {
namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::int64_t kApplicationId = 0x46414C41;  // "FALA"

// `message` is the change as fall_alarm_t; the other columns say what of it is searched for.
constexpr char kSchema[] = R"(
CREATE TABLE changes (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  event_id TEXT NOT NULL,
  revision INTEGER NOT NULL,
  change INTEGER NOT NULL,
  utime INTEGER NOT NULL,
  message BLOB NOT NULL,
  UNIQUE (event_id, revision));
CREATE TABLE snapshots (
  event_id TEXT NOT NULL,
  revision INTEGER NOT NULL,
  utime INTEGER NOT NULL,
  log BLOB NOT NULL,
  PRIMARY KEY (event_id, revision));
CREATE TABLE outbox (sent INTEGER NOT NULL);
INSERT INTO outbox VALUES (0);
)";

std::filesystem::path WithFolder(const std::filesystem::path& file) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  return file;
}

void SetUp(SqliteDatabase& database, const std::string& file) {
  const std::int64_t version = database.Number("PRAGMA user_version").value_or(0);
  if (version == kVersion) return;
  if (version != 0)
    throw std::runtime_error(file + ": version: got " + std::to_string(version) + ", expected " +
                             std::to_string(kVersion));
  if (database.Number("SELECT count(*) FROM sqlite_master") != 0)
    throw std::runtime_error(file + ": got a database of something else, expected a history");
  SqliteTransaction transaction(database);
  database.Run(kSchema);
  database.Run("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.Run("PRAGMA user_version = " + std::to_string(kVersion));
  transaction.Commit();
}

NumberedAlarm Decode(const std::vector<std::uint8_t>& bytes, std::int64_t number) {
  const Decoded<fall_alarm_t> decoded = DecodeMessage<fall_alarm_t>(bytes);
  const std::string where = "history: change " + std::to_string(number) + ": ";
  if (!decoded) throw std::runtime_error(where + decoded.error);
  try {
    NumberedAlarm alarm = FromMessage(*decoded.message);
    alarm.number = number;
    return alarm;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(where + error.what());
  }
}

}  // namespace

AlarmHistory::AlarmHistory(const std::filesystem::path& file) : database_(WithFolder(file)) {
  SetUp(database_, file.string());
}

std::int64_t AlarmHistory::Record(const std::string& robot, const FallAlarm& alarm,
                                  const std::optional<AlarmSnapshot>& snapshot) {
  const std::lock_guard lock(mutex_);
  SqliteTransaction transaction(database_);
  SqliteStatement known(database_.handle(),
                        "SELECT number FROM changes WHERE event_id = ? AND revision = ?");
  if (known.Bind(1, alarm.id).Bind(2, alarm.revision).Step()) return known.Int(0);

  const std::int64_t number =
      database_.Number("SELECT seq + 1 FROM sqlite_sequence WHERE name = 'changes'").value_or(1);
  SqliteStatement(database_.handle(), "INSERT INTO changes VALUES (?, ?, ?, ?, ?, ?)")
      .Bind(1, number)
      .Bind(2, alarm.id)
      .Bind(3, alarm.revision)
      .Bind(4, static_cast<std::int64_t>(alarm.change))
      .Bind(5, alarm.change_utime)
      .Bind(6, EncodeMessage(ToMessage(NumberedAlarm{robot, number, alarm})))
      .Step();
  if (snapshot) {
    SqliteStatement(database_.handle(),
                    "DELETE FROM snapshots WHERE event_id = ? AND revision > "
                    "(SELECT min(revision) FROM snapshots WHERE event_id = ?)")
        .Bind(1, alarm.id)
        .Bind(2, alarm.id)
        .Step();
    SqliteStatement(database_.handle(), "INSERT INTO snapshots VALUES (?, ?, ?, ?)")
        .Bind(1, alarm.id)
        .Bind(2, alarm.revision)
        .Bind(3, snapshot->utime)
        .Bind(4, snapshot->log)
        .Step();
  }
  transaction.Commit();
  return number;
}

std::int64_t AlarmHistory::NextNumber() const {
  const std::lock_guard lock(mutex_);
  return database_.Number("SELECT seq + 1 FROM sqlite_sequence WHERE name = 'changes'").value_or(1);
}

std::vector<NumberedAlarm> AlarmHistory::Read(const std::string& condition,
                                              const std::string& argument) const {
  const std::lock_guard lock(mutex_);
  SqliteStatement rows(database_.handle(), "SELECT number, message FROM changes c WHERE " +
                                               condition + " ORDER BY number");
  if (!argument.empty()) rows.Bind(1, argument);
  std::vector<NumberedAlarm> alarms;
  while (rows.Step()) alarms.push_back(Decode(rows.Bytes(1), rows.Int(0)));
  return alarms;
}

std::vector<NumberedAlarm> AlarmHistory::Falls() const {
  return Read("revision = (SELECT max(revision) FROM changes WHERE event_id = c.event_id)", "");
}

std::vector<NumberedAlarm> AlarmHistory::Active() const {
  return Read(
      "revision = (SELECT max(revision) FROM changes WHERE event_id = c.event_id) "
      "AND change <> " +
          std::to_string(static_cast<int>(AlarmChange::kCleared)),
      "");
}

std::vector<NumberedAlarm> AlarmHistory::Changes(const std::string& event_id) const {
  return Read("event_id = ?", event_id);
}

std::vector<AlarmSnapshot> AlarmHistory::Snapshots(const std::string& event_id) const {
  const std::lock_guard lock(mutex_);
  SqliteStatement rows(database_.handle(),
                       "SELECT utime, log FROM snapshots WHERE event_id = ? ORDER BY revision");
  rows.Bind(1, event_id);
  std::vector<AlarmSnapshot> snapshots;
  while (rows.Step()) snapshots.push_back({rows.Int(0), rows.Bytes(1)});
  return snapshots;
}

std::optional<NumberedAlarm> AlarmHistory::FirstUnsent() const {
  const std::lock_guard lock(mutex_);
  SqliteStatement row(database_.handle(),
                      "SELECT number, message FROM changes WHERE number > "
                      "(SELECT sent FROM outbox) ORDER BY number LIMIT 1");
  if (!row.Step()) return std::nullopt;
  return Decode(row.Bytes(1), row.Int(0));
}

void AlarmHistory::MarkSent(std::int64_t number) {
  const std::lock_guard lock(mutex_);
  SqliteStatement(database_.handle(), "UPDATE outbox SET sent = ? WHERE sent < ?")
      .Bind(1, number)
      .Bind(2, number)
      .Step();
}

std::int64_t AlarmHistory::Purge(std::int64_t before_utime) {
  const std::lock_guard lock(mutex_);
  SqliteTransaction transaction(database_);
  SqliteStatement(database_.handle(),
                  "CREATE TEMP TABLE purged AS SELECT event_id FROM changes "
                  "WHERE change = ? AND utime < ? AND number <= (SELECT sent FROM outbox)")
      .Bind(1, static_cast<std::int64_t>(AlarmChange::kCleared))
      .Bind(2, before_utime)
      .Step();
  const std::int64_t count = database_.Number("SELECT count(*) FROM purged").value_or(0);
  database_.Run(
      "DELETE FROM changes WHERE event_id IN purged;"
      "DELETE FROM snapshots WHERE event_id IN purged;"
      "DROP TABLE purged");
  transaction.Commit();
  return count;
}

std::filesystem::path HistoryFile(const std::string& configured) {
  if (!configured.empty()) return configured;
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value ? value : "");
  };
  std::filesystem::path folder = variable("XDG_STATE_HOME");
  if (folder.empty()) folder = variable("HOME") / ".local" / "state";
  return folder / "fallen" / "alarms.db";
}

}  // namespace fallen
