// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// How fluid the page is with a big map live: node big_map_rate.mjs BIN_DIR PUBLISH_MAPS SOURCE_DIR OUT_DIR
// A measurement for a machine that has nothing else to do, no test of every day.
import assert from 'node:assert/strict';
import {mkdirSync, readFileSync} from 'node:fs';
import path from 'node:path';
import {after, test} from 'node:test';

import {findBrowser, openPage, start, startViewer, waitFor} from './viewer.mjs';

const [bin, publisher, source, out] = process.argv.slice(2);
const kBigMap = 6000;
const kSeconds = 30;
const lcm = `udpm://239.255.76.67:${20000 + process.pid % 10000}?ttl=0&recv_buf_size=4194304`;
mkdirSync(out, {recursive: true});

function residentMegabytes(pid) {
  return Number(/VmRSS:\s*(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]) / 1024;
}

const finder = findBrowser(source);
const running = [];  // what ends with the measurement, however that ends
after(async () => {
  for (const end of running) await end();
});
test(`keeps up with ${kBigMap} ellipsoids at 10 Hz`, async () => {
  const [browser, {viewer, address}] = await Promise.all([
    finder.launch(), startViewer(path.join(bin, 'fallen-view'), ['--lcm-url', lcm, '--camera', 'CAMERA', '--port', '0'])]);
  running.push(() => browser.close(), () => viewer.kill());
  const page = await openPage(browser, address);
  const maps = start(publisher, [lcm, String(kBigMap), String(kSeconds + 300)]);
  running.push(() => maps.kill('SIGKILL'));
  await waitFor(page, (count) => fallenView.world.cells.count === count, kBigMap);
  // Drawn whether there is news or not, as when somebody turns the view.
  await page.evaluate(() => {
    window.shown = 0;
    let last = null;
    const turn = () => {
      if (fallenView.frame !== last) ++window.shown;
      last = fallenView.frame;
      fallenView.world.invalidate();
      requestAnimationFrame(turn);
    };
    turn();
  });
  await page.waitForTimeout(3000);  // finds its pace
  const begin = await page.evaluate(() => ({time: performance.now(), shown: window.shown}));
  const drawn = [], resident = [];
  while (drawn.length < kSeconds) {
    await page.waitForTimeout(1000);
    drawn.push(await page.evaluate(() => fallenView.world.pace.framesPerSecond(performance.now())));
    resident.push(residentMegabytes(viewer.pid));
  }
  const end = await page.evaluate(() => ({time: performance.now(), shown: window.shown}));
  const hertz = 1000 * (end.shown - begin.shown) / (end.time - begin.time);
  drawn.sort((a, b) => a - b);
  console.log(`${kBigMap} ellipsoids: ${hertz.toFixed(1)} maps/s shown, drawn ${drawn[0]} to ${drawn.at(-1)}, median ` +
      `${drawn[drawn.length >> 1]} pictures/s in software; server ${resident[0].toFixed(0)} MB at first, ` +
      `${resident.at(-1).toFixed(0)} MB at last, at most ${Math.max(...resident).toFixed(0)} MB`);
  assert.ok(hertz > 8, `${hertz} maps a second`);
  assert.deepEqual(page.problems, []);
  maps.kill('SIGKILL');
  await page.screenshot({path: path.join(out, 'big-map.png'), timeout: 60_000});
});
