// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The comparison detector, in the style of the paper's reference [16].
///
/// [Volkhardt13] Volkhardt, Schneemann, Gross: Fallen person detection for mobile robots using 3D
///               depth data. SMC 2013. The paper's [16].
/// [Hegger12]    Hegger, Hochgeschwender, Kraetzschmar, Ploeger: People detection in 3d point
///               clouds using local surface normals. RoboCup 2012.
///
/// From [Volkhardt13], as its abstract and the paper tell: single point clouds; the ground plane is
/// removed; Euclidean clusters of what is left are the candidates; each is cut into layers parallel
/// to the ground; histograms of local surface normals ([Hegger12]: three histograms and the extents
/// of a layer) describe it; a trained classifier judges it. Its thresholds and sizes are not
/// published where we could read them: ours are tuned on our validation set.
/// Ours: how the ground is found (as for the detector), the axes that normals are binned along, the
/// columns about the cluster as a whole, boosted trees as classifier, the calibration.
namespace fallen {

/// Settings of the baseline up to its features; a model is trained for one set of them.
struct BaselineConfig {
  double max_range_m = 5.0;  ///< depth along the optical axis, > 0: as for the detector
  /// Points below clearance + per_sq * depth^2 over the floor are floor [m], [1/m]; both >= 0.
  double ground_clearance_m = 0.04;
  double ground_clearance_per_sq_m = 0.003;
  // Tuned on simulated validation recordings, but for the bins.
  double max_height_m = 0.4;          ///< points higher above the floor are left out, > 0
  double leaf_m = 0.02;               ///< edge of the grid that thins the cloud, > 0
  double normal_radius_m = 0.06;      ///< neighbourhood of a surface normal, >= leaf
  double cluster_tolerance_m = 0.04;  ///< points nearer to each other belong together, >= leaf
  int min_cluster_points = 120;       ///< of the thinned cloud, >= 3
  int layers = 8;                     ///< [1, 100]; the highest has no upper end
  double layer_height_m = 0.05;       ///< > 0
  int normal_bins = 7;  ///< of each of a layer's three histograms, [1, 100]; [Hegger12]

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("max_range_m", max_range_m);
    visit("ground_clearance_m", ground_clearance_m);
    visit("ground_clearance_per_sq_m", ground_clearance_per_sq_m);
    visit("max_height_m", max_height_m);
    visit("leaf_m", leaf_m);
    visit("normal_radius_m", normal_radius_m);
    visit("cluster_tolerance_m", cluster_tolerance_m);
    visit("min_cluster_points", min_cluster_points);
    visit("layers", layers);
    visit("layer_height_m", layer_height_m);
    visit("normal_bins", normal_bins);
  }
  bool operator==(const BaselineConfig&) const = default;
};

}  // namespace fallen
