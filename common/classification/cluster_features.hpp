// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fallen/classification/cluster_scene.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// Columns of ComputeClusterFeatures before those that follow from the descriptors.
inline constexpr int kClusterShapeFeatures = 226;

/// Number of columns of ComputeClusterFeatures.
int ClusterFeatureCount(const IronConfig& iron, Eigen::Index code_words);

/// What a part needs to know of the cluster that it is a part of.
struct WholeCluster {
  const CellCluster& cluster;
  const OrientedBox& box;  ///< FitUprightBox of it
};

/// What a cluster, or a part of one, looks like: size, height, outline, profile, surface,
/// surroundings, the descriptors' distribution, and its code.
///
/// Goes beyond the paper, whose code says what the surface is like but not how large or how high.
/// The main axis is that of the members' places on the floor, towards the half that is higher in
/// the mean.
/// | column    | value                                                                        |
/// |-----------|------------------------------------------------------------------------------|
/// | 0 - 1     | logarithms of the number of cells and of the Mahalanobis distance            |
/// | 2 - 7     | height above the floor: least, mean, greatest, deviation, quartiles [m]      |
/// | 8 - 20    | share of the cells in each 6 cm of height; below 12 cm                       |
/// | 21 - 24   | box: length, width, height [m], width / length                               |
/// | 25 - 26   | standard deviation along and across the main axis [m]                        |
/// | 27 - 28   | area of the footprint [m^2], share of the box that it fills                  |
/// | 29 - 64   | six slices along the main axis: share of the cells, greatest and mean height,|
/// |           | width, offset across [m], mean score                                         |
/// | 65 - 80   | eight steps of 0.25 m along it, around the mean: cells; greatest height [m]  |
/// | 81 - 91   | scores: quantiles from 5 % to 100 %, mean, deviation, sum of the positive    |
/// | 92 - 94   | distance of the camera along the floor, its height [m], cosine between the   |
/// |           | main axis and the direction to it                                            |
/// | 95 - 110  | shares of the cells by height (under 0.12 m, 0.3 m, above) and inclination;  |
/// |           | of normals by their angle to the main axis                                   |
/// | 111 - 114 | cosine to the vertical: mean, share above 0.9; mean of lambda0 / lambda1,    |
/// |           | lambda1 / lambda2                                                            |
/// | 115 - 119 | sqrt(lambda0): quartiles [m]; mean of the points' logarithm, of the occupancy|
/// | 120 - 124 | other cells relative to the own: in the box and 0.1 m around it; above that, |
/// |           | up to 0.5 m; below; 0.1 to 0.4 m beside; mean score of the first             |
/// | 125 - 136 | other cells within 0.3, 0.6, 1 m: relative to the own, those above 0.5 m,    |
/// |           | greatest height [m], best score                                              |
/// | 137 - 145 | the whole cluster: logarithm of its cells, mean score, greatest height, box, |
/// |           | footprint, share of the box; share of its cells that are here                |
/// | 146 - 225 | ten layers of 5 cm, the last with all above: cells; extent along and across the  |
/// |           | main axis, root mean square offset along and across, offset of the mean      |
/// |           | along [m]; mean cosine of the normals to the vertical, mean sqrt(lambda0)    |
/// | 226 ...   | descriptors: mean and deviation of each value; then `code`                   |
/// @param cluster  Of the scene's map, or a part of one of its clusters.
/// @param box      FitUprightBox of `cluster`.
/// @param code     EncodeCluster of `cluster`.
/// @throws std::invalid_argument for a cluster without cells. All finite. Deterministic.
/// O(cells of the map).
Eigen::RowVectorXf ComputeClusterFeatures(const ClusterScene& scene, const CellCluster& cluster,
                                          const OrientedBox& box, const WholeCluster& whole,
                                          const Eigen::VectorXd& code, double mahalanobis_distance);
/// Likewise, into memory that is there.
void ComputeClusterFeatures(const ClusterScene& scene, const CellCluster& cluster,
                            const OrientedBox& box, const WholeCluster& whole,
                            const Eigen::VectorXd& code, double mahalanobis_distance,
                            Eigen::RowVectorXf& values);

}  // namespace fallen
