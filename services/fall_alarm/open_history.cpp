// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/open_history.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>
#include <system_error>

namespace fallen {
namespace {

namespace fs = std::filesystem;

/// Renames the database with its journals. @return The new name.
fs::path SetAside(const fs::path& file) {
  fs::path aside;
  int n = 0;
  do aside = file.string() + ".damaged-" + std::to_string(++n);
  while (fs::exists(aside));
  for (const char* suffix : {"", "-wal", "-shm"})
    if (fs::exists(file.string() + suffix))
      fs::rename(file.string() + suffix, aside.string() + suffix);
  return aside;
}

OpenedHistory InMemory(const std::string& why) {
  return {std::make_unique<AlarmHistory>(":memory:"),
          why + ": history only in memory, gone with the process"};
}

}  // namespace

OpenedHistory OpenHistoryAnyhow(const fs::path& file) {
  try {
    return {std::make_unique<AlarmHistory>(file), ""};
  } catch (const DamagedDatabase& damage) {
    try {
      const fs::path aside = SetAside(file);
      return {std::make_unique<AlarmHistory>(file), std::string(damage.what()) + ": set aside as " +
                                                        aside.filename().string() +
                                                        ", a new history is begun"};
    } catch (const std::exception& error) {
      return InMemory(error.what());
    }
  } catch (const std::exception& error) {
    return InMemory(error.what());
  }
}

HistoryLock::HistoryLock(const fs::path& history) {
  std::error_code ignored;  // where no file can be made, nobody else can use one either
  if (history.has_parent_path()) fs::create_directories(history.parent_path(), ignored);
  descriptor_ = open((history.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  close(descriptor_);
  throw std::runtime_error(history.string() + ": in use by another fallen-alarm");
}

HistoryLock::~HistoryLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace fallen
