// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// What stands for what: the same ramps as in the pictures (tools/view/picture/colors.cpp).

const kViridis = ['#440154', '#472d7b', '#3b528b', '#2c728e', '#21918c', '#28ae80', '#5ec962',
                  '#addc30', '#fde725'];

export const kRamps = {
  score: ['#6888b8', '#9eb2cd', '#d0d0d0', '#ee8060', '#c4142c'],
  depth: [...kViridis].reverse(),
  height: kViridis,
  age: ['#ffd166', '#ef8354', '#a44a7d', '#4f3f84', '#27345c'],
};

/// Clusters, told apart by colour; the eighth looks like the first.
export const kClusterColors = ['#e6194b', '#4363d8', '#f58231', '#3cb44b', '#911eb4', '#46b8c8',
                               '#bfa500', '#f032a6'];

/// Ends of the ramps: scores beyond, either way, all look the same.
export const kRanges = {score: [-0.25, 0.25], height: [0, 1.5], age: [0, 5], depth: [0.5, 5]};

export function cssGradient(colors) { return `linear-gradient(90deg, ${colors.join(', ')})`; }

function channels(color) {
  return [1, 3, 5].map((start) => parseInt(color.slice(start, start + 2), 16));
}

/// `count` colours along a ramp, as r g b bytes.
export function sampleRamp(colors, count) {
  const stops = colors.map(channels);
  const bytes = new Uint8Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const place = (i / (count - 1)) * (stops.length - 1);
    const below = Math.min(Math.floor(place), stops.length - 2);
    for (let c = 0; c < 3; ++c) {
      bytes[3 * i + c] = stops[below][c] + (place - below) * (stops[below + 1][c] - stops[below][c]);
    }
  }
  return bytes;
}

/// A colour of the theme in force, by its name in theme.css.
export function themeColor(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
