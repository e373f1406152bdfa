// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>

#include "fallen/messages/container_file.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/messages/model_files.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class EnvironmentMapFile : public testing::Test {
 protected:
  EnvironmentMapFile()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("environment_map_file_test_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~EnvironmentMapFile() override { std::filesystem::remove_all(folder_); }

  std::string Content() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void SetContent(const std::string& content) const {
    std::ofstream(path_, std::ios::binary) << content;
  }
  std::string LoadError() const {
    try {
      LoadEnvironmentMap(path_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
  std::filesystem::path path_ = folder_ / "kitchen.map";
};

TEST_F(EnvironmentMapFile, GivesBackWhatWasSaved) {
  const EnvironmentMap map{0.1, samples::SampleCells(100)};
  SaveEnvironmentMap(path_, map, "the kitchen");
  const EnvironmentMap back = LoadEnvironmentMap(path_);
  EXPECT_EQ(back.cell_size_m, map.cell_size_m);
  EXPECT_EQ(back.cells, map.cells);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1)
      << "nothing is left beside it";
}

TEST_F(EnvironmentMapFile, IsTheSameFileForTheSameMap) {
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(100)}, "x");
  const std::string first = Content();
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(100)}, "x");
  EXPECT_EQ(Content(), first);
}

TEST_F(EnvironmentMapFile, SaysThatItIsNotThere) {
  EXPECT_EQ(LoadError(), path_.string() + ": cannot open: No such file or directory");
  EXPECT_THROW(LoadEnvironmentMap(folder_), std::runtime_error);
}

TEST_F(EnvironmentMapFile, SaysThatItIsNoSuchFile) {
  SetContent("ply\nformat ascii 1.0\n and more");
  EXPECT_EQ(
      LoadError(),
      path_.string() +
          ": first bytes: got \"ply.form\", expected \"FALLENEM\" of an environment map file");
  SetContent("");
  EXPECT_THAT(LoadError(), HasSubstr("first bytes: got \"\""));
  SetContent("FALLENMD....................");
  EXPECT_THAT(LoadError(), HasSubstr("got \"FALLENMD\", expected \"FALLENEM\""));
}

TEST_F(EnvironmentMapFile, SaysThatItIsOfAnotherVersion) {
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(10)}, "");
  std::string content = Content();
  content[11] = 2;
  SetContent(content);
  EXPECT_EQ(LoadError(), path_.string() + ": version: got 2, expected 1");
}

TEST_F(EnvironmentMapFile, SaysThatItIsTruncatedAtEveryByte) {
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(10)}, "");
  const std::string content = Content();
  for (std::size_t size = 8; size < content.size(); ++size) {
    SetContent(content.substr(0, size));
    EXPECT_THAT(LoadError(),
                HasSubstr(": size: got " + std::to_string(size) + " bytes, expected "));
  }
  SetContent(content + "x");
  EXPECT_THAT(LoadError(), HasSubstr(": size: got "));
}

TEST_F(EnvironmentMapFile, SaysThatItIsDamagedAtEveryByte) {
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(10)}, "");
  const std::string content = Content();
  for (std::size_t byte = 0; byte < content.size(); ++byte) {
    std::string damaged = content;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 0x10);
    SetContent(damaged);
    EXPECT_THAT(LoadError(), HasSubstr(byte < 8    ? "first bytes"
                                       : byte < 12 ? "version"
                                       : byte < 16 ? "check sum"
                                       : byte < 24 ? "size"
                                                   : "check sum"))
        << byte;
  }
}

TEST_F(EnvironmentMapFile, SaysThatItsValuesMakeNoSense) {
  environment_map_t message = ToMessage(EnvironmentMap{0.1, samples::SampleCells(10)}, "");
  message.cells.covariance_yy[3] = -1;
  WriteContainer(path_, {"FALLENEM", "", 1}, EncodeMessage(message));
  EXPECT_EQ(LoadError(), path_.string() +
                             ": environment_map_t.cells[3].covariance: got a matrix that is not, "
                             "expected a positive definite one");
  WriteContainer(path_, {"FALLENEM", "", 1}, EncodeMessage(samples::SamplePose()));
  EXPECT_THAT(LoadError(), HasSubstr(": environment_map_t: got a message of another type"));
}

TEST_F(EnvironmentMapFile, ABadMapLeavesTheOldFile) {
  SaveEnvironmentMap(path_, {0.1, samples::SampleCells(10)}, "");
  const std::string content = Content();
  EXPECT_THROW(SaveEnvironmentMap(path_, {-1, {}}, ""), std::invalid_argument);
  EXPECT_EQ(Content(), content);
  EXPECT_THROW(SaveEnvironmentMap("/nowhere/a.map", {0.1, {}}, ""), std::runtime_error);
}

TEST_F(EnvironmentMapFile, AMillionCellsLoadInASecond) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  EnvironmentMap map{0.05, {}};
  for (int i = 0; i < 1'000'000; ++i) {
    NdtCell cell;
    cell.mean = {100 * uniform(random), 100 * uniform(random), 3 * uniform(random)};
    cell.covariance = {2e-4f + 1e-4f * uniform(random), 1e-5f * uniform(random),
                       1e-5f * uniform(random),         2e-4f + 1e-4f * uniform(random),
                       1e-5f * uniform(random),         2e-4f + 1e-4f * uniform(random)};
    cell.point_count = static_cast<std::uint32_t>(4 + random() % 400);
    cell.occupancy = 4 * uniform(random);
    map.cells.push_back(cell);
  }
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](auto span) { return std::chrono::duration<double>(span).count(); };
  const auto start = Clock::now();
  SaveEnvironmentMap(path_, map, "random");
  const auto middle = Clock::now();
  const EnvironmentMap back = LoadEnvironmentMap(path_);
  const auto end = Clock::now();
  std::printf("1000000 cells: %.1f MB, saved in %.2f s, loaded in %.2f s\n",
              static_cast<double>(std::filesystem::file_size(path_)) / 1e6, seconds(middle - start),
              seconds(end - middle));
  EXPECT_TRUE(back.cells == map.cells);
#ifdef NDEBUG
  EXPECT_LT(seconds(end - middle), 3) << "1 s is the aim; the rest is for a busy machine";
#endif
}

}  // namespace
}  // namespace fallen
