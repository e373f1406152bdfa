// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The page in a real browser: node page_test.mjs FALLEN_VIEW SOURCE_DIR OUT_DIR
// Screenshots are left in OUT_DIR, to be looked at.
import assert from 'node:assert/strict';
import {mkdirSync} from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {findBrowser, openPage, startViewer, waitFor} from './viewer.mjs';

const [program, source, out] = process.argv.slice(2);
const demo = path.join(source, 'recordings/demo.lcm');
const kDemoFrames = 60;
mkdirSync(out, {recursive: true});

const finder = findBrowser(source);
let browser;
let shown;  // {viewer, address, port}
before(async () => {
  [browser, shown] = await Promise.all([finder.launch(), startViewer(program, [demo, '--port', '0'])]);
});
after(async () => {
  await browser?.close();
  shown?.viewer.kill();
});

async function openDemo(options) {
  const page = await openPage(browser, shown.address, options);
  await waitFor(page, (count) => fallenView.timeline.end === count && fallenView.frame, kDemoFrames);
  return page;
}

async function showFrame(page, index) {
  await page.evaluate((wanted) => {
    fallenView.player.isPlaying = false;
    fallenView.player.seek(wanted);
  }, index);
  await waitFor(page, (wanted) => fallenView.frame.index === wanted, index);
}

/// Share of the map's pixels that something is drawn on.
function drawnShare(page) {
  return page.evaluate(() => {
    const {renderer, scene, viewpoint} = fallenView.world;
    renderer.render(scene, viewpoint.camera);
    const context = renderer.getContext();
    const [width, height] = [context.drawingBufferWidth, context.drawingBufferHeight];
    const pixels = new Uint8Array(4 * width * height);
    context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, pixels);
    let drawn = 0;
    for (let i = 3; i < pixels.length; i += 4) drawn += pixels[i] > 250;
    return drawn / (width * height);
  });
}

function shoot(page, name) { return page.screenshot({path: path.join(out, `${name}.png`), timeout: 60_000}); }

test('shows cells and a person of a recording', async () => {
  const page = await openDemo();
  await showFrame(page, 45);
  assert.ok(await page.evaluate(() => fallenView.world.cells.count) > 3000);
  assert.ok(await drawnShare(page) > 0.08, 'the map is drawn');
  assert.match(await page.textContent('#persons'), /Fallen person/);
  assert.match(await page.textContent('#banner'), /Fallen person/);
  assert.ok(await page.isVisible('#banner'));
  assert.match(await page.textContent('#services'), /Descriptors/);
  assert.match(await page.textContent('#labels'), /fallen person/);
  await shoot(page, 'replay-dark');
  for (const [key, mode] of [['2', 'Cluster'], ['3', 'Height'], ['4', 'Age']]) {
    await page.keyboard.press(key);
    assert.equal(await page.textContent('#color-modes [aria-checked="true"]'), mode);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('scrubs by keyboard and pointer, and plays', async () => {
  const page = await openDemo();
  await showFrame(page, 10);
  await page.keyboard.press('ArrowRight');
  await waitFor(page, () => fallenView.frame.index === 11);
  await page.keyboard.press('ArrowLeft');
  await waitFor(page, () => fallenView.frame.index === 10);
  await page.keyboard.press('End');
  await waitFor(page, (last) => fallenView.frame.index === last, kDemoFrames - 1);
  const {x, y, width, height} = await page.locator('#plot').boundingBox();
  await page.mouse.move(x + 0.9 * width, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + 0.5 * width, y + height / 2, {steps: 3});
  await page.mouse.up();
  await waitFor(page, (count) => Math.abs(fallenView.frame.index - count / 2) <= 3, kDemoFrames);
  await page.keyboard.press('Home');
  await waitFor(page, () => fallenView.frame.index === 0);
  await page.keyboard.press('Space');
  await waitFor(page, () => fallenView.frame.index > 5);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('is all there on a narrow tablet, in light', async () => {
  const page = await openDemo({viewport: {width: 768, height: 1024}, colorScheme: 'light', hasTouch: true});
  await showFrame(page, 45);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `the page is ${overflow} px too wide`);
  for (const id of ['stage', 'depth-card', 'persons-card', 'plot', 'play-button']) {
    assert.ok(await page.isVisible(`#${id}`), id);
  }
  await shoot(page, 'tablet-light');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
  await page.keyboard.press('t');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('finds the server again after a restart', async () => {
  const page = await openDemo();
  await showFrame(page, 20);
  shown.viewer.kill();
  assert.equal(await shown.viewer.ended, 0, 'the server ends cleanly');
  await waitFor(page, () => document.getElementById('mode-chip').dataset.state === 'lost');
  await page.evaluate(() => { fallenView.frameBefore = fallenView.frame; });
  shown = await startViewer(program, [demo, '--port', shown.port]);
  await waitFor(page, () => document.getElementById('mode-chip').dataset.state === 'replay');
  await waitFor(page, () => fallenView.frame !== fallenView.frameBefore);
  await waitFor(page, () => fallenView.frame.index === 20);
  assert.deepEqual(page.problems, []);
  await page.close();
});
