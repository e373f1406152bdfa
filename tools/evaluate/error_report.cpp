// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/error_report.hpp"

#include <fstream>
#include <stdexcept>

#include "tools/common/partial_file.hpp"
#include "tools/evaluate/case_pictures.hpp"

namespace fallen {
namespace {

void WriteText(const std::filesystem::path& path, const std::string& text) {
  PartialFile file(path);
  std::ofstream stream(file.path(), std::ios::binary);
  if (!(stream << text << std::flush))
    throw std::runtime_error(path.string() + ": cannot be written");
  file.Commit();
}

nlohmann::json ListJson(const std::vector<ErrorCase>& list) {
  nlohmann::json json = nlohmann::json::array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    json.push_back(ToJson(list[i]));
    json.back()["picture"] = PictureName(list[i].is_miss, i);
  }
  return json;
}

}  // namespace

void WriteErrorReport(const std::filesystem::path& folder, const WorstCases& worst,
                      const ErrorReportHead& head, const DetectorOptions& detector, int jobs) {
  std::filesystem::create_directories(folder);
  std::vector<CasePicture> pictures;
  for (const auto* list : {&worst.misses, &worst.false_alarms})
    for (std::size_t i = 0; i < list->size(); ++i) {
      const ErrorCase& error = (*list)[i];
      pictures.push_back({error.log, error.frame, folder / PictureName(error.is_miss, i)});
    }
  DrawCases(pictures, detector, jobs);
  const nlohmann::json cases = {{"recordings", head.recordings},
                                {"frames", head.frames},
                                {"min_probability", head.min_probability},
                                {"misses", ListJson(worst.misses)},
                                {"false_alarms", ListJson(worst.false_alarms)}};
  WriteText(folder / "cases.json", cases.dump(2) + "\n");
  WriteText(folder / "index.html", ErrorPage(worst, head));
}

}  // namespace fallen
