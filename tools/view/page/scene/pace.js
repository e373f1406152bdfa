// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// How fine the picture can be, by how long it takes: software rendering gets fewer pixels.

const kWindow = 8;    // pictures that are judged together
const kSlowMs = 45;   // coarser from here
const kHopelessMs = 400;  // coarser at once
const kFastMs = 20;   // finer from here

/// Steps from the finest to the coarsest: exact depth of each pixel, and pixels per CSS pixel.
function steps() {
  const full = Math.min(devicePixelRatio, 2);
  return [
    {isExact: true, ratio: full}, {isExact: false, ratio: full}, {isExact: false, ratio: Math.min(full, 1)},
    {isExact: false, ratio: Math.min(full, 0.75)}, {isExact: false, ratio: Math.min(full, 0.5)},
  ];
}

export class Pace {
  /// apply({isExact, ratio}) is called with each change, and at once.
  constructor(isSoftware, apply) {
    this.apply = apply;
    this.times = [];
    this.drawn = [];
    this.step = isSoftware ? 1 : 0;
    apply(steps()[this.step]);
  }

  /// A picture took so long, and was there at `now` [ms].
  add(milliseconds, now) {
    this.drawn.push(now);
    while (this.drawn[0] < now - 2000) this.drawn.shift();
    this.times.push(milliseconds);
    if (this.times.length < (milliseconds > kHopelessMs ? 2 : kWindow)) return;
    const median = this.times.sort((a, b) => a - b)[this.times.length >> 1];
    this.times = [];
    const wanted = median > kSlowMs ? this.step + 1 : median < kFastMs ? this.step - 1 : this.step;
    const next = Math.min(Math.max(wanted, 0), steps().length - 1);
    // What was too slow once is not tried again: no flicker between two steps.
    if (next === this.step || (next < this.step && next <= (this.tooFine ?? -1))) return;
    if (next > this.step) this.tooFine = this.step;
    this.step = next;
    this.apply(steps()[next]);
  }

  /// Pictures per second over the last two.
  framesPerSecond(now) { return this.drawn.filter((time) => time > now - 2000).length / 2; }
}
