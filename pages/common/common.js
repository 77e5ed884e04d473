'use strict';
// What all pages share: elements, words, the theme, charts. All text goes into a page as text, never as markup.

const byId = (id) => document.getElementById(id);

// An element with attributes (functions are listeners) and children (strings are text).
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

const plurals = { class: 'classes', query: 'queries' };
const counted = (count, noun) => `${count} ${count === 1 ? noun : plurals[noun] || `${noun}s`}`;
const percent = (fraction) => (100 * fraction).toFixed(2);
const number = (value) => (value === null ? '\u221e' : String(Number(value.toPrecision(4))));

// The bytes of a text in base64.
const bytesOf = (text) => Uint8Array.from(atob(text), (character) => character.charCodeAt(0));

// A labelled choice; options are texts, the value is their position.
function choice(label, options, selected, chosen) {
  const select = make('select', { change: () => chosen(select.selectedIndex) });
  options.forEach((text, index) => select.append(make('option', { selected: index === selected }, text)));
  return make('label', {}, label, select);
}

// It is where the keyboard is, as behind a dialog nothing would show, and goes back before the dialog changes.
const tooltip = {
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
const tipHead = (text) => make('div', { class: 'head' }, text);
const tipLine = (name, value) => make('div', { class: 'line' }, make('span', {}, ...name), make('span', {}, value));

const darkByDefault = window.matchMedia('(prefers-color-scheme: dark)');

// Tells what draws in colours of its own by the event themechange of the document.
function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  const other = theme === 'dark' ? 'light' : 'dark';
  byId('theme').textContent = other === 'dark' ? 'Dark' : 'Light';
  byId('theme').setAttribute('aria-label', `Show the page in ${other} colours`);
  byId('theme').onclick = () => setTheme(other);
  document.dispatchEvent(new Event('themechange'));
}

function followTheme() {
  const set = () => setTheme(darkByDefault.matches ? 'dark' : 'light');
  darkByDefault.addEventListener('change', set);
  set();
}

function drawing(place, { width, height, left, right, top, bottom, label }) {
  const svg = d3.create('svg').attr('viewBox', `0 0 ${width} ${height}`).attr('width', width).attr('height', height)
    .attr('role', 'img').attr('aria-label', label);
  const area = svg.append('g').attr('transform', `translate(${left},${top})`);
  place.replaceChildren(svg.node());
  return { svg, area, width: width - left - right, height: height - top - bottom };
}

// A ramp of the colour map with ticks; place(value) is where a value is, from 0 to 1.
function colourScale(title, ticks, place, format = number) {
  const stops = d3.range(0, 1.01, 0.1).map((t) => d3.interpolateViridis(t)).join(',');
  const marks = ticks.map((tick) => make('span', { style: `left:${100 * place(tick)}%` }, format(tick)));
  return make('div', { class: 'scale' }, make('span', {}, title),
    make('div', {}, make('div', { class: 'ramp', style: `background:linear-gradient(to right,${stops})` }), make('div', { class: 'ticks' }, ...marks)));
}
