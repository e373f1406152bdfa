// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The map in three dimensions: everything that is drawn, and when.
import {
  AmbientLight, Color, Group, Matrix4, Scene, Vector3, WebGLRenderer,
} from '../three/three.module.min.js';

import {themeColor} from '../palette.js';
import {Boxes} from './boxes.js';
import {CameraMarks} from './camera_marks.js';
import {Cells} from './cells.js';
import {Floor} from './floor.js';
import {Pace} from './pace.js';
import {Viewpoint} from './viewpoint.js';

/// Without a floor the map is in the camera's frame: turned so that its up is ours.
const kUprightCamera = new Matrix4().set(0, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 1);

/// Without a graphics card, smooth edges by four samples a pixel cost more than all else.
function rendersInSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}

export class World {
  constructor(canvas, labels) {
    this.canvas = canvas;
    const isSoftware = rendersInSoftware();
    this.renderer = new WebGLRenderer({canvas, antialias: !isSoftware, alpha: true});
    this.cells = new Cells();
    this.environment = new Cells();
    this.floor = new Floor();
    this.marks = new CameraMarks();
    this.boxes = new Boxes(labels);
    this.content = new Group();
    this.content.matrixAutoUpdate = false;
    this.content.add(this.environment.mesh, this.cells.mesh, this.floor.object, this.marks.object,
                     this.boxes.object);
    this.scene = new Scene();
    this.scene.add(this.content, new AmbientLight(0xffffff, 1));
    this.viewpoint = new Viewpoint(canvas, () => this.invalidate());
    this.pace = new Pace(isSoftware, ({isExact, ratio}) => {
      for (const cells of [this.cells, this.environment]) cells.setExactDepth(isExact);
      this.renderer.setPixelRatio(ratio);
      this.invalidate();
    });
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    this.size = {width, height};
    this.renderer.setSize(width, height, false);
    this.viewpoint.resize(width, height);
    this.invalidate();
  }

  invalidate() { this.isDirty = true; }

  showFrame(frame) {
    if (frame.cells) this.cells.show(frame);
    else this.cells.clear();
    const isUpright = frame.frame !== 'camera';
    this.content.matrix.copy(isUpright ? new Matrix4() : kUprightCamera);
    this.content.updateMatrixWorld(true);
    this.environment.mesh.visible = frame.frame === 'world' && this.environment.count > 0 &&
        !this.hidesEnvironment;
    this.hasMap = Boolean(frame.T_map_camera);
    if (this.hasMap) this.showCamera(frame);
    this.boxes.show(frame);
    this.invalidate();
  }

  showCamera(frame) {
    const T_map_camera = new Matrix4().set(...frame.T_map_camera, 0, 0, 0, 1);
    this.marks.show(T_map_camera, frame.intrinsics);
    this.marks.past.visible = this.marks.future.visible = frame.frame === 'world';
    this.floor.show(frame.ground, new Vector3().setFromMatrixPosition(T_map_camera));
    const T_scene_camera = T_map_camera.clone().premultiply(this.content.matrix);
    const place = new Vector3().setFromMatrixPosition(T_scene_camera);
    const forward = new Vector3(0, 0, 1).transformDirection(T_scene_camera).setZ(0);
    if (forward.length() < 0.1) forward.set(0, -1, 0).transformDirection(T_scene_camera).setZ(0);
    this.viewpoint.update(place, forward.normalize());
  }

  showEnvironment(environment) {
    this.environment.show(environment);
    this.invalidate();
  }

  toggleEnvironment() {
    this.hidesEnvironment = !this.hidesEnvironment;
    this.environment.mesh.visible = this.environment.count > 0 && !this.hidesEnvironment;
    this.invalidate();
  }

  setColorMode(mode) {
    this.cells.setMode(mode);
    this.invalidate();
  }

  setThemeColors() {
    const [plain, known] = ['plain-cell', 'known-cell'].map((name) => new Color(themeColor(name)));
    for (const color of [plain, known]) color.convertLinearToSRGB();
    this.cells.setThemeColors(plain, known);
    this.environment.setThemeColors(known, known);
    this.floor.setThemeColors();
    this.marks.setThemeColors();
    this.invalidate();
  }

  /// Draws if anything has changed since the last time; called for every picture of the browser.
  /// @param now  [ms]
  draw(now) {
    // The call to draw returns before the picture is there: how long it takes shows in how late the
    // browser asks for the next.
    if (this.hasDrawn) this.pace.add(now - this.asked, now);
    this.asked = now;
    this.viewpoint.controls.update();
    this.hasDrawn = this.isDirty;
    if (!this.isDirty) return;
    this.isDirty = false;
    this.renderer.render(this.scene, this.viewpoint.camera);
    this.boxes.placeLabels(this.viewpoint.camera, this.size.width, this.size.height);
  }
}
