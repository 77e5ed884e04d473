// SPDX-License-Identifier: GPL-3.0-or-later
// The share of the area at each value, in bins that can be brushed.

import { drawing, tickCount } from '../common/chart.mjs';
import { shortened } from '../common/words.mjs';

// Shares of the area in so many bins from low to high; values beyond are in the first and in the last.
export function binShares(values, weights, low, high, bins) {
  const shares = new Array(bins).fill(0);
  values.forEach((value, sample) => {
    if (Number.isNaN(value)) return;
    const bin = high > low ? Math.floor((bins * (value - low)) / (high - low)) : 0;
    shares[Math.max(0, Math.min(bins - 1, bin))] += weights[sample];
  });
  return shares;
}

// The bins after a key, [first, last]; null where it selects none, undefined where it does nothing.
export function selectionAfter(selected, { key, shiftKey }, bins) {
  if (key === 'Escape') return selected ? null : undefined;
  const step = { ArrowLeft: -1, ArrowRight: 1 }[key];
  if (!step) return undefined;
  const within = (bin) => Math.max(0, Math.min(bins - 1, bin));
  if (!selected) return step > 0 ? [0, 0] : [bins - 1, bins - 1];
  const [first, last] = selected;
  return shiftKey ? [first, Math.max(first, within(last + step))] : [within(first + step), within(first + step)];
}

// Draws the bars and axes. Returns the drawing, its bars and the scale of the values.
function drawBars(container, { shares, low, high, label, size, colourOf, ticks, title, mark }) {
  const bins = shares.length;
  const { svg, area, width, height } =
    drawing(container, { ...size, left: 72, right: 12, top: 8, bottom: 42, label });
  const x = d3.scaleLinear([low, high > low ? high : low + 1], [0, width]);
  const y = d3.scaleLinear([0, Math.max(...shares) || 1], [height, 0]).nice(3);
  y.domain([0, Math.min(1, y.domain()[1])]);
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(3).tickSize(-width).tickFormat(''));
  const bars = area.append('g').selectAll('rect').data(shares).enter().append('rect')
    .attr('x', (_, bin) => (width * bin) / bins).attr('width', Math.max(0.5, width / bins - 0.5))
    .attr('y', y).attr('height', (share) => height - y(share)).style('fill', (_, bin) => colourOf(bin));
  const axis = d3.axisBottom(x).ticks(tickCount(width));
  if (ticks) axis.tickValues(ticks).tickFormat((value) => String(value + 1));
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(axis);
  area.append('g').attr('class', 'axis').call(d3.axisLeft(y).ticks(3, '%'));
  area.append('text').attr('class', 'title').attr('x', width / 2).attr('y', height + 37).attr('text-anchor', 'middle')
    .text(shortened(title, width / 7));
  area.append('text').attr('transform', `translate(-60,${height / 2}) rotate(-90)`).attr('text-anchor', 'middle')
    .text('Share of the area');
  if (mark >= low && mark <= high) {
    area.append('line').attr('class', 'level threshold').attr('y1', 0).attr('y2', height)
      .attr('x1', x(mark)).attr('x2', x(mark));
  }
  return { svg, area, width, height, bars, x };
}

// Draws a histogram. chosen(first, last) receives the bins that are brushed, or nothing where none are. Returns what
// moves its marks from outside: mark(value) and select(first, last).
export function valueHistogram(container, options) {
  const { shares, chosen } = options;
  const { svg, area, width, height, bars, x } = drawBars(container, options);
  const bins = shares.length;
  const edge = (bin) => (width * bin) / bins;
  const marked = area.append('line').attr('class', 'level').attr('y1', 0).attr('y2', height).style('display', 'none');

  let selected = null;
  let moving = false; // the brush, by show()
  const brushed = area.append('g').attr('class', 'brush');
  const brush = d3.brushX().extent([[0, 0], [width, height]]);
  const show = (first, last) => {
    selected = first === undefined ? null : [first, last];
    bars.style('opacity', (_, bin) => (selected && (bin < first || bin > last) ? 0.25 : 1));
    moving = true;
    brushed.call(brush.move, selected && [edge(first), edge(last + 1)]);
    moving = false;
  };
  const choose = (...range) => {
    show(...range);
    chosen(...range);
  };
  const binAt = (at) => Math.max(0, Math.min(bins - 1, Math.floor((bins * at) / width)));
  brushed.call(brush.on('brush end', () => {
    const { type, selection, sourceEvent } = d3.event;
    if (moving || !sourceEvent) return;
    if (selection) {
      const range = [binAt(selection[0] + 0.01), binAt(selection[1] - 0.01)];
      if (type === 'end') choose(...range);
      else chosen(...range);
    } else if (type === 'end') { // a click
      const bin = binAt(d3.mouse(area.node())[0]);
      if (selected && selected[0] === bin && selected[1] === bin) choose();
      else choose(bin, bin);
    }
  }));
  svg.attr('tabindex', 0).on('keydown', () => {
    const range = selectionAfter(selected, d3.event, bins);
    if (range === undefined) return;
    d3.event.preventDefault();
    if (range === null) d3.event.stopPropagation(); // Escape would close a dialog, too
    choose(...(range || []));
  });
  return {
    select: show,
    mark(value) {
      const there = value !== null && !Number.isNaN(value);
      marked.style('display', there ? null : 'none');
      if (there) marked.attr('x1', x(value)).attr('x2', x(value));
    },
  };
}
