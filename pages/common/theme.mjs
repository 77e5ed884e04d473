// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark colours: those of the reader's system until the reader chooses.

import { byId } from './elements.mjs';

// Dispatches the event themechange of the document, for what draws in colours of its own.
function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  const other = theme === 'dark' ? 'light' : 'dark';
  byId('theme').textContent = other === 'dark' ? 'Dark' : 'Light';
  byId('theme').setAttribute('aria-label', `Show the page in ${other} colours`);
  byId('theme').onclick = () => setTheme(other);
  document.dispatchEvent(new Event('themechange'));
}

export function followTheme() {
  const darkByDefault = window.matchMedia('(prefers-color-scheme: dark)');
  const set = () => setTheme(darkByDefault.matches ? 'dark' : 'light');
  darkByDefault.addEventListener('change', set);
  set();
}
