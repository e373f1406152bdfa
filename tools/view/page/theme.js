// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Light or dark: as the system has it, until somebody says otherwise.

const kKey = 'fallen-theme';
const systemDark = matchMedia('(prefers-color-scheme: dark)');

function current() {
  return localStorage.getItem(kKey) ?? (systemDark.matches ? 'dark' : 'light');
}

/// Sets the theme, and again whenever it changes; tells `onChange` each time.
export function followTheme(onChange) {
  const apply = () => {
    document.documentElement.dataset.theme = current();
    onChange();
  };
  systemDark.addEventListener('change', apply);
  apply();
  return function toggle() {
    localStorage.setItem(kKey, current() === 'dark' ? 'light' : 'dark');
    apply();
  };
}
