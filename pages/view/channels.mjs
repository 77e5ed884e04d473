// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours of a view can show, and on which scale.

import { rampColour, scalePart } from '../common/chart.mjs';
import { belowColour, unknownColour } from '../common/constants.mjs';

// Fields, parts, normals, the bare shape: { name, kind, of(shape) }, where of() is null for a shape without it.
export function channelsOf(shapes) {
  const named = (key, kind) => {
    const names = [...new Set(shapes.flatMap((shape) => shape[key].map(({ name }) => name)))];
    return names.map((name) => ({ name, kind, of: (shape) => shape[key].find((one) => one.name === name) || null }));
  };
  const channels = [...named('fields', 'values'), ...named('parts', 'parts')];
  if (shapes.some(({ directions }) => directions)) {
    channels.push({ name: 'Normals', kind: 'normals', of: ({ directions }) => directions });
  }
  return [...channels, { name: 'Nothing', kind: 'plain', of: () => null }];
}

// The scale of a channel's colours on a shape { from, to, root } and the range of its values { low, high }: a preset
// scale, the one that the field has set, or from the least to the greatest of the shapes that share it; log: by the
// logarithm; below: what is less is painted. Null where the shape has no values.
export function scaleOf(channel, shape, sharing, preset) {
  const field = channel.of(shape);
  if (channel.kind !== 'values' || !field) return null;
  if (preset) return { low: field.low, high: field.high, ...preset };
  const marks = { ...(field.log && { log: true }), ...(field.below !== undefined && { below: field.below }) };
  if (field.set) return { from: field.from, to: field.to, low: field.low, high: field.high, ...marks };
  const fields = sharing.map((other) => channel.of(other)).filter(Boolean);
  const least = (key) => Math.min(...fields.map((one) => one[key]));
  const greatest = (key) => Math.max(...fields.map((one) => one[key]));
  return { from: least('from'), to: greatest('to'), low: least('low'), high: greatest('high'), ...marks };
}

// What DrawnShape.show() is to show.
export function shownBy(channel, shape, scale) {
  const data = channel.of(shape);
  if (scale) return { kind: 'values', values: data.values, ...scale };
  if (!data) return { kind: 'plain' };
  if (channel.kind !== 'parts') return { kind: channel.kind };
  return { kind: 'values', values: data.values, from: 0, to: data.colours.length - 1, colours: data.colours };
}

// The bins of a histogram of what is shown: one a part, or 64 over the range of the values.
export function binsOf({ low, high, colours }) {
  const bins = colours ? colours.length : 64;
  const [from, to] = colours ? [-0.5, bins - 0.5] : [low, high];
  const edge = (bin) => from + (bin * (to - from)) / bins;
  return { bins, low: from, high: to, edge };
}

// The colour of a value in what shownBy() returned.
export function valueColour({ colours, below, ...scale }, value) {
  if (Number.isNaN(value)) return unknownColour;
  if (colours) return colours[value];
  return below !== undefined && value < below ? belowColour : rampColour(scalePart(scale, value));
}
