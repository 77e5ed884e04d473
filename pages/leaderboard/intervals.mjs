// SPDX-License-Identifier: GPL-3.0-or-later
// Averages with their intervals, and groups of methods that do not differ.

import { drawing, tickCount } from '../common/chart.mjs';
import { byId } from '../common/elements.mjs';
import { tipHead, tipLine, tooltip } from '../common/tooltip.mjs';
import { percent, shortened } from '../common/words.mjs';
import { colourOf, signOf } from '../report/method_look.mjs';
import { stamp, widthIn } from '../report/section.mjs';
import { saveButton } from '../report/svg_file.mjs';
import { groupsOf, letterOf } from './leaderboard_state.mjs';

const step = 24; // height of a row
const column = 18; // width of a group

// Returns what draws the section again.
export function showIntervals(state) {
  const draw = () => drawIntervals(state);
  state.show(['measure', 'average'], draw);
  return draw;
}

function drawIntervals(state) {
  const { ranking, standings, measure, protocolWords, averageWords } = state;
  const groups = groupsOf(ranking.map((index) => standings[index].ranks[1]));
  stamp('intervals', [`averages of ${measure}`, protocolWords, averageWords, 'in percent'],
    'Methods beside one bar do not differ significantly');
  const container = byId('intervals-chart');
  const whole = widthIn(container, 1000);
  const left = Math.min(240, 0.4 * whole); // for names
  const { svg, area, width, height } = drawing(container, {
    width: whole, height: ranking.length * step + 74, left, right: 24 + column * groups.length, top: 30,
    bottom: 44, label: `${measure} with intervals and groups, ${protocolWords}, ${averageWords}`,
  });
  const ends = ranking.flatMap((index) => [standings[index].average, ...(standings[index].interval || [])]);
  const x = d3.scaleLinear(d3.extent(ends.map((end) => 100 * end)), [8, width - 8]).nice();
  const below = `translate(0,${height})`;
  area.append('g').attr('class', 'grid').attr('transform', below)
    .call(d3.axisBottom(x).ticks(tickCount(width)).tickSize(-height).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', below).call(d3.axisBottom(x).ticks(tickCount(width)));
  area.append('text').attr('x', width / 2).attr('y', height + 36).attr('text-anchor', 'middle')
    .text(`${measure} (percent)`);
  ranking.forEach((index, position) => drawRow(area, state, { index, position, x, left, width }));
  const named = (number) => (state.chosen.average === 'macro' ? letterOf(number).toUpperCase() : letterOf(number));
  groups.forEach((group, number) =>
    drawGroup(area, group, { lineX: width + 18 + number * column, name: named(number) }));
  container.append(saveButton(svg.node(), `intervals_${measure}_${state.chosen.average}`));
}

function drawRow(area, state, { index, position, x, left, width }) {
  const { average, rank, interval } = state.standings[index];
  const { name } = state.report.methods[index];
  const row = area.append('g').attr('class', 'interval-row').attr('data-method', index)
    .attr('transform', `translate(0,${(position + 0.5) * step})`);
  row.append('rect').attr('class', 'row-ground').attr('x', -left).attr('y', -step / 2).attr('width', width + left)
    .attr('height', step);
  row.append('text').attr('x', -8).attr('dy', '0.32em').attr('text-anchor', 'end')
    .text(`${rank}. ${shortened(name, Math.floor(left / 7) - 3)}`);
  if (interval) {
    row.append('line').attr('class', 'whisker').attr('x1', x(100 * interval[0])).attr('x2', x(100 * interval[1]))
      .style('stroke', colourOf(index));
  }
  row.append('path').attr('class', 'sign').attr('transform', `translate(${x(100 * average)},0)`)
    .attr('d', signOf(index)).style('fill', colourOf(index));
  const lines = [tipLine([state.measure], percent(average)),
    ...(interval ? [tipLine(['Interval'], interval.map(percent).join(' \u2013 '))] : [])];
  row.on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY, tipHead(name), ...lines));
  row.on('pointerleave', tooltip.hide);
}

function drawGroup(area, { first, last }, { lineX, name }) {
  area.append('line').attr('class', 'group').attr('x1', lineX).attr('x2', lineX)
    .attr('y1', first * step + 6).attr('y2', (last + 1) * step - 6);
  area.append('text').attr('x', lineX).attr('y', -8).attr('text-anchor', 'middle').text(name);
}
