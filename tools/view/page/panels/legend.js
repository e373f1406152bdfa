// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Buttons for what the cells' colours mean, and the legend of the one chosen.
import {byId, element} from '../element.js';
import {cssGradient, kClusterColors, kRamps} from '../palette.js';
import {kColorModes} from '../scene/cell_shader.js';

const kTitles = {score: 'Score', cluster: 'Cluster', height: 'Height', age: 'Age'};
const kLegends = {
  score: ['not a person', 'person'], height: ['floor', '1.5 m'], age: ['seen now', '5 s ago'],
};

function ramp(mode) {
  const [low, high] = kLegends[mode];
  const bar = element('span', {class: 'ramp'});
  bar.style.background = cssGradient(kRamps[mode]);
  return [element('span', {}, low), bar, element('span', {}, high)];
}

function swatch(color, text) {
  const dot = element('span', {class: 'swatch'});
  dot.style.background = color;
  return element('span', {}, dot, text);
}

function legendOf(mode) {
  if (mode !== 'cluster') return ramp(mode);
  return [...kClusterColors.slice(0, 3).map((color, i) => swatch(color, `${i + 1}`)),
          swatch('var(--plain-cell)', 'in none')];
}

/// onChoice(mode) is called with each choice. Returns a function that chooses.
export function makeColorChoice(onChoice) {
  const buttons = kColorModes.map((mode, i) => {
    const button = element('button', {role: 'radio', title: `Colour by ${mode} (${i + 1})`}, kTitles[mode]);
    button.addEventListener('click', () => choose(mode));
    return button;
  });
  byId('color-modes').append(...buttons);
  function choose(mode) {
    buttons.forEach((button, i) => button.setAttribute('aria-checked', String(kColorModes[i] === mode)));
    byId('legend').replaceChildren(...legendOf(mode));
    onChoice(mode);
  }
  return choose;
}
