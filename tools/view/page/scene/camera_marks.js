// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where the camera is and looks, and the path it took.
import {
  BufferGeometry, Color, Float32BufferAttribute, Group, Line, LineBasicMaterial, LineSegments,
} from '../three/three.module.min.js';

import {themeColor} from '../palette.js';

const kFrustumDepth = 0.35;  // [m]
const kReach = 4;            // how far the faint lines of the view go [m]

/// Corners of the image at a depth, camera frame.
function imageCorners({width, height, fx, fy, cx, cy}, z) {
  return [[0, 0], [width, 0], [width, height], [0, height]].map(
      ([u, v]) => [((u - 0.5 - cx) * z) / fx, ((v - 0.5 - cy) * z) / fy, z]);
}

function frustum(intrinsics) {
  const near = imageCorners(intrinsics, kFrustumDepth);
  const points = [];
  near.forEach((corner, i) => points.push([0, 0, 0], corner, corner, near[(i + 1) % 4]));
  // A roof over the image tells up from down.
  const [left, right] = near;
  const ridge = [(left[0] + right[0]) / 2, left[1] - 0.35 * (near[3][1] - left[1]), kFrustumDepth];
  points.push(left, ridge, ridge, right);
  return points;
}

function setPoints(object, points) {
  object.geometry.dispose();
  object.geometry = new BufferGeometry();
  object.geometry.setAttribute('position', new Float32BufferAttribute(points.flat(), 3));
}

export class CameraMarks {
  constructor() {
    this.bright = new LineBasicMaterial();
    this.faint = new LineBasicMaterial({transparent: true, opacity: 0.3});
    this.ahead = new LineBasicMaterial({transparent: true, opacity: 0.35});
    this.frustum = new LineSegments(new BufferGeometry(), this.bright);
    this.rays = new LineSegments(new BufferGeometry(), this.faint);
    this.camera = new Group();  // camera frame
    this.camera.matrixAutoUpdate = false;
    this.camera.add(this.frustum, this.rays);
    this.past = new Line(new BufferGeometry(), this.bright);
    this.future = new Line(new BufferGeometry(), this.ahead);
    for (const line of [this.past, this.future, this.frustum, this.rays]) line.frustumCulled = false;
    this.object = new Group();
    this.object.add(this.camera, this.past, this.future);
  }

  /// @param T_map_camera  Matrix4.
  show(T_map_camera, intrinsics) {
    this.camera.matrix.copy(T_map_camera);
    this.camera.matrixWorldNeedsUpdate = true;
    const shape = JSON.stringify(intrinsics ?? null);
    this.camera.visible = Boolean(intrinsics);
    if (!intrinsics || shape === this.shape) return;
    this.shape = shape;
    setPoints(this.frustum, frustum(intrinsics));
    const far = imageCorners(intrinsics, kReach);
    setPoints(this.rays, far.flatMap((corner) => [[0, 0, 0], corner]));
  }

  /// The path up to frame `index`, and what follows of it.
  showPath(timeline, index) {
    const place = index - timeline.oldest;
    const cameras = timeline.entries.map((entry) => entry.camera);
    setPoints(this.past, cameras.slice(0, place + 1).filter(Boolean));
    setPoints(this.future, cameras.slice(Math.max(place, 0)).filter(Boolean));
  }

  setThemeColors() {
    const color = new Color(themeColor('accent'));
    for (const material of [this.bright, this.faint, this.ahead]) material.color = color;
  }
}
