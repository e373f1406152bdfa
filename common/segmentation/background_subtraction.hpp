// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/ndt/ndt_map.hpp"

namespace fallen {

/// The cells of a place as it is known to be without anybody on the floor. Frame: world.
struct EnvironmentMap {
  double cell_size_m = 0.05;
  std::vector<NdtCell> cells;
  std::string description{};  ///< what it was built from, for people; set by loading
};

struct BackgroundConfig {
  /// The paper's tau^s and tau^d: threshold [m] = (1 - 2 angle / pi) * dynamic + static. Both >= 0.
  /// The paper gives no values; together a cell's diagonal, so that a surface stays background
  /// wherever it cuts its voxels.
  double static_threshold_m = 0.03;
  double dynamic_threshold_m = 0.05;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("static_threshold_m", static_threshold_m);
    visit("dynamic_threshold_m", dynamic_threshold_m);
  }
};

enum class BackgroundStatus : std::int32_t {
  kSubtracted = 0,
  kNoEnvironmentMap = 1,  ///< everything is foreground
  kNoPose = 2,            ///< the local map is not in the world frame: everything is foreground
};
constexpr auto EnumNames(BackgroundStatus) {
  return EnumTable<BackgroundStatus, 3>{
      {{BackgroundStatus::kSubtracted, "subtracted"},
       {BackgroundStatus::kNoEnvironmentMap, "no_environment_map"},
       {BackgroundStatus::kNoPose, "no_pose"}}};
}

/// A local map with the cells marked that are not known background.
struct ForegroundMap {
  NdtMap map;
  std::vector<std::uint8_t> is_foreground;  ///< one flag a cell of `map`
  BackgroundStatus status = BackgroundStatus::kNoEnvironmentMap;
};

/// Background subtraction by a nearest neighbour search in an environment map with a threshold that
/// depends on how alike the normals are (the paper, Sec. III-D.1). Thread-safe after construction.
class BackgroundSubtractor {
 public:
  /// Without an environment map: everything is foreground.
  explicit BackgroundSubtractor(const BackgroundConfig& config = {});
  /// @throws std::invalid_argument if a config value or a cell of the map is out of range.
  BackgroundSubtractor(const EnvironmentMap& environment, const BackgroundConfig& config = {});
  ~BackgroundSubtractor();
  BackgroundSubtractor(BackgroundSubtractor&&) noexcept;
  BackgroundSubtractor& operator=(BackgroundSubtractor&&) noexcept;

  bool has_environment() const;

  /// Marks as background each cell that is nearer to its nearest environment cell than the
  /// threshold of the two cells' normals, whatever these are worth (balls and needles too, as in
  /// the paper).
  /// @throws std::invalid_argument if the map's cell size differs from the environment map's.
  ForegroundMap Subtract(NdtMap map) const;

  /// Likewise for the map that `foreground` holds: sets its flags and its status, in the memory
  /// that is there.
  void Subtract(ForegroundMap& foreground) const;

 private:
  struct Index;
  struct OpenCells;
  void DecideByNormals(OpenCells& open, ForegroundMap& foreground) const;

  std::unique_ptr<Index> index_;
  BackgroundConfig config_;
};

}  // namespace fallen
