// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// From where the map is looked at: orbits by hand, and moves along with the robot.
import {PerspectiveCamera, Vector3} from '../three/three.module.min.js';
import {OrbitControls} from '../three/OrbitControls.js';

const kBehind = 1.7;   // default place, from the camera [m]
const kAbove = 1.3;
const kAside = 0.9;
const kAhead = 2.0;    // what is in the middle

export class Viewpoint {
  constructor(canvas, onChange) {
    this.camera = new PerspectiveCamera(45, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.15;
    this.controls.maxDistance = 30;
    this.controls.minDistance = 0.3;
    this.controls.addEventListener('change', onChange);
    this.follows = true;
    this.place = null;  // of the robot's camera, in the scene
  }

  /// Tells where the robot's camera is now: `place`, and `forward` along the floor, unit length.
  update(place, forward) {
    const isFirst = !this.place;
    if (!isFirst && this.follows) {
      const moved = place.clone().sub(this.place);
      this.camera.position.add(moved);
      this.controls.target.add(moved);
    }
    this.place = place.clone();
    this.forward = forward.clone();
    if (isFirst) this.reset();
  }

  /// Behind and above the robot's camera, looking where it looks.
  reset() {
    if (!this.place) return;
    const floor = new Vector3(this.place.x, this.place.y, 0);
    const left = new Vector3(-this.forward.y, this.forward.x, 0);
    this.camera.position.copy(floor).addScaledVector(this.forward, -kBehind).addScaledVector(left, kAside);
    this.camera.position.z = this.place.z + kAbove;
    this.controls.target.copy(floor).addScaledVector(this.forward, kAhead);
    this.controls.target.z = 0.2;
    this.controls.update();
  }

  /// Straight down, what is ahead above.
  fromAbove() {
    if (!this.place) return;
    this.controls.target.set(this.place.x, this.place.y, 0).addScaledVector(this.forward, kAhead);
    this.camera.position.copy(this.controls.target).addScaledVector(this.forward, -0.02);
    this.camera.position.z = 7;
    this.controls.update();
  }

  /// Through the robot's camera.
  throughCamera() {
    if (!this.place) return;
    this.camera.position.copy(this.place);
    this.controls.target.copy(this.place).addScaledVector(this.forward, kAhead);
    this.controls.target.z = 0;
    this.controls.update();
  }

  resize(width, height) {
    this.camera.aspect = width / Math.max(height, 1);
    // The room's width stays in view where the window is narrow.
    this.camera.fov = this.camera.aspect < 1 ? 58 : 45;
    this.camera.updateProjectionMatrix();
  }
}
