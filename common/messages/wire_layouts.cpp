// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The types of lcmtypes/ once more, for the walk before the decode. A test reads the .lcm files and
// compares.
#include "fallen/baseline_model_t.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/depth_image_t.hpp"
#include "fallen/environment_map_t.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/ground_truth_t.hpp"
#include "fallen/header_t.hpp"
#include "fallen/messages/wire_layout.hpp"
#include "fallen/model_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/pose_t.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen::wire {
namespace {

using enum Kind;

constexpr Field kHeaderFields[] = {{kInt64, "utime"}, {kInt64, "seq"}, {kString, "sensor_name"}};
constexpr Layout kHeader{"header_t", kHeaderFields};

constexpr Field kPoseFields[] = {
    {kInt64, "utime"},           {kDouble, "pos", 3},           {kDouble, "vel", 3},
    {kDouble, "orientation", 4}, {kDouble, "rotation_rate", 3}, {kDouble, "accel", 3}};
constexpr Layout kPose{"pose_t", kPoseFields};

constexpr Field kDepthImageFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                       {kInt32, "width"},
                                       {kInt32, "height"},
                                       {kDouble, "fx"},
                                       {kDouble, "fy"},
                                       {kDouble, "cx"},
                                       {kDouble, "cy"},
                                       {kDouble, "depth_unit_m"},
                                       {kBoolean, "has_mounting"},
                                       {kDouble, "mounting_position", 3},
                                       {kDouble, "mounting_orientation", 4},
                                       {kInt8, "compression"},
                                       {kInt32, "size"},
                                       {kByte, "data", "size"}};
constexpr Layout kDepthImage{"depth_image_t", kDepthImageFields};

constexpr Field kCameraViewFields[] = {
    {kInt32, "width"}, {kInt32, "height"}, {kDouble, "fx"},   {kDouble, "fy"},
    {kDouble, "cx"},   {kDouble, "cy"},    {kInt32, "count"}, {kInt16, "depth_mm", "count"}};
constexpr Layout kCameraView{"camera_view_t", kCameraViewFields};

constexpr Field kGroundFields[] = {{kInt32, "status"},       {kInt32, "method"},
                                   {kDouble, "normal", 3},   {kDouble, "offset"},
                                   {kInt32, "inlier_count"}, {kInt32, "point_count"}};
constexpr Layout kGround{"ground_t", kGroundFields};

constexpr Field kNdtCellsFields[] = {{kInt32, "count"},
                                     {kFloat, "mean_x", "count"},
                                     {kFloat, "mean_y", "count"},
                                     {kFloat, "mean_z", "count"},
                                     {kFloat, "covariance_xx", "count"},
                                     {kFloat, "covariance_xy", "count"},
                                     {kFloat, "covariance_xz", "count"},
                                     {kFloat, "covariance_yy", "count"},
                                     {kFloat, "covariance_yz", "count"},
                                     {kFloat, "covariance_zz", "count"},
                                     {kInt32, "point_count", "count"},
                                     {kFloat, "occupancy", "count"}};
constexpr Layout kNdtCells{"ndt_cells_t", kNdtCellsFields};

constexpr Field kNdtMapFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                   {kDouble, "cell_size_m"},
                                   {kInt32, "frame"},
                                   {kDouble, "T_map_camera", 12},
                                   {kStruct, "view", 1, 1, &kCameraView},
                                   {kStruct, "ground", 1, 1, &kGround},
                                   {kStruct, "cells", 1, 1, &kNdtCells},
                                   {kInt32, "background_status"},
                                   {kInt32, "flag_count"},
                                   {kByte, "is_foreground", "flag_count"}};
constexpr Layout kNdtMap{"ndt_map_t", kNdtMapFields};

constexpr Field kIronFields[] = {{kDouble, "radius_m"},         {kInt32, "distance_bins"},
                                 {kInt32, "angle_bins"},        {kDouble, "max_ball_ratio"},
                                 {kDouble, "min_needle_ratio"}, {kInt32, "min_neighbors"}};
constexpr Layout kIron{"iron_t", kIronFields};

constexpr Field kClustersFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                     {kDouble, "cell_size_m"},
                                     {kInt32, "frame"},
                                     {kDouble, "T_map_camera", 12},
                                     {kStruct, "view", 1, 1, &kCameraView},
                                     {kStruct, "ground", 1, 1, &kGround},
                                     {kInt32, "background_status"},
                                     {kStruct, "iron", 1, 1, &kIron},
                                     {kInt32, "cell_count"},
                                     {kFloat, "score", "cell_count"},
                                     {kInt32, "cluster", "cell_count"},
                                     {kStruct, "members", 1, 1, &kNdtCells},
                                     {kInt32, "other_count"},
                                     {kFloat, "other_mean_x", "other_count"},
                                     {kFloat, "other_mean_y", "other_count"},
                                     {kFloat, "other_mean_z", "other_count"},
                                     {kInt32, "dimension"},
                                     {kInt32, "descriptor_count"},
                                     {kFloat, "descriptor", "descriptor_count", "dimension"}};
