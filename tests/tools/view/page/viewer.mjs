// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// fallen-view as a process, and the browser that looks at it.
import {spawn} from 'node:child_process';
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';

const kBrowsers = ['/usr/bin/chromium', '/usr/bin/chromium-browser'];
const kSkipped = 77;  // for CTest

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(kSkipped);
}

/// Playwright and Debian's Chromium; ends the process if one is not there.
export function findBrowser(source) {
  const packageFile = path.join(source, 'tools/view/page/package.json');
  const executablePath = kBrowsers.find(existsSync);
  if (!executablePath) skip('no chromium, expected Debian\'s package');
  let playwright;
  try {
    playwright = createRequire(packageFile)('playwright-core');
  } catch {
    skip('no playwright-core, expected npm ci in tools/view/page');
  }
  // Software rendering: the same picture on every machine.
  const args = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
  if (process.getuid() === 0) args.push('--no-sandbox');
  return {launch: () => playwright.chromium.launch({executablePath, args})};
}

/// A process that is killed with this one.
export function start(program, args) {
  const child = spawn(program, args, {stdio: ['ignore', 'pipe', 'pipe']});
  const kill = () => child.kill('SIGKILL');
  process.on('exit', kill);
  child.output = '';
  for (const stream of [child.stdout, child.stderr]) {
    stream.on('data', (bytes) => { child.output += bytes; });
  }
  child.ended = new Promise((resolve) => child.on('exit', (status) => {
    process.off('exit', kill);
    resolve(status);
  }));
  return child;
}

/// Starts fallen-view; resolves with its process and the address that it printed.
export async function startViewer(program, args) {
  const viewer = start(program, args);
  const until = Date.now() + 60_000;
  while (Date.now() < until) {
    const address = /(http:\/\/\S+)\n/.exec(viewer.output)?.[1];
    if (address) return {viewer, address, port: new URL(address).port};
    if (viewer.exitCode !== null) break;
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  throw new Error(`fallen-view did not start: ${viewer.output}`);
}

/// A page that fails the test for anything it logs as an error.
export async function openPage(browser, address, options = {}) {
  const page = await browser.newPage({viewport: {width: 1280, height: 800}, colorScheme: 'dark', ...options});
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(error.message));
  page.on('console', (message) => {
    const isAboutTheServer = message.text().includes('WebSocket connection');
    if (message.type() === 'error' && !isAboutTheServer) page.problems.push(message.text());
  });
  await page.goto(address);
  return page;
}

/// Resolves once `condition` (runs in the page, with `argument`) holds.
export function waitFor(page, condition, argument) {
  return page.waitForFunction(condition, argument, {timeout: 60_000, polling: 100});
}
