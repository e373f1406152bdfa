// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Tables of text with a time in front: `depth.txt`, `groundtruth.txt`.
namespace fallen {

struct TableRow {
  int line = 0;                     ///< in the file, from 1
  std::int64_t utime = 0;           ///< first column [us]; the file says seconds
  std::vector<std::string> fields;  ///< what follows it
};

/// Reads rows of `timestamp field...`; blank lines and lines that start with # are no rows.
///
/// @param expected_row  How a row looks, for the error line: "timestamp filename".
/// @param field_count   Fields that every row must have after the time.
/// @throws InputError if the file cannot be read, a row has other fields, a time is no number of
/// seconds from 0, or is not later than the one before.
std::vector<TableRow> ReadTimedTable(const std::filesystem::path& file,
                                     const std::string& expected_row, std::size_t field_count);

/// Field `index` of `row` as a finite number. @throws InputError.
double NumberField(const std::filesystem::path& file, const TableRow& row, std::size_t index,
                   const std::string& name);

}  // namespace fallen
