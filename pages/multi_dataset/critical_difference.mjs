// SPDX-License-Identifier: GPL-3.0-or-later
// The diagram of critical differences (Demsar 2006): methods on a ruler of mean ranks, bars over those that do not
// differ significantly.

import { drawing } from '../common/chart.mjs';
import { byId } from '../common/elements.mjs';
import { number, shortened } from '../common/words.mjs';
import { colourOf, signOf } from '../report/method_look.mjs';
import { stamp, widthIn } from '../report/section.mjs';
import { saveButton } from '../report/svg_file.mjs';

const step = 24; // from name to name
const bar = 9; // from bar to bar
const mostLetters = 26; // of a name

// The width for names on either side, and how many letters fit, in a drawing of that width.
export function nameSpace(whole) {
  const side = Math.min(240, 0.35 * whole);
  return { side, letters: Math.min(mostLetters, Math.floor((side - 14) / 6.6) - 6) };
}

// Where the names stand: the better half on the left, the others on the right, the outermost at the bottom of each.
export function nameSlots(count) {
  const half = Math.ceil(count / 2);
  return Array.from({ length: count }, (_, position) => (position < half ?
    { left: true, line: position } : { left: false, line: count - 1 - position }));
}

// Returns what draws the section again.
export function showCriticalDifference(state) {
  const draw = () => drawCriticalDifference(state);
  state.show(['protocol', 'average', 'measure'], draw);
  return draw;
}

function drawCriticalDifference(state) {
  const { table, words, report: { methods } } = state;
  stamp('difference', words, table.words, 'A bar joins methods that do not differ significantly');
  const bars = table.groups.filter(([first, last]) => last > first);
  const names = Math.ceil(methods.length / 2);
  const container = byId('difference-chart');
  const whole = widthIn(container, 1000);
  const { side, letters } = nameSpace(whole);
  const { svg, area, width } = drawing(container, {
    width: whole, height: 92 + bars.length * bar + names * step, left: side, right: side, top: 58,
    bottom: 10, label: `Critical difference of mean ranks, ${words.join(', ')}`,
  });
  const x = d3.scaleLinear([1, Math.max(2, methods.length)], [0, width]);
  drawRuler(area, x, table, methods.length);
  bars.forEach(([first, last], line) => drawBar(area, x, table, { first, last }, 14 + line * bar));
  const below = 26 + bars.length * bar;
  const space = { below, width, letters };
  nameSlots(methods.length).forEach((at, position) => drawName(area, x, state, { ...at, ...space, position }));
  container.append(saveButton(svg.node(), `critical_difference_${state.measure}`));
}

// The scale of ranks, and above it the length of the critical difference.
function drawRuler(area, x, { critical_difference: difference }, count) {
  area.append('g').attr('class', 'axis').call(d3.axisTop(x).ticks(Math.min(count, 12)).tickFormat(d3.format('d')));
  area.append('text').attr('x', x(1) - 10).attr('dy', '-0.6em').attr('text-anchor', 'end').text('Mean rank');
  const end = 1 + difference;
  if (difference === null || end > x.domain()[1]) return;
  const line = (x1, x2, y1, y2) => area.append('line').attr('class', 'ruler').attr('x1', x1).attr('x2', x2)
    .attr('y1', y1).attr('y2', y2);
  line(x(1), x(end), -36, -36);
  for (const at of [x(1), x(end)]) line(at, at, -40, -32);
  area.append('text').attr('x', (x(1) + x(end)) / 2).attr('y', -42).attr('text-anchor', 'middle')
    .text(`CD = ${number(difference, 3)}`);
}

function drawBar(area, x, { order, mean_ranks: ranks }, { first, last }, height) {
  area.append('line').attr('class', 'clique').attr('x1', x(ranks[order[first]]) - 3)
    .attr('x2', x(ranks[order[last]]) + 3).attr('y1', height).attr('y2', height);
}

function drawName(area, x, { table, report }, { left, line, position, below, width, letters }) {
  const method = table.order[position];
  const rank = table.mean_ranks[method];
  const height = below + (line + 0.5) * step;
  const edge = left ? -8 : width + 8;
  const group = area.append('g').attr('class', 'method').attr('data-method', method);
  group.append('path').attr('class', 'leader').attr('d', `M${x(rank)},0V${height}H${edge}`);
  group.append('path').attr('class', 'sign').attr('transform', `translate(${x(rank)},0)`).attr('d', signOf(method))
    .style('fill', colourOf(method));
  const name = shortened(report.methods[method].name, letters);
  group.append('text').attr('x', edge + (left ? -6 : 6)).attr('y', height).attr('dy', '0.32em')
    .attr('text-anchor', left ? 'end' : 'start')
    .text((left ? [name, number(rank, 3)] : [number(rank, 3), name]).join('  '));
}
