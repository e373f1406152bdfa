// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Wires the parts together.
import {Connection} from './connection.js';
import {byId, element} from './element.js';
import {bindKeys, listKeys} from './keyboard.js';
import {showAlarms} from './panels/alarms_panel.js';
import {showBanner} from './panels/banner.js';
import {DepthPanel} from './panels/depth_panel.js';
import {makeColorChoice} from './panels/legend.js';
import {showPersons} from './panels/persons_panel.js';
import {clockText, Plot} from './panels/plot.js';
import {showServices, showStages} from './panels/services_panel.js';
import {Player} from './player.js';
import {kColorModes} from './scene/cell_shader.js';
import {World} from './scene/world.js';
import {followTheme} from './theme.js';
import {Timeline} from './timeline.js';

const timeline = new Timeline();
const world = new World(byId('world'), byId('labels'));
const depthPanel = new DepthPanel();
const player = new Player(timeline, (what) => connection.want(what), () => showControls());
const plot = new Plot(timeline, player);
let source = null;
let frame = null;
let alarms = [];
let activeAlarms = [];  // at the time that is shown
let received = [];  // times of the last frames that came [ms]

function showSource() {
  const isLost = connection.socket.readyState !== WebSocket.OPEN;
  byId('mode-chip').dataset.state = isLost ? 'lost' : source?.mode ?? 'lost';
  const reading = source?.share_read < 1 ? ` · reading ${Math.floor(100 * source.share_read)} %` : '';
  const mode = source?.mode === 'live' ? 'Live' : `Recording${reading}`;
  byId('mode-text').textContent = isLost ? 'Server away, trying again' : source ? mode : 'Connecting';
  byId('source-chip').textContent = source ? `${source.name} · ${source.camera}` : '';
  const notice = byId('notice');
  notice.hidden = !source?.damage;
  if (source?.damage) {
    notice.textContent = `Part of the recording could not be used: ${source.damage} × ${source.damage_example}`;
  }
}

function takeSource(value) {
  const isNew = value.mode !== source?.mode || value.name !== source?.name;
  source = value;
  player.isGrowing = value.mode === 'replay' && value.share_read < 1;
  if (isNew) player.isLiveFeed = value.mode === 'live';
  if (isNew || !hasBegun) begin();
  showSource();
}

// Frames are asked for once the source and the first entries of the timeline are known.
let hasBegun = false;
function begin() {
  if (!source || (source.mode === 'replay' && timeline.entries.length === 0)) return;
  hasBegun = true;
  player.begin(source.mode === 'live');
}

function takeTimeline(message) {
  timeline.take(message);
  if (hasBegun) player.timelineGrew();
  else begin();
  plot.invalidate();
  showControls();
}

function takeFrame(value) {
  frame = value;
  received.push(performance.now());
  received = received.slice(-20);
  byId('empty').hidden = true;
  world.showFrame(frame);
  depthPanel.show(frame);
  showPersons(frame);
  showNews();
  if (frame.milliseconds) showStages(frame.milliseconds);
  plot.threshold = frame.min_probability ?? plot.threshold;
  showFacts();
  player.arrived(frame.index);
  world.marks.showPath(timeline, frame.index);
  plot.invalidate();
}

// An alarm may come, or be acknowledged, between two frames.
function showNews() {
  const isNewest = player.isLiveFeed && player.followsNewest;
  activeAlarms = showAlarms(alarms, isNewest ? Infinity : frame?.utime ?? 0, isNewest ? acknowledge : null);
  showBanner(frame ?? {}, activeAlarms);
}

function acknowledge(id) { connection.acknowledge(id); }

function acknowledgeNewest() {
  const newest = activeAlarms.find(({state}) => state === 'raised');
  if (newest && player.isLiveFeed && player.followsNewest) acknowledge(newest.alarm.id);
}

function showFacts() {
  const ground = frame.ground;
  const parts = [frame.cells ? `${frame.cells.count} cells` : 'no map'];
  if (ground) parts.push(ground.status === 'ok' ? `floor by ${ground.method.replace('_', '-')}` : 'no floor in view');
  if (frame.background) parts.push(frame.background.replaceAll('_', ' '));
  if (frame.frame) parts.push(`${frame.frame} frame`);
  byId('map-facts').textContent = parts.join(' · ');
}

function showControls() {
  byId('play-button').classList.toggle('is-running', player.isPlaying || player.followsNewest);
  byId('speed-button').textContent = `${player.speed}×`;
  byId('speed-button').hidden = player.isLiveFeed;
  byId('live-button').hidden = !player.isLiveFeed;
  byId('live-button').setAttribute('aria-pressed', String(player.followsNewest));
  byId('position').textContent = player.shown < 0 ? '' :
      `${clockText(timeline.secondsOf(player.shown))} / ${clockText(timeline.seconds)} · ${player.shown}`;
}

