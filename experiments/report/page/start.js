'use strict';
// The data, what the reader chose to see, and small helpers. All text goes into the page as text, never as markup.

const report = JSON.parse(document.getElementById('report-data').textContent);

// What is shown. Positions: of the method, of the protocol; hidden: methods that charts leave out.
const measureNames = report.methods[0].evaluations[0].measures;
const state = { method: 0, protocol: 0, average: 'micro', measure: Math.max(0, measureNames.indexOf('FT')), hidden: new Set() };

const views = [];

// Draws a part of the page now and whenever one of these keys of the state changes.
function show(keys, draw) {
  views.push({ keys, draw });
  draw();
}

function change(values) {
  Object.assign(state, values);
  for (const { keys, draw } of views) {
    if (keys.some((key) => key in values)) draw();
  }
}

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

const method = () => report.methods[state.method];
const evaluationOf = (index) => report.methods[index].evaluations[state.protocol];
const evaluation = () => evaluationOf(state.method);
const visibleMethods = () => report.methods.map((_, index) => index).filter((index) => !state.hidden.has(index));
const className = (model) => report.classes[report.labels[model]];

const plurals = { class: 'classes', query: 'queries' };
const counted = (count, noun) => `${count} ${count === 1 ? noun : plurals[noun] || `${noun}s`}`;
const percent = (fraction) => (100 * fraction).toFixed(2);
const number = (value) => (value === null ? '\u221e' : String(Number(value.toPrecision(4))));

const averageWords = () => (state.average === 'micro' ? 'mean over queries (micro)' : 'mean over classes (macro)');
const protocolWords = () => `protocol ${evaluation().protocol}`;

// Says under a section's title what it shows.
function stamp(section, words, ...hints) {
  const sentences = [words.join(', '), ...hints].map((text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`);
  byId(section).querySelector('.stamp').textContent = sentences.join(' ');
}

// A method's colour, dashes and sign: alike in all charts.
const dashes = ['none', '7 3', '2 3', '9 3 2 3', '12 4', '5 2 1 2 1 2', '3 2'];
const colourOf = (index) => `var(--method-${index % 7})`;
const dashesOf = (index) => dashes[(index + Math.floor(index / 7)) % 7];

function swatch(index) {
  const svg = d3.create('svg').attr('class', 'swatch').attr('viewBox', '0 0 22 10').attr('aria-hidden', 'true');
  svg.append('line').attr('x1', 0).attr('x2', 22).attr('y1', 5).attr('y2', 5)
    .style('stroke', colourOf(index)).style('stroke-dasharray', dashesOf(index));
  return svg.node();
}

// Numbers that were packed in two bytes each; null where there is none.
function unpack({ scale, values }) {
  const bytes = atob(values);
  const numbers = new Float64Array(bytes.length / 2);
  for (let i = 0; i < numbers.length; ++i) {
    const level = bytes.charCodeAt(2 * i) + 256 * bytes.charCodeAt(2 * i + 1);
    numbers[i] = level === 65535 ? Infinity : (scale * level) / 65534;
  }
  return numbers;
}

// A labelled choice; options are texts, the value is their position.
function choice(label, options, selected, chosen) {
  const select = make('select', { change: () => chosen(select.selectedIndex) });
  options.forEach((text, index) => select.append(make('option', { selected: index === selected }, text)));
  return make('label', {}, label, select);
}

const tooltip = {
  show(x, y, ...children) {
    const box = byId('tooltip');
    box.replaceChildren(...children);
    box.hidden = false;
    const { width, height } = box.getBoundingClientRect();
    box.style.left = `${x + 16 + width > window.innerWidth ? Math.max(4, x - width - 12) : x + 16}px`;
    box.style.top = `${Math.max(4, Math.min(y + 14, window.innerHeight - height - 4))}px`;
  },
  hide() { byId('tooltip').hidden = true; },
};
const tipHead = (text) => make('div', { class: 'head' }, text);
const tipLine = (name, value) => make('div', { class: 'line' }, make('span', {}, ...name), make('span', {}, value));
