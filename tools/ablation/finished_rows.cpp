// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/finished_rows.hpp"

#include <cctype>
#include <cstdio>
#include <fstream>
#include <utility>

#include "tools/common/partial_file.hpp"

namespace fallen {
namespace {

std::string Rate(const nlohmann::json& value) {
  if (!value.is_number()) return "–";
  char text[16];
  std::snprintf(text, sizeof text, "%.3f", value.get<double>());
  return text;
}

std::string WithInterval(const nlohmann::json& figures, const char* key) {
  const nlohmann::json& interval = figures.at("intervals").at(key);
  return Rate(figures.at(key)) + " (" + Rate(interval.at(0)) + "–" + Rate(interval.at(1)) + ")";
}

std::string Signed(const nlohmann::json& value) {
  if (!value.is_number()) return "–";
  char text[16];
  std::snprintf(text, sizeof text, "%+.3f", value.get<double>());
  return text;
}

std::string DifferenceOf(const nlohmann::json& result, const char* key) {
  if (!result.contains("difference")) return "";
  const nlohmann::json& difference = result.at("difference").at(key);
  const nlohmann::json& interval = difference.at("interval");
  return Signed(difference.at("difference")) + " (" + Signed(interval.at(0)) + " to " +
         Signed(interval.at(1)) + ")";
}

}  // namespace

FinishedRows::FinishedRows(std::filesystem::path folder, std::string data)
    : folder_(std::move(folder)), data_(std::move(data)) {
  std::filesystem::create_directories(folder_);
}

std::filesystem::path FinishedRows::FileOf(const AblationRow& row) const {
  std::string name;
  for (const char c : row.name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? std::string(1, c) : std::string("-");
  return folder_ / (name + ".json");
}

std::optional<nlohmann::json> FinishedRows::Find(const AblationRow& row) const {
  std::ifstream file(FileOf(row));
  if (!file) return std::nullopt;
  const nlohmann::json result = nlohmann::json::parse(file, nullptr, false);
  const bool is_this = result.is_object() && result.value("name", "") == row.name &&
                       result.value("settings", "") == row.Settings() &&
                       result.value("data", "") == data_;
  return is_this ? std::optional(result) : std::nullopt;
}

void FinishedRows::Keep(const AblationRow& row, const nlohmann::json& figures,
                        const nlohmann::json& outcomes) const {
  const nlohmann::json result = {{"name", row.name},
                                 {"settings", row.Settings()},
                                 {"data", data_},
                                 {"figures", figures},
                                 {"outcomes", outcomes}};
  PartialFile file(FileOf(row));
  std::ofstream stream(file.path());
  if (!(stream << result.dump() << "\n" << std::flush))
    throw std::runtime_error(FileOf(row).string() + ": cannot be written");
  file.Commit();
}

std::string MarkdownTable(const std::vector<nlohmann::json>& results) {
  std::string table =
      "| variant | miss rate at 0.01 | at 0.1 | log-average miss rate | minus the first's |\n"
      "|---|---|---|---|---|\n";
  for (const nlohmann::json& result : results) {
    const nlohmann::json& figures = result.at("figures");
    table += "| " + result.at("name").get<std::string>() + " | " +
             WithInterval(figures, "miss_rate_at_0.01_fppf") + " | " +
             WithInterval(figures, "miss_rate_at_0.1_fppf") + " | " +
             WithInterval(figures, "log_average_miss_rate") + " | " +
             DifferenceOf(result, "log_average_miss_rate") + " |\n";
  }
  return table;
}

}  // namespace fallen
