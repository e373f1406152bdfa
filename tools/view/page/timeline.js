// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is known about every frame: time, probability, persons, place of the camera.

export class Timeline {
  constructor() { this.clear(); }

  clear() {
    this.oldest = 0;  // number of the first entry
    this.kept = 0;    // number of the first frame that can still be had
    this.entries = [];
  }

  get end() { return this.oldest + this.entries.length; }
  get last() { return this.entries.at(-1); }

  /// Takes the server's news; see Feed::TimelineSince.
  take({first, oldest, kept, entries}) {
    if (first !== this.end || oldest > this.end) {
      this.entries = [];
      this.oldest = first;
    }
    for (const [utime, probability, persons, ...camera] of entries) {
      this.entries.push({utime, probability, persons, camera: camera.length ? camera : null});
    }
    if (oldest > this.oldest) this.entries.splice(0, oldest - this.oldest);
    this.oldest = Math.max(oldest, this.oldest);
    this.kept = kept;
  }

  at(index) { return this.entries[index - this.oldest]; }

  /// Seconds of a frame since the first that is known.
  secondsOf(index) {
    const entry = this.at(index);
    return entry ? (entry.utime - this.entries[0].utime) * 1e-6 : 0;
  }

  get seconds() { return this.entries.length ? this.secondsOf(this.end - 1) : 0; }

  /// The last frame at or before `seconds`.
  indexAt(seconds) {
    let low = 0;
    let high = this.entries.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if ((this.entries[middle].utime - this.entries[0].utime) * 1e-6 <= seconds) low = middle;
      else high = middle - 1;
    }
    return this.oldest + low;
  }
}
