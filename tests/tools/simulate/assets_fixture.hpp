// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "tools/simulate/simulation.hpp"

namespace fallen::sim {

/// Tests on real meshes: skipped where tools/fetch-assets has not run.
class WithAssets : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::filesystem::path folder = AssetsFolder(std::nullopt);
    if (std::filesystem::exists(folder / "makehuman" / "targets.bin"))
      assets_ = new Assets(LoadAssets(folder));
  }
  static void TearDownTestSuite() {
    delete assets_;
    assets_ = nullptr;
  }
  void SetUp() override {
    if (assets_ == nullptr) GTEST_SKIP() << "no assets: run tools/fetch-assets";
  }
  static const Assets& assets() { return *assets_; }

 private:
  inline static Assets* assets_ = nullptr;
};

}  // namespace fallen::sim
