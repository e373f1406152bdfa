// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The clusters of a frame, best first, and what was thought of each.
import {byId, element} from '../element.js';

/// How far a place is from the camera along the floor [m].
function distance(frame, [x, y, z]) {
  const T = frame.T_map_camera;
  if (!T) return null;
  const isUpright = frame.frame !== 'camera';
  const [dx, dy, dz] = [x - T[3], y - T[7], z - T[11]];
  return isUpright ? Math.hypot(dx, dy) : Math.hypot(dx, dz);
}

function item(frame, person, number) {
  const made = element('li', person.is_person ? {class: 'is-person'} : {});
  const away = distance(frame, person.centroid);
  const place = person.centroid.map((value) => value.toFixed(2)).join(', ');
  const bar = element('div', {class: 'bar-line'}, element('i'), element('b'));
  bar.firstChild.style.width = `${100 * person.probability}%`;
  bar.lastChild.style.left = `${100 * frame.min_probability}%`;
  made.append(
      element('span', {class: 'what'}, person.is_person ? 'Fallen person' : `Cluster ${number}`),
      element('span', {class: 'p'}, `p ${person.probability.toFixed(3)}`), bar,
      element('span', {class: 'more'},
              `${away === null ? '' : `${away.toFixed(1)} m away · `}(${place}) · ${person.cells} cells`));
  return made;
}

export function showPersons(frame) {
  const persons = frame.persons;
  const summary = byId('persons-summary');
  const list = byId('persons');
  if (!persons) {
    summary.textContent = 'no decision';
    list.replaceChildren(element('li', {class: 'none'}, 'No decision about this frame.'));
    return;
  }
  summary.textContent = `threshold ${frame.min_probability.toFixed(3)}`;
  const items = persons.map((person, i) => item(frame, person, i + 1));
  list.replaceChildren(...(items.length ? items
                                        : [element('li', {class: 'none'}, 'Nothing like a person in view.')]));
}
