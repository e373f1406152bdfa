// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fallen/geometry/camera_intrinsics.hpp"
#include "tools/simulate/scene.hpp"

namespace fallen::sim {

/// What a pinhole camera sees without any noise, row-major.
struct IdealView {
  std::vector<float> depth_m;        ///< z along the optical axis; 0 where nothing is hit
  std::vector<float> cosine;         ///< between the ray and the surface's normal, 0..1
  std::vector<std::uint8_t> albedo;  ///< of the surface, in 1/255
  std::vector<std::uint8_t> label;   ///< 0 for the shell, else 1 + the object's index
  std::vector<std::uint8_t> lit;     ///< whether the projector sees the point, too
};

/// Casts rays into a scene (Embree). Thread-safe once built; the answer does not depend on threads.
class RayCaster {
 public:
  /// The scene's meshes are copied. @throws std::invalid_argument for more than 254 objects.
  explicit RayCaster(const Scene& scene);
  ~RayCaster();

  /// @param jitter_px  Two values a pixel, added to its coordinates; empty for none.
  /// @param projector  Place of the infrared projector in the camera frame [m].
  IdealView Render(const CameraIntrinsics& intrinsics, const Eigen::Isometry3d& T_world_camera,
                   const std::vector<float>& jitter_px, const Eigen::Vector3d& projector) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fallen::sim
