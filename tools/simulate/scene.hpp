// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "fallen/geometry/oriented_box.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// What stands and lies in a room. Frame `world`: z up, the floor at z = 0, origin at the middle of
/// the room.
namespace fallen::sim {

/// Category of the person that the detector is to find.
inline constexpr char kFallenPerson[] = "fallen_person";
inline constexpr char kFurniture[] = "furniture";

struct SceneObject {
  std::string category;
  std::string name;
  TriangleMesh mesh;  ///< world frame
  OrientedBox box;    ///< around the mesh
};

struct Scene {
  Eigen::Vector2d room_size = Eigen::Vector2d::Zero();  ///< along x and y [m]
  TriangleMesh shell;  ///< floor, walls, ceiling: background, without a label
  std::vector<SceneObject> objects;
};

/// Box with the given yaw around all vertices. The mesh must not be empty.
OrientedBox BoxAround(const TriangleMesh& mesh, double yaw);

/// Direction in which a mesh extends the most in the horizontal [rad].
double MainAxisYaw(const TriangleMesh& mesh);

/// Floor, four walls and ceiling. Walls have an albedo of their own.
TriangleMesh MakeShell(const Eigen::Vector2d& room_size, double height_m);

/// Mesh turned by `yaw` and moved to `position`, as an object with its box.
SceneObject PlaceObject(std::string category, std::string name, TriangleMesh mesh,
                        const Eigen::Vector3d& position, double yaw);

}  // namespace fallen::sim
