// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The page live, beside fallen-alarm: node live_test.mjs BIN_DIR SOURCE_DIR OUT_DIR
// Screenshots are left in OUT_DIR, to be looked at.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, rmSync, writeFileSync} from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {findBrowser, openPage, start, startViewer, waitFor} from './viewer.mjs';

const [bin, source, out] = process.argv.slice(2);
const lcm = `udpm://239.255.76.67:${20000 + process.pid % 10000}?ttl=0&recv_buf_size=4194304`;
const program = (name) => path.join(bin, name);
const demo = path.join(source, 'recordings/demo.lcm');
const decided = path.join(out, 'decided.lcm');
const environment = path.join(out, 'environment.map');
mkdirSync(out, {recursive: true});

const finder = findBrowser(source);
let browser;
let viewer;
let page;  // one for all tests: drawing in software is slow
before(async () => {
  const quiet = {stdio: 'ignore'};
  execFileSync(program('fallen-detect'), [demo, '--json', '/dev/null', '--output', decided], quiet);
  execFileSync(program('fallen-map'), [demo, '-o', environment], quiet);
  [browser, viewer] = await Promise.all([
    finder.launch(),
    startViewer(program('fallen-view'), ['--lcm-url', lcm, '--camera', 'CAMERA', '--map', environment, '--port', '0'])]);
  page = await openPage(browser, viewer.address, {viewport: {width: 800, height: 600}});
});
after(async () => {
  await browser?.close();
  viewer?.viewer.kill();
});

/// fallen-alarm of a robot with this name, with an empty history, once it is up.
async function startAlarm(name) {
  const config = path.join(out, `${name}.yaml`);
  writeFileSync(config, `service: {robot: ${name}}\n`);
  const history = path.join(out, `${name}.db`);
  for (const end of ['', '-wal', '-shm', '.lock']) rmSync(history + end, {force: true});
  const alarm = start(program('fallen-alarm'), ['--lcm-url', lcm, '--config', config, '--history', history]);
  assert.equal(await start(program('fallen-listen'), ['--lcm-url', lcm, '--wait-for', 'alarm']).ended, 0);
  return {alarm, history};
}

/// Plays what was decided until the page shows an alarm that nobody has acknowledged.
async function raise(channels) {
  const player = start('lcm-logplayer', [`--lcm-url=${lcm}`, '--speed=3', `--regexp=${channels}`, decided]);
  await waitFor(page, () => document.querySelector('#alarms li[data-state="raised"]'));
  await player.ended;
}

async function endAcknowledged({alarm, history}) {
  await waitFor(page, () => document.querySelector('#alarms li[data-state="acknowledged"]') &&
                            !document.querySelector('#alarms li[data-state="raised"]'));
  assert.match(await page.textContent('#alarms'), /acknowledged by the page/);
  assert.match(await page.textContent('#banner'), /acknowledged/);
  const list = execFileSync(program('fallen-alarm'), ['history', '--file', history, 'list', '--json'], {encoding: 'utf8'});
  assert.equal(JSON.parse(list.trim().split('\n')[0]).acknowledged_by, 'the page');
  alarm.kill('SIGTERM');
  assert.equal(await alarm.ended, 0);
}

test('shows the environment map, and an alarm that a click acknowledges', async () => {
  const service = await startAlarm('click');
  await raise('.*');
  assert.match(await page.textContent('#banner'), /Alarm: fallen person/);
  const shown = () => page.evaluate(() => fallenView.world.environment.mesh.visible);
  assert.ok(await page.evaluate(() => fallenView.world.environment.count) > 1000);
  assert.equal(await shown(), true);
  await page.keyboard.press('e');
  assert.equal(await shown(), false);
  await page.keyboard.press('e');
  await page.screenshot({path: path.join(out, 'live-alarm.png'), timeout: 60_000});
  await page.click('#alarms button');
  await endAcknowledged(service);
  assert.equal(await page.locator('#alarms button').count(), 0);
  assert.deepEqual(page.problems, []);
});

test('acknowledges with a key', async () => {
  const service = await startAlarm('key');
  await raise('FALLEN_PERSONS_.*');  // nothing to draw
  await page.keyboard.press('a');
  await endAcknowledged(service);
  assert.deepEqual(page.problems, []);
});
