// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {

/// fallen-view on a free port, with a page of two small files.
class Viewer {
 public:
  explicit Viewer(const std::vector<std::string>& arguments) {
    WritePage(folder_.path() / "page");
    std::vector<std::string> command = {testing_support::Program("fallen-view"), "--port", "0",
                                        "--page", (folder_.path() / "page").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    process_.emplace(command, folder_.path());
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (address().empty() && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  static void WritePage(const std::filesystem::path& page) {
    std::filesystem::create_directories(page / "three");
    std::ofstream(page / "index.html") << "<p>page</p>";
    std::ofstream(page / "three" / "three.module.min.js") << "export {};";
  }

  /// What it printed: the address to open.
  std::string address() const {
    std::smatch found;
    const std::string text = process_->StandardOutput();
    return std::regex_search(text, found, std::regex("(http://\\S+)\n")) ? found[1].str() : "";
  }
  int port() const {
    std::smatch found;
    const std::string text = address();
    return std::regex_search(text, found, std::regex(":(\\d+)/")) ? std::stoi(found[1]) : 0;
  }
  testing_support::ChildProcess& process() { return *process_; }

 private:
  TemporaryFolder folder_;
  std::optional<testing_support::ChildProcess> process_;
};

}  // namespace fallen
