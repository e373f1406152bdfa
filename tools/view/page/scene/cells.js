// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// All cells of a map as ellipsoids, in one mesh.
import {
  BufferAttribute, BufferGeometry, DataTexture, GLSL3, LinearFilter, Mesh, NearestFilter, RGBAFormat,
  RGBAIntegerFormat, ShaderMaterial, ShortType, Vector2, Vector3, Vector4,
} from '../three/three.module.min.js';

import {kClusterColors, kRamps, kRanges, sampleRamp} from '../palette.js';
import {fragmentShader, kCellsPerRow, kColorModes, vertexShader} from './cell_shader.js';

const kSigmas = 2;  // an ellipsoid then about fills its patch of the surface
const kRampWidth = 64;
const kNumbersPerRow = 12 * kCellsPerRow;
const kFirstRows = 32;

function colorTexture(bytes, filter) {
  const count = bytes.length / 3;
  const rgba = new Uint8Array(4 * count);
  for (let i = 0; i < count; ++i) {
    rgba.set(bytes.subarray(3 * i, 3 * i + 3), 4 * i);
    rgba[4 * i + 3] = 255;
  }
  const made = new DataTexture(rgba, count, 1, RGBAFormat);
  made.minFilter = made.magFilter = filter;
  made.needsUpdate = true;
  return made;
}

function cellTexture(rows) {
  const made = new DataTexture(new Int16Array(kNumbersPerRow * rows), 3 * kCellsPerRow, rows,
                               RGBAIntegerFormat, ShortType);
  made.internalFormat = 'RGBA16I';
  return made;
}

/// Two triangles for each of `count` quads, whose corners are numbered 4 k to 4 k + 3.
function quads(count) {
  const indices = new Uint32Array(6 * count);
  for (let k = 0; k < count; ++k) {
    indices.set([4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 2, 4 * k + 1, 4 * k + 3], 6 * k);
  }
  return new BufferAttribute(indices, 1);
}

function makeUniforms() {
  const clusters = sampleRamp(kClusterColors, kClusterColors.length);
  return {
    cells: {value: null},
    origin: {value: new Vector3()},
    placeStep: {value: 1},
    rootStep: {value: 1},
    sigmas: {value: kSigmas},
    mode: {value: 0},
    floorPlane: {value: new Vector4(0, 0, 1, 0)},
    range: {value: new Vector2(...kRanges.score)},
    ramp: {value: null},
    clusterColors: {value: colorTexture(clusters, NearestFilter)},
    plainColor: {value: new Vector3(0.5, 0.5, 0.5)},
    knownColor: {value: new Vector3(0.3, 0.35, 0.32)},
  };
}

export class Cells {
  constructor() {
    this.ramps = Object.fromEntries(['score', 'height', 'age'].map(
        (name) => [name, colorTexture(sampleRamp(kRamps[name], kRampWidth), LinearFilter)]));
    this.uniforms = makeUniforms();
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: this.uniforms,
      defines: {EXACT_DEPTH: ''},
    });
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.reserve(kFirstRows);
    this.clear();
    this.setMode('score');
  }

  /// Makes room for so many rows of cells; what was there is lost.
  reserve(rows) {
    this.rows = rows;
    this.uniforms.cells.value?.dispose();
    this.uniforms.cells.value = cellTexture(rows);
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setIndex(quads(rows * kCellsPerRow));
  }

  /// Shows the cells of a message.
  show({cells, arrays, ground}) {
    const rows = Math.ceil(cells.count / kCellsPerRow);
    if (rows > this.rows) this.reserve(Math.ceil(1.5 * rows));
    const texture = this.uniforms.cells.value;
    texture.image.data.set(arrays.texels);
    texture.needsUpdate = true;
    this.uniforms.origin.value.set(...cells.origin);
    this.uniforms.placeStep.value = cells.place_step_m;
    this.uniforms.rootStep.value = cells.root_step_m;
    if (ground?.status === 'ok') this.uniforms.floorPlane.value.set(...ground.normal, ground.offset);
    this.setCount(cells.count);
  }

  clear() { this.setCount(0); }

  setCount(count) {
    this.count = count;
    this.mesh.visible = count > 0;
    this.mesh.geometry.setDrawRange(0, 6 * count);
  }

  setMode(mode) {
    this.uniforms.mode.value = kColorModes.indexOf(mode);
    this.uniforms.ramp.value = this.ramps[mode] ?? this.ramps.score;
    this.uniforms.range.value.set(...(kRanges[mode] ?? kRanges.score));
  }

  /// Whether ellipsoids that touch cut each other where they do, or where their middles are.
  setExactDepth(isExact) {
    if (isExact === 'EXACT_DEPTH' in this.material.defines) return;
    if (isExact) this.material.defines.EXACT_DEPTH = '';
    else delete this.material.defines.EXACT_DEPTH;
    this.material.needsUpdate = true;
  }

  setThemeColors(plain, known) {
    this.uniforms.plainColor.value.setFromColor(plain);
    this.uniforms.knownColor.value.setFromColor(known);
  }
}
