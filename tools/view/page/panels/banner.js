// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// What must not be missed: somebody lies there.
import {byId, element} from '../element.js';

/// The persons of the frame that is shown.
export function showBanner(frame) {
  const banner = byId('banner');
  const persons = (frame.persons ?? []).filter(({is_person}) => is_person);
  banner.hidden = persons.length === 0;
  if (banner.hidden) return;
  const [best] = persons;
  const [x, y] = best.centroid;
  const where = frame.frame === 'world' ? `at (${x.toFixed(1)}, ${y.toFixed(1)}) m in the world` : 'in view';
  const title = persons.length === 1 ? 'Fallen person' : `${persons.length} fallen persons`;
  const text = `${where} · p ${best.probability.toFixed(2)} · ${best.cells} cells`;
  if (banner.dataset.title !== title) {
    banner.dataset.title = title;
    banner.replaceChildren(element('span', {class: 'pulse'}), element('strong', {}, title), element('span', {}));
  }
  banner.lastChild.textContent = text;
}
