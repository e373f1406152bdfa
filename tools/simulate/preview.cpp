// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/preview.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tools/simulate/random.hpp"

namespace fallen::sim {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kPersonColor = {255, 60, 60};

RgbImage MakeImage(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 20)};
}

void Set(RgbImage& image, int x, int y, const Rgb& color) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::copy(color.begin(), color.end(), image.pixels.begin() + 3 * (y * image.width + x));
}

// Near is warm, far is cold; black where nothing was measured.
Rgb DepthColor(double depth_m) {
  if (depth_m <= 0) return {0, 0, 0};
  const double t = std::clamp((depth_m - 0.5) / 4.5, 0.0, 1.0);
  const auto channel = [&](double peak) {
    return static_cast<std::uint8_t>(255 * std::clamp(1.5 - std::abs(4 * t - peak), 0.0, 1.0));
  };
  return {channel(1), channel(2), channel(3)};
}

Rgb LabelColor(std::uint8_t label, bool person) {
  if (person) return kPersonColor;
  const std::uint64_t hash = MixBits(label);
  return {static_cast<std::uint8_t>(60 + (hash & 127)),
          static_cast<std::uint8_t>(80 + ((hash >> 8) & 127)),
          static_cast<std::uint8_t>(100 + ((hash >> 16) & 127))};
}

RgbImage DrawDepth(const SensorImage& image) {
  RgbImage out = MakeImage(image.depth.intrinsics.width, image.depth.intrinsics.height);
  for (int y = 0, i = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x, ++i)
      Set(out, x, y,
          DepthColor(image.depth.depth[static_cast<std::size_t>(i)] * image.depth.depth_unit_m));
  return out;
}

RgbImage DrawLabels(const SensorImage& image, std::optional<std::size_t> person) {
  RgbImage out = MakeImage(image.depth.intrinsics.width, image.depth.intrinsics.height);
  for (int y = 0, i = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x, ++i) {
      const std::uint8_t label = image.labels[static_cast<std::size_t>(i)];
      const bool is_person = person && label == *person + 1;
      const auto depth = image.depth.depth[static_cast<std::size_t>(i)];
      const auto grey = static_cast<std::uint8_t>(depth == 0 ? 0 : 255 - std::min(230, depth / 22));
      Rgb color = {grey, grey, grey};
      if (label != 0) {
        const Rgb tint = LabelColor(label, is_person);
        for (std::size_t c = 0; c < 3; ++c)
          color[c] = static_cast<std::uint8_t>((color[c] + 2 * tint[c]) / 3 / (depth == 0 ? 2 : 1));
      }
      Set(out, x, y, color);
    }
  }
  return out;
}

}  // namespace

void Paste(const RgbImage& image, int x, int y, RgbImage& sheet) {
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const auto* pixel = image.pixels.data() + 3 * (row * image.width + column);
      Set(sheet, x + column, y + row, {pixel[0], pixel[1], pixel[2]});
    }
}

RgbImage DrawMesh(const Scene& scene, bool from_above, const Eigen::Vector2d& center,
                  double extent_m, int size_px) {
  // Points on the triangles, the nearest one to the viewer in each pixel, shaded by the surface's
  // slope.
  RgbImage out = MakeImage(size_px, size_px);
  std::vector<float> nearest(static_cast<std::size_t>(size_px * size_px), -1e9f);
  const double scale = size_px / extent_m;
  for (const SceneObject& object : scene.objects) {
    const bool person = object.category == kFallenPerson;
    const Rgb base =
        person ? Rgb{255, 150, 130}
               : LabelColor(static_cast<std::uint8_t>(&object - scene.objects.data()), false);
    for (const auto& triangle : object.mesh.triangles) {
      const Eigen::Vector3d a = object.mesh.vertices[triangle[0]].cast<double>();
      const Eigen::Vector3d ab = object.mesh.vertices[triangle[1]].cast<double>() - a;
      const Eigen::Vector3d ac = object.mesh.vertices[triangle[2]].cast<double>() - a;
      const Eigen::Vector3d normal = ab.cross(ac).normalized();
      const double facing = std::abs(from_above ? normal.z() : normal.y());
      const double light = 0.25 + 0.55 * facing + 0.2 * std::abs(normal.x());
      const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
      const int steps = std::max(1, static_cast<int>(std::ceil(longest * scale * 1.5)));
      for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
          const Eigen::Vector3d p = a + ab * i / steps + ac * j / steps;
          const int x = static_cast<int>((p.x() - center.x()) * scale + size_px / 2.0);
          const double up = from_above ? p.y() - center.y() : p.z() - extent_m / 2 + 0.05;
          const int y = static_cast<int>(size_px / 2.0 - up * scale);
          if (x < 0 || y < 0 || x >= size_px || y >= size_px) continue;
          const auto near = static_cast<float>(from_above ? p.z() : -p.y());
          float& seen = nearest[static_cast<std::size_t>(y * size_px + x)];
          if (near <= seen) continue;
          seen = near;
          Set(out, x, y,
              {static_cast<std::uint8_t>(base[0] * light),
               static_cast<std::uint8_t>(base[1] * light),
               static_cast<std::uint8_t>(base[2] * light)});
        }
      }
    }
  }
  return out;
}

RgbImage DrawPreview(const Simulation& simulation, int frames) {
  const int width = simulation.scenario().width, height = width * 3 / 4;
  RgbImage sheet = MakeImage(2 * width, (frames + 1) * height + width / 2);
  for (int i = 0; i < frames; ++i) {
    const int index = (simulation.scenario().frames - 1) * i / std::max(1, frames - 1);
    const Frame frame = simulation.TakeFrame(index);
    Paste(DrawDepth(frame.image), 0, i * height, sheet);
    Paste(DrawLabels(frame.image, simulation.person_index()), width, i * height, sheet);
  }
  const double extent = simulation.scene().room_size.maxCoeff();
  RgbImage plan = DrawMesh(simulation.scene(), true, {0, 0}, extent, width);
  for (int i = 0; i < simulation.scenario().frames; ++i) {
    // The drive as a line of dots from green to yellow.
    const Eigen::Isometry3d T = ToTransform(simulation.path()[static_cast<std::size_t>(i)]);
    const double scale = width / extent;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = T * Eigen::Vector3d(0.05 * k, 0, 0);
      Set(plan, static_cast<int>(p.x() * scale + width / 2.0),
          static_cast<int>(width / 2.0 - p.y() * scale),
          {static_cast<std::uint8_t>(255 * i / simulation.scenario().frames), 255, 60});
    }
  }
  Paste(plan, 0, frames * height, sheet);
  if (simulation.person_index()) {
    const OrientedBox& box = simulation.scene().objects[*simulation.person_index()].box;
    Paste(DrawMesh(simulation.scene(), true, box.center.head<2>(), 2.4, width), width,
          frames * height, sheet);
  }
  return sheet;
}

void WritePng(const std::filesystem::path& path, const RgbImage& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png, path.c_str(), 0, image.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(path.string() + ": got '" + png.message +
                             "', expected to write a PNG");
}

}  // namespace fallen::sim