constexpr Layout kClusters{"clusters_t", kClustersFields};

constexpr Field kBoxFields[] = {{kDouble, "center", 3}, {kDouble, "size", 3}, {kDouble, "yaw"}};
constexpr Layout kBox{"box_t", kBoxFields};

constexpr Field kFallenPersonFields[] = {
    {kDouble, "centroid", 3}, {kStruct, "box", 1, 1, &kBox},
    {kDouble, "probability"}, {kDouble, "mahalanobis_distance"},
    {kInt32, "cell_count"},   {kDouble, "mean_score"},
    {kBoolean, "is_person"}};
constexpr Layout kFallenPerson{"fallen_person_t", kFallenPersonFields};

constexpr Field kFallenPersonsFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                          {kInt32, "frame"},
                                          {kDouble, "T_map_camera", 12},
                                          {kStruct, "view", 1, 1, &kCameraView},
                                          {kDouble, "min_probability"},
                                          {kInt32, "count"},
                                          {kStruct, "hypotheses", "count", 1, &kFallenPerson}};
constexpr Layout kFallenPersons{"fallen_persons_t", kFallenPersonsFields};

constexpr Field kLabelledObjectFields[] = {
    {kString, "category"}, {kString, "name"}, {kInt32, "label"}, {kStruct, "box", 1, 1, &kBox}};
constexpr Layout kLabelledObject{"labelled_object_t", kLabelledObjectFields};

constexpr Field kGroundTruthFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                        {kBoolean, "person_present"},
                                        {kStruct, "person_box", 1, 1, &kBox},
                                        {kString, "person"},
                                        {kString, "room"},
                                        {kInt32, "object_count"},
                                        {kStruct, "objects", "object_count", 1, &kLabelledObject},
                                        {kInt32, "width"},
                                        {kInt32, "height"},
                                        {kInt32, "size"},
                                        {kByte, "labels", "size"}};
constexpr Layout kGroundTruth{"ground_truth_t", kGroundTruthFields};

constexpr Field kServiceStatusFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                          {kString, "service"},
                                          {kString, "version"},
                                          {kInt64, "pid"},
                                          {kInt8, "state"},
                                          {kString, "text"},
                                          {kInt64, "received"},
                                          {kInt64, "published"},
                                          {kInt64, "dropped_late"},
                                          {kInt64, "dropped_damaged"},
                                          {kInt64, "lost_upstream"},
                                          {kInt64, "skipped"},
                                          {kDouble, "rate_hz"},
                                          {kDouble, "median_ms"},
                                          {kDouble, "p99_ms"},
                                          {kInt64, "resident_bytes"}};
constexpr Layout kServiceStatus{"service_status_t", kServiceStatusFields};

constexpr Field kTreesFields[] = {{kInt32, "feature_count"},
                                  {kInt32, "tree_count"},
                                  {kInt32, "root", "tree_count"},
                                  {kInt32, "node_count"},
                                  {kInt32, "node_feature", "node_count"},
                                  {kFloat, "node_threshold", "node_count"},
                                  {kInt32, "node_left", "node_count"},
                                  {kFloat, "node_value", "node_count"}};
constexpr Layout kTrees{"trees_t", kTreesFields};

constexpr Field kNetworkLayerFields[] = {{kInt32, "input_count"},
                                         {kInt32, "output_count"},
                                         {kFloat, "weight", "input_count", "output_count"},
                                         {kFloat, "bias", "output_count"}};
constexpr Layout kNetworkLayer{"network_layer_t", kNetworkLayerFields};

constexpr Field kNetworkFields[] = {{kInt32, "feature_count"},
                                    {kFloat, "mean", "feature_count"},
                                    {kFloat, "scale", "feature_count"},
                                    {kInt32, "layer_count"},
                                    {kStruct, "layers", "layer_count", 1, &kNetworkLayer}};
constexpr Layout kNetwork{"network_t", kNetworkFields};

