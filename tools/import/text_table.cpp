// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/text_table.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "tools/import/input_error.hpp"

namespace fallen {
namespace {

constexpr double kMicrosecondsPerSecond = 1e6;
/// Beyond the year 30 000: a double no longer tells microseconds apart there.
constexpr double kMaxSeconds = 9e11;
/// A line is quoted in an error up to here.
constexpr std::size_t kQuotedCharacters = 60;

std::string Quote(std::string text) {
  if (text.size() > kQuotedCharacters) text = text.substr(0, kQuotedCharacters) + "...";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  return "\"" + text + "\"";
}

std::optional<double> ParseNumber(const std::string& text) {
  double value = 0;
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::int64_t ParseTime(const std::filesystem::path& file, int line, const std::string& text) {
  const std::optional<double> seconds = ParseNumber(text);
  if (!seconds || *seconds < 0 || *seconds > kMaxSeconds)
    throw InputError(file, line, "timestamp " + Quote(text), "seconds from 0 to 9e11");
  return std::llround(*seconds * kMicrosecondsPerSecond);
}

}  // namespace

std::vector<TableRow> ReadTimedTable(const std::filesystem::path& file,
                                     const std::string& expected_row, std::size_t field_count) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
    throw InputError(file, 0, "no readable file", "rows of \"" + expected_row + "\"");

  std::vector<TableRow> rows;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text);
    std::string first;
    if (!(words >> first) || first.front() == '#') continue;

    TableRow row;
    row.line = line;
    for (std::string field; words >> field;) row.fields.push_back(field);
    if (row.fields.size() != field_count)
      throw InputError(file, line, Quote(text), "\"" + expected_row + "\"");
    row.utime = ParseTime(file, line, first);
    if (!rows.empty() && row.utime <= rows.back().utime)
      throw InputError(file, line, "timestamp " + first,
                       "a later one than in line " + std::to_string(rows.back().line));
    rows.push_back(std::move(row));
  }
  return rows;
}

double NumberField(const std::filesystem::path& file, const TableRow& row, std::size_t index,
                   const std::string& name) {
  const std::optional<double> value = ParseNumber(row.fields.at(index));
  if (!value)
    throw InputError(file, row.line, name + " " + Quote(row.fields[index]), "a finite number");
  return *value;
}

}  // namespace fallen
