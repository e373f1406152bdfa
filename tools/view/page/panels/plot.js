// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// p(fallen) over time, and the playhead to drag.
import {byId} from '../element.js';
import {themeColor} from '../palette.js';

const kMargin = {left: 34, right: 10, top: 8, bottom: 20};
const kLiveWindow = 120;  // of a live feed [s]
const kPeriodMs = 60;    // least time between two drawings
const kDotStep = 4;      // of the dots where a person was found, at least [px]
const kTickSteps = [0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600, 7200];

export function clockText(seconds) {
  const whole = Math.floor(seconds / 60);
  const rest = (seconds - 60 * whole).toFixed(1).padStart(4, '0');
  return `${whole}:${rest}`;
}

export class Plot {
  constructor(timeline, player) {
    this.timeline = timeline;
    this.player = player;
    this.box = byId('plot');
    this.canvas = byId('plot-canvas');
    // Without a graphics card, lines and dots are drawn several times faster by the processor itself.
    this.context = this.canvas.getContext('2d', {willReadFrequently: true});
    this.threshold = null;
    this.isDirty = true;
    this.drawn = -Infinity;
    new ResizeObserver(() => this.invalidate()).observe(this.box);
    this.box.addEventListener('pointerdown', (event) => {
      this.box.setPointerCapture(event.pointerId);
      this.player.isPlaying = false;
      this.seekTo(event.offsetX);
    });
    this.box.addEventListener('pointermove', (event) => {
      if (event.buttons) this.seekTo(event.offsetX);
    });
  }

  /// Seconds at the left and the right end.
  get range() {
    const end = Math.max(this.timeline.seconds, 1);
    return this.player.isLiveFeed ? [Math.max(0, end - kLiveWindow), Math.max(end, 10)] : [0, end];
  }

  get inner() {
    const {clientWidth, clientHeight} = this.box;
    return {left: kMargin.left, top: kMargin.top, width: clientWidth - kMargin.left - kMargin.right,
            height: clientHeight - kMargin.top - kMargin.bottom};
  }

  seekTo(offsetX) {
    const [from, to] = this.range;
    const {left, width} = this.inner;
    const share = Math.min(Math.max((offsetX - left) / width, 0), 1);
    this.player.seek(this.timeline.indexAt(from + share * (to - from)));
  }

  invalidate() { this.isDirty = true; }

  /// Draws if anything has changed since the last time; called for every picture of the browser.
  /// @param now  [ms]
  draw(now) {
    if (!this.isDirty || now - this.drawn < kPeriodMs) return;
    this.isDirty = false;
    this.drawn = now;
    const ratio = Math.min(devicePixelRatio, 2);
    const {clientWidth, clientHeight} = this.box;
    Object.assign(this.canvas, {width: clientWidth * ratio, height: clientHeight * ratio});
    const {context} = this;
    context.scale(ratio, ratio);
    const {left, top, width, height} = this.inner;
    const [from, to] = this.range;
    const x = (seconds) => left + ((seconds - from) / (to - from)) * width;
    const y = (p) => top + (1 - p) * height;
    this.drawAxes(context, x, y, from, to);
    context.save();
    context.beginPath();
    context.rect(left, 0, width, clientHeight);
    context.clip();
    this.drawCurve(context, x, y, from);
    context.restore();
    this.drawPlayhead(context, x);
    this.tellScreenReaders();
  }

  drawAxes(context, x, y, from, to) {
    const {left, top, width, height} = this.inner;
    context.font = '11px ' + getComputedStyle(document.body).fontFamily;
    context.fillStyle = themeColor('faint');
    context.strokeStyle = themeColor('line');
    context.lineWidth = 1;
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const p of [0, 0.5, 1]) {
      context.strokeRect(left, Math.round(y(p)) + 0.5, width, 0);
      context.fillText(p === 0.5 ? 'p ½' : `p ${p}`, left - 7, y(p));
    }
    context.textAlign = 'center';
    context.textBaseline = 'alphabetic';
    const step = kTickSteps.find((wanted) => ((to - from) / wanted) * 64 < width) ?? kTickSteps.at(-1);
    for (let tick = Math.ceil(from / step) * step; tick <= to; tick += step) {
      const text = step < 1 ? tick.toFixed(1) : clockText(tick).replace(/\.0$/, '');
      context.fillText(text, Math.min(Math.max(x(tick), left + 10), left + width - 10), top + height + 15);
    }
    if (this.threshold === null) return;
    context.setLineDash([4, 4]);
    context.strokeStyle = themeColor('person');
    context.strokeRect(left, y(this.threshold), width, 0);
    context.setLineDash([]);
  }

  drawCurve(context, x, y, from) {
    const {top, height} = this.inner;
    const {entries} = this.timeline;
    const start = Math.max(this.timeline.indexAt(from) - this.timeline.oldest, 0);
    const person = themeColor('person');
    const points = [];
    for (let i = start; i < entries.length; ++i) {
      const at = x((entries[i].utime - entries[0].utime) * 1e-6);
      points.push([at, entries[i].probability, entries[i].persons]);
    }
    // Where a person was found: a wash over the full height.
    context.fillStyle = person;
    context.globalAlpha = 0.16;
    let begin = null;  // of the wash
    points.forEach(([at, , persons], i) => {
      if (persons === 0) return;
      begin ??= at;
      const next = points[i + 1];
      if (next && next[2] > 0) return;
      context.fillRect(begin, top, Math.max((next?.[0] ?? at + 2) - begin, 1) + 0.3, height);
      begin = null;
    });
    context.globalAlpha = 1;
    context.beginPath();
    let isDown = false;
    for (const [at, p] of points) {
      if (p === null) isDown = false;
      else if (isDown) context.lineTo(at, y(p));
      else context.moveTo(at, y(p)), isDown = true;
    }
    context.strokeStyle = themeColor('accent');
    context.lineWidth = 1.8;
    context.lineJoin = 'round';
    context.stroke();
    context.fillStyle = person;
    context.beginPath();
    let last = -Infinity;
    for (const [at, p, persons] of points) {
      if (persons === 0 || at - last < kDotStep) continue;
      last = at;
      context.moveTo(at, y(p));
      context.arc(at, y(p), 2.6, 0, 7);
    }
    context.fill();
  }

  drawPlayhead(context, x) {
    if (this.player.shown < 0 || this.timeline.entries.length === 0) return;
    const {top, height} = this.inner;
    const at = Math.round(x(this.timeline.secondsOf(this.player.shown)));
    context.fillStyle = themeColor('ink');
    context.fillRect(at - 0.75, top - 4, 1.5, height + 8);
    context.beginPath();
    context.arc(at, top - 3, 4.5, 0, 7);
    context.fill();
  }

  tellScreenReaders() {
    const seconds = this.timeline.secondsOf(this.player.shown);
    this.box.setAttribute('aria-valuemax', this.timeline.seconds.toFixed(1));
    this.box.setAttribute('aria-valuenow', seconds.toFixed(1));
    this.box.setAttribute('aria-valuetext', `${seconds.toFixed(1)} seconds`);
  }
}
