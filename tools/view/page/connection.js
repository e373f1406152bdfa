// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The WebSocket, opened again whenever it is lost.
import {decodeMessage} from './message.js';

const kFirstRetryMs = 250;
const kLongestRetryMs = 4000;

export class Connection {
  /// handlers: onState('open' | 'lost'), onTopic(name, value), onTimeline(message), onFrame(frame),
  /// onEnvironment(environment).
  constructor(handlers) {
    this.handlers = handlers;
    this.retryMs = kFirstRetryMs;
    this.open();
  }

  open() {
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    this.socket = new WebSocket(`${scheme}://${location.host}/feed${location.search}`);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => {
      this.retryMs = kFirstRetryMs;
      this.handlers.onState('open');
    };
    this.socket.onmessage = ({data}) => this.take(data);
    this.socket.onclose = () => {
      this.handlers.onState('lost');
      setTimeout(() => this.open(), this.retryMs);
      this.retryMs = Math.min(2 * this.retryMs, kLongestRetryMs);
    };
  }

  /// Asks for a frame: 'newest', the next that is new here, or a number.
  want(what) { this.send({want: what}); }

  /// Somebody here has taken notice of an alarm.
  acknowledge(id) { this.send({acknowledge: id}); }

  send(wish) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(wish));
  }

  take(data) {
    if (typeof data === 'string') {
      const message = JSON.parse(data);
      if (message.type === 'topic') this.handlers.onTopic(message.name, message.value);
      if (message.type === 'timeline') this.handlers.onTimeline(message);
      return;
    }
    const message = decodeMessage(data);
    if (message.kind === 'frame') this.handlers.onFrame(message);
    if (message.kind === 'environment') this.handlers.onEnvironment(message);
  }
}
