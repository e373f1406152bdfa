// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes around clusters, as bars along their edges, and labels that follow them.
import {
  BoxGeometry, Color, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3,
} from '../three/three.module.min.js';

import {element} from '../element.js';
import {themeColor} from '../palette.js';

const kMaxBoxes = 32;
const kEdges = 12;
const kThickness = {person: 0.014, candidate: 0.007, truth: 0.007};  // [m]
const kUp = new Vector3(0, 0, 1);

/// Middle and size of each edge of a box, in its own axes.
function edges(size, thickness) {
  const found = [];
  for (let axis = 0; axis < 3; ++axis) {
    const [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const [sb, sc] of [[-1, -1], [-1, 1], [1, -1], [1, 1]]) {
      const middle = [0, 0, 0];
      const extent = [thickness, thickness, thickness];
      middle[b] = (sb * size[b]) / 2;
      middle[c] = (sc * size[c]) / 2;
      extent[axis] = size[axis] + thickness;
      found.push({middle, extent});
    }
  }
  return found;
}

/// What there is to draw of a frame: its clusters, and the labelled person.
function boxesOf(frame) {
  const boxes = (frame.persons ?? []).map(({box, probability, is_person}) => ({
    ...box, kind: is_person ? 'person' : 'candidate',
    text: `${is_person ? 'fallen person  ' : ''}p ${probability.toFixed(2)}`,
  }));
  if (frame.truth && frame.frame === 'world') {
    boxes.push({...frame.truth, kind: 'truth', text: 'labelled'});
  }
  return boxes.slice(0, kMaxBoxes);
}

/// What was found has its label above its box; what is really there, at a corner on the floor.
function labelPlace([x, y, z], [length, width, height], yaw, kind) {
  if (kind !== 'truth') return new Vector3(x, y, z + height / 2 + 0.06);
  const corner = new Vector3(length / 2, width / 2, -height / 2).applyAxisAngle(kUp, yaw);
  return corner.add(new Vector3(x, y, z));
}

export class Boxes {
  /// @param labels  Element over the canvas that takes the labels.
  constructor(labels) {
    this.labels = labels;
    this.object = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial(), kMaxBoxes * kEdges);
    this.object.count = 0;
    this.object.frustumCulled = false;
    this.tags = [];
  }

  show(frame) {
    const boxes = boxesOf(frame);
    const colors = Object.fromEntries(
        ['person', 'candidate', 'truth'].map((kind) => [kind, new Color(themeColor(kind))]));
    let at = 0;
    for (const {center, size, yaw, kind} of boxes) {
      const turn = new Matrix4().compose(
          new Vector3(...center), new Quaternion().setFromAxisAngle(kUp, yaw), new Vector3(1, 1, 1));
      for (const {middle, extent} of edges(size, kThickness[kind])) {
        const edge = new Matrix4().makeTranslation(...middle).scale(new Vector3(...extent));
        this.object.setMatrixAt(at, edge.premultiply(turn));
        this.object.setColorAt(at, colors[kind]);
        ++at;
      }
    }
    this.object.count = at;
    this.object.instanceMatrix.needsUpdate = true;
    if (this.object.instanceColor) this.object.instanceColor.needsUpdate = true;
    this.tags = boxes.map(({center, size, yaw, kind, text}) => ({
      top: labelPlace(center, size, yaw, kind),
      tag: element('span', {class: `tag ${kind}`}, text),
    }));
    this.labels.replaceChildren(...this.tags.map(({tag}) => tag));
  }

  /// Puts the labels over their boxes, as `camera` sees them.
  placeLabels(camera, width, height) {
    const point = new Vector3();
    for (const {top, tag} of this.tags) {
      point.copy(top).applyMatrix4(this.object.matrixWorld).project(camera);
      tag.hidden = point.z > 1;
      tag.style.left = `${((point.x + 1) / 2) * width}px`;
      tag.style.top = `${((1 - point.y) / 2) * height}px`;
    }
  }
}
