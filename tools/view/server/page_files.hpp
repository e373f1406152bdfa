// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace fallen {

/// The files of the page, read once: nothing else on the disk can be asked for.
class PageFiles {
 public:
  struct File {
    std::string content;
    std::string type;  ///< MIME
  };

  /// @throws std::runtime_error if `folder` holds no page.
  explicit PageFiles(const std::filesystem::path& folder);

  /// The file of a request's path, "/" being index.html; nullptr if there is none.
  const File* Find(const std::string& path) const;

 private:
  std::map<std::string, File> files_;
};

/// The page beside the executable, as installed and as built: share/fallen/page.
std::filesystem::path ShippedPagePath();

}  // namespace fallen
