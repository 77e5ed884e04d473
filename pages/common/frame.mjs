// SPDX-License-Identifier: GPL-3.0-or-later
// What surrounds the contents of all pages: head, bar with contents and choices, footer.

import { byId, make } from './elements.mjs';
import { followAddress, link, linked } from './link.mjs';
import { followTheme } from './theme.mjs';

// facts: short texts below the title.
export function drawFrame({ description = '', version }, facts) {
  followTheme();
  byId('description').textContent = description;
  byId('facts').textContent = facts.join(' \u00b7 ');
  const links = new Map([...document.querySelectorAll('main > section[id]')].map((section) =>
    [section, make('a', { href: `#section=${section.id}`, click: (event) => goTo(event, section) },
      section.querySelector('h2').textContent)]));
  byId('contents').replaceChildren(...links.values());
  byId('bar').hidden = links.size === 0;
  const shapes = typeof THREE === 'undefined' ? '' : ', shapes: three.js (MIT licence)';
  byId('footer').textContent = `Made by shapegauge ${version}. Everything is in this file. ` +
    `Charts: D3 (BSD licence)${shapes}, in the source of this page.`;
  followScrolling(links);
  followAddress();
  const asked = byId(linked('section'));
  if (asked) requestAnimationFrame(() => asked.scrollIntoView()); // when it is drawn
}

function goTo(event, section) {
  event.preventDefault();
  section.scrollIntoView();
  link({ section: section.id });
}

// Marks the section under way in the contents.
function followScrolling(links) {
  const observer = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      for (const other of links.values()) other.removeAttribute('aria-current');
      links.get(target).setAttribute('aria-current', 'true');
    }
  }, { rootMargin: '-15% 0px -75% 0px' });
  for (const section of links.keys()) observer.observe(section);
}

// Draws again what is as wide as the window lets it be.
export function followResizing(draw) {
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    draw();
  });
}
