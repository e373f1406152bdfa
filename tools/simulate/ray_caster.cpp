// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/ray_caster.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fallen::sim {
namespace {

constexpr int kPacket = 8;             // rays at once
constexpr float kSelfMargin = 0.997f;  // shadow rays end this short of the surface that they test
constexpr std::size_t kMaxObjects = 254;

void AddMesh(RTCDevice device, RTCScene scene, const TriangleMesh& mesh, unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices.size()));
  auto* triangles = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    std::copy_n(mesh.vertices[i].data(), 3, vertices + 3 * i);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    std::copy_n(mesh.triangles[i].data(), 3, triangles + 3 * i);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

}  // namespace

struct RayCaster::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::vector<std::uint8_t>> albedo;  // by geometry and triangle

  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayCaster::RayCaster(const Scene& scene) : state_(std::make_unique<State>()) {
  if (scene.objects.size() > kMaxObjects)
    throw std::invalid_argument("scene: got " + std::to_string(scene.objects.size()) +
                                " objects, expected at most " + std::to_string(kMaxObjects));
  // One thread builds the tree: the same tree, and so the same answers, every time.
  state_->device = rtcNewDevice("threads=1");
  if (state_->device == nullptr) throw std::runtime_error("embree: got no device, expected one");
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  AddMesh(state_->device, state_->scene, scene.shell, 0);
  state_->albedo.push_back(scene.shell.albedo);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    AddMesh(state_->device, state_->scene, scene.objects[i].mesh, static_cast<unsigned>(i + 1));
    state_->albedo.push_back(scene.objects[i].mesh.albedo);
  }
  rtcCommitScene(state_->scene);
}

RayCaster::~RayCaster() = default;

IdealView RayCaster::Render(const CameraIntrinsics& intrinsics,
                            const Eigen::Isometry3d& T_world_camera,
                            const std::vector<float>& jitter_px,
                            const Eigen::Vector3d& projector) const {
  const int width = intrinsics.width;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(intrinsics.height);
  IdealView view;
  view.depth_m.assign(count, 0);
  view.cosine.assign(count, 0);
  view.albedo.assign(count, 0);
  view.label.assign(count, 0);
  view.lit.assign(count, 0);
  const Eigen::Matrix3f R_world_camera = T_world_camera.linear().cast<float>();
  const Eigen::Vector3f origin = T_world_camera.translation().cast<float>();
  const Eigen::Vector3f source = (T_world_camera * projector).cast<float>();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t first = 0; first < count; first += kPacket) {
    alignas(32) int valid[kPacket];
    alignas(32) RTCRayHit8 rays{};
    alignas(32) RTCRay8 shadow{};
    for (int k = 0; k < kPacket; ++k) {
      const std::size_t pixel = first + static_cast<std::size_t>(k);
      valid[k] = pixel < count ? -1 : 0;
      if (valid[k] == 0) continue;
      double u = static_cast<double>(pixel % static_cast<std::size_t>(width));
      double v = static_cast<double>(pixel / static_cast<std::size_t>(width));
      if (!jitter_px.empty()) {
        u += jitter_px[2 * pixel];
        v += jitter_px[2 * pixel + 1];
      }
      // Not normalised: the ray's parameter is the depth along the optical axis.
      const Eigen::Vector3f direction =
          R_world_camera * intrinsics.Deproject(u, v, 1).cast<float>();
      rays.ray.org_x[k] = origin.x();
      rays.ray.org_y[k] = origin.y();
      rays.ray.org_z[k] = origin.z();
      rays.ray.dir_x[k] = direction.x();
      rays.ray.dir_y[k] = direction.y();
      rays.ray.dir_z[k] = direction.z();
      rays.ray.tnear[k] = 0.05f;  // behind the lens
      rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
      rays.ray.mask[k] = ~0u;
      rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, state_->scene, &context, &rays);
    for (int k = 0; k < kPacket; ++k) {
      if (valid[k] == 0) continue;
      const unsigned geometry = rays.hit.geomID[k];
      if (geometry == RTC_INVALID_GEOMETRY_ID) {
        valid[k] = 0;
        continue;
      }
      const std::size_t pixel = first + static_cast<std::size_t>(k);
      const Eigen::Vector3f direction(rays.ray.dir_x[k], rays.ray.dir_y[k], rays.ray.dir_z[k]);
      const Eigen::Vector3f normal(rays.hit.Ng_x[k], rays.hit.Ng_y[k], rays.hit.Ng_z[k]);
      const Eigen::Vector3f point = origin + direction * rays.ray.tfar[k];
      view.depth_m[pixel] = rays.ray.tfar[k];
      view.cosine[pixel] =
          std::abs(direction.dot(normal)) / std::max(1e-12f, direction.norm() * normal.norm());
      view.albedo[pixel] = state_->albedo[geometry][rays.hit.primID[k]];
      view.label[pixel] = static_cast<std::uint8_t>(geometry);
      const Eigen::Vector3f from_source = point - source;
      shadow.org_x[k] = source.x();
      shadow.org_y[k] = source.y();
      shadow.org_z[k] = source.z();
      shadow.dir_x[k] = from_source.x();
      shadow.dir_y[k] = from_source.y();
      shadow.dir_z[k] = from_source.z();
      shadow.tnear[k] = 0;
      shadow.tfar[k] = kSelfMargin;
      shadow.mask[k] = ~0u;
    }
    rtcOccluded8(valid, state_->scene, &context, &shadow);
    for (int k = 0; k < kPacket; ++k)
      if (valid[k] != 0)
        view.lit[first + static_cast<std::size_t>(k)] = shadow.tfar[k] >= 0 ? 1 : 0;
  }
  return view;
}

}  // namespace fallen::sim
