// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Keys, and the list of them that "?" shows.

/// bindings: [{keys: ['ArrowLeft'], name: '←', what: 'One frame back', run}]
export function bindKeys(bindings) {
  const byKey = new Map(bindings.flatMap((binding) => binding.keys.map((key) => [key, binding])));
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const isControl = event.target.closest('button, input, select, dialog');
    if (isControl && (event.key === ' ' || event.key === 'Enter')) return;
    const binding = byKey.get(event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!binding) return;
    event.preventDefault();
    binding.run();
  });
}

export function listKeys(list, bindings) {
  list.replaceChildren(...bindings.flatMap(({name, what}) => {
    const term = document.createElement('dt');
    const key = document.createElement('kbd');
    key.textContent = name;
    term.append(key);
    const meaning = document.createElement('dd');
    meaning.textContent = what;
    return [term, meaning];
  }));
}