constexpr Field kModelFields[] = {
    {kString, "description"},
    {kDouble, "cell_size_m"},
    {kStruct, "iron", 1, 1, &kIron},
    {kStruct, "gate_trees", 1, 1, &kTrees},
    {kDouble, "gate_min_score"},
    {kDouble, "gate_turned_away_score"},
    {kInt32, "features"},
    {kStruct, "cell_trees", 1, 1, &kTrees},
    {kDouble, "smoothing_radius_m"},
    {kDouble, "min_score"},
    {kDouble, "max_height_m"},
    {kDouble, "cluster_epsilon_m"},
    {kInt32, "cluster_min_points"},
    {kInt32, "min_cluster_cells"},
    {kBoolean, "descriptors_on_foreground_only"},
    {kInt32, "dimension"},
    {kInt32, "unit_count"},
    {kFloat, "codebook", "unit_count", "dimension"},
    {kDouble, "alpha"},
    {kDouble, "gaussian_mean", "unit_count"},
    {kDouble, "gaussian_covariance", "unit_count", "unit_count"},
    {kStruct, "cluster_trees", 1, 1, &kTrees},
    {kStruct, "cluster_network", 1, 1, &kNetwork},
    {kDouble, "network_share"},
    {kDouble, "calibration_slope"},
    {kDouble, "calibration_intercept"},
    {kInt32, "operating_point_count"},
    {kDouble, "operating_point_min_probability", "operating_point_count"},
    {kDouble, "operating_point_false_positives_per_frame", "operating_point_count"},
    {kDouble, "operating_point_miss_rate", "operating_point_count"}};
constexpr Layout kModel{"model_t", kModelFields};

constexpr Field kBaselineModelFields[] = {
    {kString, "description"},
    {kDouble, "max_range_m"},
    {kDouble, "ground_clearance_m"},
    {kDouble, "ground_clearance_per_sq_m"},
    {kDouble, "max_height_m"},
    {kDouble, "leaf_m"},
    {kDouble, "normal_radius_m"},
    {kDouble, "cluster_tolerance_m"},
    {kInt32, "min_cluster_points"},
    {kInt32, "layers"},
    {kDouble, "layer_height_m"},
    {kInt32, "normal_bins"},
    {kStruct, "trees", 1, 1, &kTrees},
    {kDouble, "calibration_slope"},
    {kDouble, "calibration_intercept"},
    {kInt32, "operating_point_count"},
    {kDouble, "operating_point_min_probability", "operating_point_count"},
    {kDouble, "operating_point_false_positives_per_frame", "operating_point_count"},
    {kDouble, "operating_point_miss_rate", "operating_point_count"}};
constexpr Layout kBaselineModel{"baseline_model_t", kBaselineModelFields};

constexpr Field kEnvironmentMapFields[] = {
    {kDouble, "cell_size_m"}, {kString, "description"}, {kStruct, "cells", 1, 1, &kNdtCells}};
constexpr Layout kEnvironmentMap{"environment_map_t", kEnvironmentMapFields};

constexpr Field kFallAlarmFields[] = {{kStruct, "header", 1, 1, &kHeader},
                                      {kString, "robot"},
                                      {kString, "event_id"},
                                      {kInt32, "revision"},
                                      {kInt8, "change"},
                                      {kInt64, "first_utime"},
                                      {kInt64, "raised_utime"},
                                      {kInt64, "acknowledged_utime"},
                                      {kString, "acknowledged_by"},
                                      {kInt64, "cleared_utime"},
                                      {kString, "cleared_by"},
                                      {kInt32, "frame"},
                                      {kDouble, "position", 3},
                                      {kStruct, "box", 1, 1, &kBox},
                                      {kDouble, "probability"},
                                      {kDouble, "best_probability"},
                                      {kInt32, "views"},
                                      {kInt32, "frames"}};
constexpr Layout kFallAlarm{"fall_alarm_t", kFallAlarmFields};

constexpr Field kFallAlarmAckFields[] = {
    {kStruct, "header", 1, 1, &kHeader}, {kString, "event_id"}, {kString, "by"}, {kInt8, "action"}};
constexpr Layout kFallAlarmAck{"fall_alarm_ack_t", kFallAlarmAckFields};

}  // namespace

template <>
const Layout& LayoutOf<header_t>() {
  return kHeader;
}
template <>
const Layout& LayoutOf<pose_t>() {
  return kPose;
}
template <>
const Layout& LayoutOf<depth_image_t>() {
  return kDepthImage;
}
template <>
const Layout& LayoutOf<ndt_map_t>() {
  return kNdtMap;
}
template <>
const Layout& LayoutOf<clusters_t>() {
  return kClusters;
}
template <>
const Layout& LayoutOf<fallen_persons_t>() {
  return kFallenPersons;
}
template <>
const Layout& LayoutOf<ground_truth_t>() {
  return kGroundTruth;
}
template <>
const Layout& LayoutOf<service_status_t>() {
  return kServiceStatus;
}
template <>
const Layout& LayoutOf<model_t>() {
  return kModel;
}
template <>
const Layout& LayoutOf<baseline_model_t>() {
  return kBaselineModel;
}
template <>
const Layout& LayoutOf<environment_map_t>() {
  return kEnvironmentMap;
}
template <>
const Layout& LayoutOf<fall_alarm_t>() {
  return kFallAlarm;
}
template <>
const Layout& LayoutOf<fall_alarm_ack_t>() {
  return kFallAlarmAck;
}

}  // namespace fallen::wire
