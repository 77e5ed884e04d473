// SPDX-License-Identifier: GPL-3.0-or-later
// What the charts of all pages share.

import { ramp } from './constants.mjs';
import { make } from './elements.mjs';
import { number } from './words.mjs';

// An SVG drawing in a container, and the area within its margins.
export function drawing(container, { width, height, left, right, top, bottom, label }) {
  const svg = d3.create('svg').attr('viewBox', `0 0 ${width} ${height}`).attr('width', width).attr('height', height)
    .attr('role', 'img').attr('aria-label', label);
  const area = svg.append('g').attr('transform', `translate(${left},${top})`);
  container.replaceChildren(svg.node());
  return { svg, area, width: width - left - right, height: height - top - bottom };
}

// The colour of the colour map at a part from 0 to 1.
export const rampColour = (part) => ramp[Math.round((ramp.length - 1) * Math.max(0, Math.min(1, part)))];

// The values at parts of a range; root: of a scale of square roots, so that small values have more of it.
export const scaleTicks = ({ from, to, root, log }) => (log
  ? [0, 0.25, 0.5, 0.75, 1].map((part) => from * (to / from) ** part)
  : (root ? [0, 0.04, 0.16, 0.36, 0.64, 1] : [0, 0.25, 0.5, 0.75, 1]).map((part) => from + part * (to - from)));

// Where a value is on a scale, from 0 to 1 within it.
export function scalePart({ from, to, root, log }, value) {
  if (log && to > from) return value > 0 ? Math.log(value / from) / Math.log(to / from) : -1;
  const part = to > from ? (value - from) / (to - from) : 0.5;
  return root ? Math.sqrt(Math.max(0, part)) : part;
}

// About how many ticks an axis of that many pixels has room for.
export const tickCount = (pixels) => Math.max(2, Math.min(10, Math.floor(pixels / 55)));

// The colour map with ticks, as scalePart() places values on it. It says so where it is not linear.
export function colourScale(title, scale) {
  const kind = (scale.root && ', square-root scale') || (scale.log && ', logarithmic scale') || '';
  const ticks = scale.to > scale.from ? scaleTicks(scale) : [scale.from];
  const marks = ticks.map((tick) => make('span', { style: `left:${100 * scalePart(scale, tick)}%` }, number(tick, 3)));
  const stops = ramp.filter((_, level) => level % 15 === 0).join(',');
  const coloured = make('div', { class: 'ramp', style: `background:linear-gradient(to right,${stops})` });
  return make('div', { class: 'scale' }, make('span', {}, `${title}${kind}`),
    make('div', {}, coloured, make('div', { class: 'ticks' }, ...marks)));
}
