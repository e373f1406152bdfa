// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cells.hpp"

#include <zlib.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr std::size_t kColumns = 3 + 6 + 1 + 48;

std::string ReadGzip(const std::filesystem::path& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error("cannot open " + path.string());
  std::string text;
  std::array<char, 65536> buffer;
  int count = 0;
  while ((count = gzread(file, buffer.data(), buffer.size())) > 0)
    text.append(buffer.data(), count);
  gzclose(file);
  return text;
}

}  // namespace

ReferenceCells ReadReferenceCells(const std::filesystem::path& path) {
  std::istringstream text(ReadGzip(path));
  std::string line;
  std::getline(text, line);  // column names
  ReferenceCells result;
  while (std::getline(text, line)) {
    std::istringstream fields(line);
    std::string field;
    std::vector<double> values;
    while (std::getline(fields, field, ',')) values.push_back(std::stod(field));
    const bool described = values.size() == kColumns;
    if (!described && values.size() != kColumns - 48)
      throw std::runtime_error(path.string() + ": unexpected line: " + line);
    NdtCell cell;
    for (int k = 0; k < 3; ++k) cell.mean[k] = static_cast<float>(values[k]);
    for (int k = 0; k < 6; ++k) cell.covariance[k] = static_cast<float>(values[3 + k]);
    cell.point_count = 1;
    result.cells.push_back(cell);
    result.neighbor_counts.push_back(static_cast<int>(values[9]));
    std::array<double, 48> descriptor{};
    for (int k = 0; described && k < 48; ++k) descriptor[k] = values[10 + k];
    result.descriptors.push_back(descriptor);
  }
  return result;
}

}  // namespace fallen
