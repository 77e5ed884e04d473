// SPDX-License-Identifier: GPL-3.0-or-later
// The tooltip of a page.

import { byId, make } from './elements.mjs';

export const tooltip = {
  // An open dialog hides what is behind it: the tooltip moves into it, and back to the page when it is hidden.
  show(x, y, ...children) {
    const box = byId('tooltip');
    const home = document.querySelector('dialog[open]') || document.body;
    if (box.parentNode !== home) home.append(box);
    box.replaceChildren(...children);
    box.hidden = false;
    const { width, height } = box.getBoundingClientRect();
    box.style.left = `${x + 16 + width > window.innerWidth ? Math.max(4, x - width - 12) : x + 16}px`;
    box.style.top = `${Math.max(4, Math.min(y + 14, window.innerHeight - height - 4))}px`;
  },
  hide() {
    const box = byId('tooltip');
    box.hidden = true;
    if (box.parentNode !== document.body) document.body.append(box);
  },
};

export const tipHead = (text) => make('div', { class: 'head' }, text);
export const tipLine = (name, value) =>
  make('div', { class: 'line' }, make('span', {}, ...name), make('span', {}, value));
