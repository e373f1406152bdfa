// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ground_t.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/iron_t.hpp"
#include "fallen/ndt/ndt_cell.hpp"
#include "fallen/ndt_cells_t.hpp"

/// Parts that several messages share. Internal to this folder.
///
/// `owner` is the name of the message around, for error texts. All throw std::invalid_argument.
namespace fallen {

ndt_cells_t CellsToMessage(const std::vector<NdtCell>& cells);
/// Checks all that NdtCell promises: counts agree, values finite and in bounds, covariance positive
/// definite, points > 0.
/// @param field  Name of the cells, for error texts.
std::vector<NdtCell> CellsFromMessage(const std::string& field, const ndt_cells_t& message);
/// A cell's mean is near the camera, as the mapping leaves them; not NaN.
/// @param field  Name of the cells, `index` the place among them: for error texts.
void CheckNearCamera(const std::string& field, std::size_t index, const Eigen::Vector3f& mean,
                     const Eigen::Isometry3d& T_map_camera);

ground_t GroundToMessage(const GroundEstimate& ground);
GroundEstimate GroundFromMessage(const std::string& owner, const ground_t& message);

iron_t IronToMessage(const IronConfig& iron);
IronConfig IronFromMessage(const std::string& owner, const iron_t& message);

/// Row-major 3 x 4 [R | t], exact; R must be a rotation.
void TransformToMessage(const Eigen::Isometry3d& transform, double (&message)[12]);
Eigen::Isometry3d TransformFromMessage(const std::string& field, const double (&message)[12]);

void CheckCellSize(const std::string& owner, double cell_size_m);

}  // namespace fallen
