// The head of the page and the bar below it: contents, and what the page shows.

import { byId, choice, make } from '../common/elements.mjs';
import { counted } from '../common/words.mjs';

export function drawHead({ title, description, ids, classes, methods, facts, version, views }) {
  byId('title').textContent = title;
  byId('description').textContent = description;
  const counts = [counted(ids.length, 'model'), counted(classes.length, 'class'), counted(methods.length, 'method')];
  byId('facts').textContent = [...counts, ...facts.map(([name, value]) => `${name}: ${value}`)].join(' \u00b7 ');
  for (const section of document.querySelectorAll('main section')) {
    byId('contents').append(make('a', { href: `#${section.id}` }, section.querySelector('h2').textContent));
  }
  byId('footer').textContent = `Made by shapegauge ${version}. Everything is in this file. Charts: D3 (BSD licence)` +
    `${views ? ', shapes: three.js (MIT licence)' : ''}, in the source of this page.`;
}

export function showChoices(state) {
  state.show(['method', 'protocol', 'average'], () => drawChoices(state));
}

function drawChoices(state) {
  const { report, chosen } = state;
  const names = report.methods.map(({ name }) => name);
  const protocols = report.methods[0].evaluations.map(({ protocol }) => protocol);
  const averages = ['micro', 'macro'];
  const parts = [];
  const add = (label, options, selected, values) =>
    parts.push(choice(label, options, selected, (index) => state.change(values(index))));
  if (names.length > 1) add('Method', names, chosen.method, (method) => ({ method }));
  if (protocols.length > 1) add('Protocol', protocols, chosen.protocol, (protocol) => ({ protocol }));
  add('Mean over', ['queries', 'classes'], averages.indexOf(chosen.average), (i) => ({ average: averages[i] }));
  const place = byId('choices');
  const focused = [...place.querySelectorAll('select')].indexOf(document.activeElement);
  place.replaceChildren(...parts);
  if (focused >= 0) place.querySelectorAll('select')[focused].focus();
}

// Marks the section under way in the contents.
export function followScrolling() {
  const links = new Map([...byId('contents').children].map((link) => [link.hash.slice(1), link]));
  const observer = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      for (const link of links.values()) link.removeAttribute('aria-current');
      links.get(target.id).setAttribute('aria-current', 'true');
    }
  }, { rootMargin: '-15% 0px -75% 0px' });
  document.querySelectorAll('main section').forEach((section) => observer.observe(section));
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