function showRates(now) {
  const [first, last] = [received[0], received.at(-1)];
  const isFlowing = received.length > 1 && now - last < 1500;
  const rate = isFlowing ? (1000 * (received.length - 1)) / (last - first) : 0;
  byId('frame-rate').textContent = `${world.pace.framesPerSecond(now).toFixed(0)} fps · ${rate.toFixed(1)} Hz`;
}

const connection = new Connection({
  onState(state) {
    if (state === 'open') {
      timeline.clear();
      hasBegun = false;
    }
    showSource();
  },
  onTopic(name, value) {
    if (name === 'source') takeSource(value);
    if (name === 'services') showServices(value);
    if (name === 'alarms') {
      alarms = value;
      showNews();
    }
  },
  onTimeline: takeTimeline,
  onFrame: takeFrame,
  onEnvironment: (environment) => world.showEnvironment(environment),
});

const chooseColor = makeColorChoice((mode) => world.setColorMode(mode));
chooseColor('score');

function toggleFollowing() {
  world.viewpoint.follows = !world.viewpoint.follows;
  followButton.setAttribute('aria-pressed', String(world.viewpoint.follows));
}

const toggleTheme = followTheme(() => {
  world.setThemeColors();
  if (frame) {
    world.boxes.show(frame);
    depthPanel.show(frame);
  }
  plot.invalidate();
});

const bindings = [
  {keys: [' '], name: 'Space', what: 'Play or pause', run: () => player.togglePlaying()},
  {keys: ['ArrowLeft', ','], name: '←', what: 'One frame back', run: () => player.step(-1)},
  {keys: ['ArrowRight', '.'], name: '→', what: 'One frame on', run: () => player.step(1)},
  {keys: ['Home'], name: 'Home', what: 'To the beginning', run: () => player.seek(timeline.kept)},
  {keys: ['End'], name: 'End', what: 'To the end', run: () => player.seek(timeline.end - 1)},
  {keys: ['l'], name: 'L', what: 'Back to the newest (live)', run: () => player.goLive()},
  {keys: ['s'], name: 'S', what: 'Speed', run: () => player.nextSpeed()},
  ...kColorModes.map((mode, i) => (
      {keys: [`${i + 1}`], name: `${i + 1}`, what: `Colour by ${mode}`, run: () => chooseColor(mode)})),
  {keys: ['r'], name: 'R', what: 'View from behind the robot', run: () => world.viewpoint.reset()},
  {keys: ['v'], name: 'V', what: 'View from above', run: () => world.viewpoint.fromAbove()},
  {keys: ['c'], name: 'C', what: 'View of the camera', run: () => world.viewpoint.throughCamera()},
  {keys: ['f'], name: 'F', what: 'Follow the robot, or not', run: toggleFollowing},
  {keys: ['g'], name: 'G', what: 'Floor lines, or not', run: () => { world.floor.toggle(); world.invalidate(); }},
  {keys: ['e'], name: 'E', what: 'Environment map, or not', run: () => world.toggleEnvironment()},
  {keys: ['a'], name: 'A', what: 'Acknowledge the newest alarm (live)', run: acknowledgeNewest},
  {keys: ['t'], name: 'T', what: 'Light or dark', run: toggleTheme},
  {keys: ['?'], name: '?', what: 'These keys', run: () => byId('help').showModal()},
];
bindKeys(bindings);
listKeys(byId('keys'), bindings);

function viewButton(text, key) {
  const binding = bindings.find(({keys}) => keys[0] === key);
  const button = element('button', {title: `${binding.what} (${binding.name})`}, text);
  button.addEventListener('click', binding.run);
  byId('view-buttons').append(button);
  return button;
}
viewButton('Behind', 'r');
viewButton('Above', 'v');
viewButton('Camera', 'c');
const followButton = viewButton('Follow', 'f');
followButton.setAttribute('aria-pressed', 'true');

byId('play-button').addEventListener('click', () => player.togglePlaying());
byId('back-button').addEventListener('click', () => player.step(-1));
byId('forward-button').addEventListener('click', () => player.step(1));
byId('speed-button').addEventListener('click', () => player.nextSpeed());
byId('live-button').addEventListener('click', () => player.goLive());
byId('theme-button').addEventListener('click', toggleTheme);
byId('help-button').addEventListener('click', () => byId('help').showModal());

let lastTick = performance.now();
let lastRates = 0;
function tick(now) {
  player.tick(Math.min(Math.max(now - lastTick, 0), 250) * 1e-3);
  lastTick = now;
  world.draw(now);
  plot.draw(now);
  if (now - lastRates > 500) {
    lastRates = now;
    showRates(now);
  }
  requestAnimationFrame(tick);
}
requestAnimationFrame(tick);
showControls();

// For tests, and for whoever has the console open.
window.fallenView = {world, player, timeline, connection, get frame() { return frame; }};
