// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which frame is looked at: the newest of a live feed, or a place in time that runs or stands.

export const kSpeeds = [1, 2, 4, 0.25, 0.5];

export class Player {
  /// ask(what): asks the server for a frame. onChange(): something here has changed.
  constructor(timeline, ask, onChange) {
    this.timeline = timeline;
    this.ask = ask;
    this.onChange = onChange;
    this.isLiveFeed = false;
    this.followsNewest = false;
    this.isPlaying = false;
    this.speed = 1;
    this.shown = -1;       // number of the frame on the screen
    this.seconds = 0;      // the playhead
    this.isWaiting = false;
    this.wanted = null;    // asked for while waiting
    this.resumeAt = null;  // a frame to go back to once the server has it
  }

  /// A connection has begun: what the server has may be something else now.
  begin(isLiveFeed) {
    const isFirst = this.shown < 0 || isLiveFeed !== this.isLiveFeed;
    this.isLiveFeed = isLiveFeed;
    this.isWaiting = false;
    if (isLiveFeed && (isFirst || this.followsNewest)) return this.goLive();
    if (isFirst) {
      this.isPlaying = true;
      this.seconds = 0;
      return this.request(0);
    }
    this.resumeAt = this.shown;
    this.timelineGrew();
  }

  /// After a restart the server may have to read its recording again: back to the place when it is there.
  timelineGrew() {
    if (this.resumeAt === null || this.resumeAt >= this.timeline.end) return;
    const place = this.resumeAt;
    this.resumeAt = null;
    this.request(place);
  }

  request(what) {
    if (this.isWaiting && this.wanting !== 'newest') {
      this.wanted = what;
      return;
    }
    this.isWaiting = true;
    this.wanting = what;
    this.ask(what);
  }

  arrived(index) {
    this.shown = index;
    this.isWaiting = false;
    if (this.followsNewest) {
      this.seconds = this.timeline.secondsOf(index);
      this.request('newest');
    } else if (this.wanted !== null) {
      const wanted = this.wanted;
      this.wanted = null;
      if (wanted !== index) this.request(wanted);
    }
    this.onChange();
  }

  /// Moves the playhead by `elapsed` seconds of the clock.
  tick(elapsed) {
    if (!this.isPlaying || this.timeline.entries.length === 0) return;
    const end = this.timeline.seconds;
    this.seconds = Math.min(this.seconds + elapsed * this.speed, end);
    const index = this.timeline.indexAt(this.seconds);
    if (index !== this.shown && index !== this.wanting) this.request(index);
    if (this.seconds >= end && !this.isGrowing) {
      this.isPlaying = false;
      this.onChange();
    }
  }

  goLive() {
    if (!this.isLiveFeed) return;
    this.followsNewest = true;
    this.isPlaying = false;
    this.wanted = null;
    this.request('newest');
    this.onChange();
  }

  seek(index) {
    this.resumeAt = null;
    if (this.timeline.entries.length === 0) return;
    const first = Math.max(this.timeline.kept, this.timeline.oldest);
    const place = Math.min(Math.max(index, first), this.timeline.end - 1);
    this.followsNewest = false;
    this.seconds = this.timeline.secondsOf(place);
    this.request(place);
    this.onChange();
  }

  step(frames) {
    this.isPlaying = false;
    this.seek(this.shown + frames);
  }

  togglePlaying() {
    if (this.followsNewest) {
      this.followsNewest = false;
    } else if (this.isPlaying) {
      this.isPlaying = false;
    } else {
      if (this.seconds >= this.timeline.seconds) this.seek(this.timeline.kept);
      this.isPlaying = true;
    }
    this.onChange();
  }

  nextSpeed() {
    this.speed = kSpeeds[(kSpeeds.indexOf(this.speed) + 1) % kSpeeds.length];
    this.onChange();
  }
}
