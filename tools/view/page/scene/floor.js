// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Metre lines on the floor around the camera, that fade with the distance.
import {
  BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, Quaternion, Vector3,
} from '../three/three.module.min.js';

import {themeColor} from '../palette.js';

const kReach = 9;  // [m]

function lines() {
  const positions = [];
  const alphas = [];
  const add = (x, y) => {
    positions.push(x, y, 0);
    alphas.push(1, 1, 1, Math.max(0, 1 - Math.hypot(x, y) / kReach));
  };
  for (let across = -kReach; across <= kReach; ++across) {
    for (let along = -kReach; along < kReach; ++along) {
      add(across, along), add(across, along + 1);
      add(along, across), add(along + 1, across);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('color', new Float32BufferAttribute(alphas, 4));
  return geometry;
}

export class Floor {
  constructor() {
    this.material = new LineBasicMaterial({vertexColors: true, transparent: true, depthWrite: false});
    this.object = new LineSegments(lines(), this.material);
    this.object.visible = false;
    this.wanted = true;
  }

  /// Below the camera, at whole metres so that the lines stand still while the robot moves.
  show(ground, camera) {
    this.known = ground?.status === 'ok';
    this.object.visible = this.known && this.wanted;
    if (!this.known) return;
    const normal = new Vector3(...ground.normal);
    const height = normal.dot(camera) + ground.offset;
    const foot = camera.clone().addScaledVector(normal, -height);
    this.object.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal));
    this.object.position.set(Math.round(foot.x), Math.round(foot.y), foot.z);
  }

  toggle() {
    this.wanted = !this.wanted;
    this.object.visible = Boolean(this.known && this.wanted);
    return this.wanted;
  }

  setThemeColors() { this.material.color = new Color(themeColor('grid')); }
}
