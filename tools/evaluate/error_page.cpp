// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>

#include "tools/evaluate/error_report.hpp"

namespace fallen {
namespace {

constexpr char kHead[] = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Worst cases</title>
<style>
:root { --paper: #fff; --ink: #222; --faint: #666; --line: #ddd; --accent: #b0113a }
@media (prefers-color-scheme: dark) {
  :root { --paper: #17181a; --ink: #e6e6e6; --faint: #a0a0a0; --line: #3a3b3e; --accent: #ff6d8d }
}
body { margin: 0 auto; max-width: 1240px; padding: 1.5rem; background: var(--paper); color: var(--ink);
       font: 16px/1.5 system-ui, sans-serif }
nav a, a { color: var(--accent) }
.faint { color: var(--faint) }
figure { margin: 1.5rem 0 2.5rem; border-top: 1px solid var(--line); padding-top: .75rem }
figcaption { margin-bottom: .5rem }
figcaption b { font-variant-numeric: tabular-nums }
img { width: 100%; height: auto; border: 1px solid var(--line) }
</style>
)";

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

template <class... Arguments>
std::string Format(const char* format, Arguments... arguments) {
  char text[160];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

std::string CaseHtml(const ErrorCase& error, std::size_t rank) {
  const std::string name = std::filesystem::path(error.log).filename().string();
  const std::string picture = PictureName(error.is_miss, rank);
  const std::string fault = std::to_string(error.at_fault) + " of " + std::to_string(error.frames) +
                            (error.is_miss ? " frames missed" : " frames above the threshold");
  return "<figure id=\"" + picture.substr(0, picture.size() - 4) + "\"><figcaption><b>" +
         std::to_string(rank + 1) + ". " + Format("p = %.3f", error.probability) + "</b> · " +
         Escaped(error.kind) + " · " + Escaped(name) + ", frame " + std::to_string(error.frame) +
         Format(" <span class=\"faint\">· at (%.2f, %.2f, %.2f) m · ", error.place.x(),
                error.place.y(), error.place.z()) +
         fault + "</span></figcaption><a href=\"" + picture +
         "\"><img loading=\"lazy\" width=\"1600\" " + "height=\"726\" src=\"" + picture +
         "\" alt=\"Depth image and NDT map of " + Escaped(name) + ", frame " +
         std::to_string(error.frame) + "\"></a></figure>\n";
}

std::string ListHtml(const char* id, const char* title, const char* text,
                     const std::vector<ErrorCase>& list) {
  std::string html = std::string("<h2 id=\"") + id + "\">" + title + "</h2>\n<p class=\"faint\">" +
                     (list.empty() ? "None." : text) + "</p>\n";
  for (std::size_t i = 0; i < list.size(); ++i) html += CaseHtml(list[i], i);
  return html;
}

}  // namespace

std::string PictureName(bool is_miss, std::size_t rank) {
  return Format(is_miss ? "miss-%02zu.png" : "false-alarm-%02zu.png", rank + 1);
}

std::string ErrorPage(const WorstCases& worst, const ErrorReportHead& head) {
  return std::string(kHead) + "<h1>Worst cases</h1>\n<p>" + std::to_string(head.recordings) +
         " recordings, " + std::to_string(head.frames) + " frames, threshold " +
         Format("p ≥ %.3f", head.min_probability) +
         ". <a href=\"#misses\">Misses</a> · <a href=\"#false-alarms\">false alarms</a> · "
         "<a href=\"cases.json\">cases.json</a></p>\n" +
         ListHtml(
             "misses", "Misses",
             "Fallen persons, those whose best cluster of all frames is the least likely first. "
             "The picture is the missed frame that shows most of the person.",
             worst.misses) +
         ListHtml(
             "false-alarms", "False alarms",
             "What is taken for a fallen person, the likeliest first, each thing of a recording "
             "once. The picture is the frame in which it is likeliest.",
             worst.false_alarms) +
         "</html>\n";
}

}  // namespace fallen
