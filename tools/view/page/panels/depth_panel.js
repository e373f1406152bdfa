// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The depth image, with the boxes as the camera would see them.
import {Matrix4, Vector3} from '../three/three.module.min.js';

import {byId} from '../element.js';
import {cssGradient, kRamps, kRanges, sampleRamp, themeColor} from '../palette.js';

const kNoDepth = [41, 41, 46];
const kClip = 0.1;  // nearer to the camera than this, a box is cut off [m]
const kEdges = [[0, 1], [1, 3], [3, 2], [2, 0], [4, 5], [5, 7], [7, 6], [6, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Colours of all depths in millimetres that 16 bits can hold, as a canvas takes them.
function depthColors() {
  const ramp = sampleRamp(kRamps.depth, 256);
  const [near, far] = kRanges.depth;
  const colors = new Uint32Array(65536);
  const pack = (r, g, b) => ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
  for (let mm = 0; mm < colors.length; ++mm) {
    const share = Math.min(Math.max((mm * 1e-3 - near) / (far - near), 0), 1);
    const i = 3 * Math.round(share * 255);
    colors[mm] = pack(ramp[i], ramp[i + 1], ramp[i + 2]);
  }
  colors[0] = pack(...kNoDepth);
  return colors;
}

function cornersOf({center, size, yaw}) {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return [...Array(8).keys()].map((i) => {
    const [x, y, z] = [0, 1, 2].map((axis) => (((i >> axis) & 1) - 0.5) * size[axis]);
    return new Vector3(center[0] + cos * x - sin * y, center[1] + sin * x + cos * y, center[2] + z);
  });
}

/// Cuts an edge (camera frame) where it passes behind the camera; null if it is all there.
function clipped(from, to) {
  if (from.z < kClip && to.z < kClip) return null;
  const cut = (a, b) => (a.z >= kClip ? a : a.clone().lerp(b, (kClip - a.z) / (b.z - a.z)));
  return [cut(from, to), cut(to, from)];
}

export class DepthPanel {
  constructor() {
    this.canvas = byId('depth');
    this.overlay = byId('depth-boxes');
    this.colors = depthColors();
    const scale = byId('depth-scale');
    scale.innerHTML = `<span>${kRanges.depth[0]} m</span><span class="ramp"></span><span>${kRanges.depth[1]} m</span>`;
    scale.querySelector('.ramp').style.background = cssGradient(kRamps.depth);
    this.overlay.addEventListener('pointermove', (event) => this.read(event));
    this.overlay.addEventListener('pointerleave', () => { byId('depth-reading').textContent = ''; });
  }

  show(frame) {
    this.frame = frame;
    const {width, height} = frame.depth ?? {width: 0, height: 0};
    byId('depth-card').hidden = width === 0;
    if (width === 0) return;
    if (this.canvas.width !== width || this.canvas.height !== height) {
      Object.assign(this.canvas, {width, height});
      this.image = new ImageData(width, height);
      this.canvas.parentElement.style.aspectRatio = `${width} / ${height}`;
    }
    const pixels = new Uint32Array(this.image.data.buffer);
    const {depth} = frame.arrays;
    for (let i = 0; i < pixels.length; ++i) pixels[i] = this.colors[depth[i]];
    this.canvas.getContext('2d').putImageData(this.image, 0, 0);
    this.drawBoxes(frame);
  }

  drawBoxes(frame) {
    const context = this.overlay.getContext('2d');
    const scale = 2;  // finer than the image: thin lines
    Object.assign(this.overlay, {width: scale * frame.depth.width, height: scale * frame.depth.height});
    if (!frame.T_map_camera) return;
    const T_camera_map = new Matrix4().set(...frame.T_map_camera, 0, 0, 0, 1).invert();
    const {width, fx, fy, cx, cy} = frame.intrinsics;
    const zoom = this.overlay.width / width;
    const project = ({x, y, z}) => [zoom * ((fx * x) / z + cx + 0.5), zoom * ((fy * y) / z + cy + 0.5)];
    const boxes = (frame.persons ?? []).map(({box, is_person}) => [box, is_person ? 'person' : 'candidate']);
    if (frame.truth && frame.frame === 'world') boxes.push([frame.truth, 'truth']);
    for (const [box, kind] of boxes.reverse()) {
      const corners = cornersOf(box).map((corner) => corner.applyMatrix4(T_camera_map));
      context.beginPath();
      for (const [a, b] of kEdges) {
        const edge = clipped(corners[a], corners[b]);
        if (!edge) continue;
        context.moveTo(...project(edge[0]));
        context.lineTo(...project(edge[1]));
      }
      context.strokeStyle = themeColor(kind);
      context.lineWidth = kind === 'person' ? 4 : 2;
      context.stroke();
    }
  }

  /// The depth under the pointer.
  read({offsetX, offsetY}) {
    if (!this.frame?.depth) return;
    const {width, height} = this.frame.depth;
    const x = Math.floor((offsetX / this.overlay.clientWidth) * width);
    const y = Math.floor((offsetY / this.overlay.clientHeight) * height);
    const mm = this.frame.arrays.depth[y * width + x];
    byId('depth-reading').textContent = mm ? `${(mm * 1e-3).toFixed(2)} m` : 'no measurement';
  }
}
