// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The history of alarms, as it stood at the time of the frame that is shown.
import {byId, element} from '../element.js';

/// What an alarm was at `utime`: 'raised', 'acknowledged' or 'cleared'; null before it was raised.
export function stateAt(alarm, utime) {
  const has = (time) => time > 0 && time <= utime;
  if (!has(alarm.raised_utime)) return null;
  if (has(alarm.cleared_utime)) return 'cleared';
  return has(alarm.acknowledged_utime) ? 'acknowledged' : 'raised';
}

function clock(utime) { return new Date(utime / 1000).toLocaleTimeString(); }

function item(alarm, state, acknowledge) {
  const [x, y] = alarm.position;
  const by = {acknowledged: alarm.acknowledged_by, cleared: alarm.cleared_by}[state];
  const what = element('span', {}, `(${x.toFixed(1)}, ${y.toFixed(1)}) m · p ${alarm.probability.toFixed(3)} · ` +
      `${alarm.views} ${alarm.views === 1 ? 'view' : 'views'}`);
  const row = element('li', {'data-state': state}, element('span', {class: 'state'}), what,
                      element('span', {class: 'when'}, clock(alarm.raised_utime)), element('span'),
                      element('span', {class: 'when'}, by ? `${state} by ${by}` : state));
  if (acknowledge && state === 'raised') {
    const button = element('button', {class: 'pill', title: 'I have seen it (A: the newest)'}, 'Acknowledge');
    button.addEventListener('click', () => acknowledge(alarm.id));
    row.append(button);
  }
  return row;
}

// The list stays as it is until it changes: a button must not go away between press and release.
let shown = '';

/// Shows the alarms up to `utime`.
/// @param acknowledge  Is called with the id of an alarm that somebody takes notice of; null where that cannot be.
/// @return Those that are active then, the newest first.
export function showAlarms(alarms, utime, acknowledge) {
  const known = alarms.map((alarm) => ({alarm, state: stateAt(alarm, utime)})).filter(({state}) => state);
  const active = known.filter(({state}) => state !== 'cleared');
  const wanted = JSON.stringify([known, acknowledge !== null]);
  if (wanted === shown) return active;
  shown = wanted;
  byId('alarms-card').hidden = known.length === 0;
  byId('alarms-summary').textContent = `${active.length} active`;
  byId('alarms').replaceChildren(...known.map(({alarm, state}) => item(alarm, state, acknowledge)));
  return active;
}
