// SPDX-License-Identifier: GPL-3.0-or-later
// What a page shows, in the fragment of its address: #method=Offset+SDF&query=T12. Whoever opens it sees the same.

const delay = 300; // milliseconds; browsers refuse to change the address at every move of the pointer

const fragment = typeof location !== 'undefined' && location.hash.includes('=') ? location.hash.slice(1) : '';
const state = new URLSearchParams(fragment);
let timer = null;

export const linked = (key) => state.get(key);

// Puts values into the address; null removes one.
export function link(values) {
  for (const [key, value] of Object.entries(values)) {
    if (value === null) state.delete(key);
    else state.set(key, value);
  }
  clearTimeout(timer);
  timer = setTimeout(() => history.replaceState(null, '', `#${state}`), delay);
}

// Shows what another address says that is typed into the page.
export function followAddress() {
  window.addEventListener('hashchange', () => {
    if (location.hash.includes('=')) location.reload();
  });
}
