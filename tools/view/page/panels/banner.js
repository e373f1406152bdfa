// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// What must not be missed: somebody lies there.
import {byId, element} from '../element.js';

function placeText([x, y], frame) {
  return frame === 'world' ? `at (${x.toFixed(1)}, ${y.toFixed(1)}) m in the world` : 'in view';
}

/// An alarm says more than a frame: it rests on many.
function messageOf(frame, alarms) {
  if (alarms.length > 0) {
    const [{alarm, state}] = alarms;
    const title = alarms.length === 1 ? 'Alarm: fallen person' : `${alarms.length} alarms: fallen persons`;
    return [title, `${placeText(alarm.position, alarm.frame)} · p ${alarm.probability.toFixed(3)} from ` +
        `${alarm.frames} frames${state === 'acknowledged' ? ' · acknowledged' : ''}`];
  }
  const persons = (frame.persons ?? []).filter(({is_person}) => is_person);
  if (persons.length === 0) return null;
  const [best] = persons;
  const title = persons.length === 1 ? 'Fallen person' : `${persons.length} fallen persons`;
  return [title, `${placeText(best.centroid, frame.frame)} · p ${best.probability.toFixed(2)} · ${best.cells} cells`];
}

/// @param alarms  Active at the time of the frame, as showAlarms returns them.
export function showBanner(frame, alarms) {
  const banner = byId('banner');
  const message = messageOf(frame, alarms);
  banner.hidden = !message;
  if (!message) return;
  const [title, text] = message;
  if (banner.dataset.title !== title) {
    banner.dataset.title = title;
    banner.replaceChildren(element('span', {class: 'pulse'}), element('strong', {}, title), element('span', {}));
  }
  banner.lastChild.textContent = text;
}
