// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// How each service does, as its STATUS_ message says; or how long each stage took in this process.
import {byId, element} from '../element.js';

const kSilentAfter = 3;  // statuses come once a second [s]
const kStages = [['ground', 'Floor'], ['ndt', 'NDT map'], ['background', 'Background'], ['iron', 'Descriptors'],
                 ['cells', 'Cells'], ['clusters', 'Clusters']];

function row(service) {
  const isSilent = service.silent_s > kSilentAfter;
  const state = isSilent ? 'silent' : service.state;
  const drops = service.dropped_late + service.dropped_damaged + service.lost_upstream;
  const made = element('tr', {'data-state': state});
  const name = element('td', {title: `${service.version}, process ${service.pid}, ${state}`},
                       element('span', {class: 'state'}), service.service);
  const dropTitle = `late ${service.dropped_late}, damaged ${service.dropped_damaged}, ` +
      `lost on the way ${service.lost_upstream}`;
  made.append(name, element('td', {}, service.rate_hz.toFixed(1)),
              element('td', {title: `99 %: ${service.p99_ms.toFixed(1)} ms`}, service.median_ms.toFixed(1)),
              element('td', {class: drops ? 'bad' : '', title: dropTitle}, String(drops)),
              element('td', {}, (service.resident_bytes / 2 ** 20).toFixed(0)));
  const text = isSilent ? `silent for ${service.silent_s.toFixed(0)} s` : service.text;
  if (!text) return [made];
  return [made, element('tr', {class: 'text'}, element('td', {colspan: '5'}, text))];
}

export function showServices(services) {
  byId('services-title').textContent = 'Services';
  if (services.length === 0) {
    byId('services').replaceChildren(element('p', {class: 'none'}, 'No service has said anything yet.'));
    return;
  }
  const head = element('tr', {}, ...['Service', 'Hz', 'ms', 'drops', 'MB'].map((title) => element('th', {}, title)));
  byId('services').replaceChildren(element('table', {}, head, ...services.flatMap(row)));
}

export function showStages(milliseconds) {
  byId('services-title').textContent = 'Time of each stage';
  const slowest = Math.max(...kStages.map(([name]) => milliseconds[name]));
  const rows = kStages.flatMap(([name, title]) => {
    const bar = element('i');
    bar.style.width = `${(100 * milliseconds[name]) / slowest}%`;
    return [element('span', {}, title), element('div', {class: 'track'}, bar),
            element('span', {class: 'ms'}, `${milliseconds[name].toFixed(1)} ms`)];
  });
  const total = [element('span', {class: 'total'}, 'Total'), element('span'),
                 element('span', {class: 'ms total'}, `${milliseconds.total.toFixed(1)} ms`)];
  byId('services').replaceChildren(element('div', {class: 'stages'}, ...rows, ...total));
}
