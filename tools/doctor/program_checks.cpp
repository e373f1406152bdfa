// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/program_checks.hpp"

#include <unistd.h>

#include <filesystem>
#include <sstream>

namespace fallen {
namespace {

struct Need {
  const char* name;
  const char* purpose;
  const char* package;  // of Debian
};
constexpr Need kPrograms[] = {
    {"lcm-logger", "recording", "liblcm-bin"},
    {"lcm-logplayer", "replaying recordings", "liblcm-bin"},
    {"java", "looking at messages with lcm-spy", "default-jre-headless"},
};
constexpr Need kArchives[] = {
    {"lcm.jar", "looking at messages with lcm-spy", "liblcm-java"},
    {"jchart2d.jar", "looking at messages with lcm-spy", "libjchart2d-java"},
};

/// Where `program` is found, or "".
std::string Find(const std::string& program, const std::string& search_path) {
  std::istringstream folders(search_path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path candidate = std::filesystem::path(folder) / program;
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error) && access(candidate.c_str(), X_OK) == 0)
      return candidate.string();
  }
  return "";
}

Finding Judge(const Need& need, const std::string& place) {
  if (!place.empty()) return Good(need.name, place);
  return {need.name, Verdict::kWarning, std::string("not found, needed for ") + need.purpose,
          std::string("sudo apt-get install -y ") + need.package};
}

}  // namespace

std::vector<Finding> CheckPrograms(const std::string& search_path, const std::string& java_folder) {
  std::vector<Finding> findings;
  for (const Need& need : kPrograms) findings.push_back(Judge(need, Find(need.name, search_path)));
  for (const Need& need : kArchives) {
    const std::filesystem::path archive = std::filesystem::path(java_folder) / need.name;
    std::error_code error;
    const bool is_there = std::filesystem::exists(archive, error);
    findings.push_back(Judge(need, is_there ? archive.string() : ""));
  }
  return findings;
}

}  // namespace fallen
