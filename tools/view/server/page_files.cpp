// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/page_files.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace fallen {
namespace {

const std::map<std::string, std::string>& MimeTypes() {
  static const std::map<std::string, std::string> kTypes = {
      {".html", "text/html; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".svg", "image/svg+xml"}};
  return kTypes;
}

std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

PageFiles::PageFiles(const std::filesystem::path& folder) {
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
    const auto type = MimeTypes().find(entry.path().extension().string());
    if (!entry.is_regular_file() || type == MimeTypes().end()) continue;
    const std::string name = "/" + entry.path().lexically_relative(folder).generic_string();
    files_[name] = {ReadFile(entry.path()), type->second};
  }
  for (const char* needed : {"/index.html", "/three/three.module.min.js"})
    if (!files_.contains(needed))
      throw std::runtime_error(
          folder.string() + ": page files: got no " + (needed + 1) +
          ", expected the page: run npm ci in tools/view/page and build again");
}

const PageFiles::File* PageFiles::Find(const std::string& path) const {
  const auto found = files_.find(path == "/" ? "/index.html" : path);
  return found == files_.end() ? nullptr : &found->second;
}

std::filesystem::path ShippedPagePath() {
  std::error_code error;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
  return executable.parent_path().parent_path() / "share" / "fallen" / "page";
}

}  // namespace fallen
