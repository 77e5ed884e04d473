// SPDX-License-Identifier: GPL-3.0-or-later
// Precision against recall, a curve a method.

import { drawing, tickCount } from '../common/chart.mjs';
import { byId, choice } from '../common/elements.mjs';
import { tipHead, tipLine, tooltip } from '../common/tooltip.mjs';
import { number } from '../common/words.mjs';
import { drawLegend } from './legend.mjs';
import { colourOf, dashesOf, signOf, swatch } from './method_look.mjs';
import { stamp, widthIn } from './section.mjs';
import { saveButton } from './svg_file.mjs';

// Where the axis of precision begins: at 0, or at the tenth below all that is shown.
export function lowestPrecision(curves, whole) {
  const lowest = Math.min(...curves.map((curve) => Math.min(...curve)));
  return whole || curves.length === 0 ? 0 : Math.min(0.9, Math.floor(10 * lowest) / 10);
}

// Returns what draws the section again.
export function showCurves(state) {
  let whole = true; // the axis of precision begins at 0
  const draw = () => drawCurves(state, whole);
  byId('curves-tools').append(choice('Precision', ['from 0', 'from the lowest shown'], 0, (index) => {
    whole = index === 0;
    draw();
  }));
  state.show(['protocol', 'average', 'hidden'], draw);
  return draw;
}

const curveOf = (state, index) => state.evaluationOf(index)[`${state.chosen.average}_curve`];

function drawCurves(state, whole) {
  const { evaluation: { recall, protocol }, visibleMethods, protocolWords, averageWords } = state;
  drawLegend(byId('curves-legend'), state);
  stamp('curves', [protocolWords, averageWords, 'fractions'],
    'Point at the chart, or use the arrow keys in it, to read values');
  const container = byId('curves-chart');
  const { svg, area, width, height } = drawing(container, {
    width: widthIn(container, 980), height: 470, left: 56, right: 16, top: 10, bottom: 44,
    label: `Precision-recall curves, ${protocolWords}, ${averageWords}`,
  });
  const x = d3.scaleLinear([0, 1], [0, width]);
  const lowest = lowestPrecision(visibleMethods.map((index) => curveOf(state, index)), whole);
  const y = d3.scaleLinear([lowest, 1], [height, 0]);
  drawAxes(area, x, y, width, height);
  for (const index of visibleMethods) {
    drawCurve(area, index, curveOf(state, index).map((precision, level) => [x(recall[level]), y(precision)]));
  }
  readValues(svg.node(), area, x, height, state);
  container.append(saveButton(svg.node(), `precision_recall_${protocol}_${state.chosen.average}`));
}

function drawAxes(area, x, y, width, height) {
  const below = `translate(0,${height})`;
  const besides = `translate(-42,${height / 2}) rotate(-90)`;
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(10).tickSize(-width).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', below).call(d3.axisBottom(x).ticks(tickCount(width)));
  area.append('g').attr('class', 'axis precision').call(d3.axisLeft(y).ticks(10));
  area.append('text').attr('x', width / 2).attr('y', height + 38).attr('text-anchor', 'middle').text('Recall');
  area.append('text').attr('transform', besides).attr('text-anchor', 'middle').text('Precision');
}

function drawCurve(area, index, points) {
  const group = area.append('g').attr('class', 'method').attr('data-method', index);
  group.append('path').attr('class', 'curve').attr('d', d3.line()(points))
    .style('stroke', colourOf(index)).style('stroke-dasharray', dashesOf(index));
  group.selectAll('.sign').data(points).enter().append('path').attr('class', 'sign')
    .attr('transform', (point) => `translate(${point})`).attr('d', signOf(index)).style('fill', colourOf(index));
}

// A rule at the level of recall nearest to the pointer, or moved by the arrow keys, with the values there.
function readValues(svg, area, x, height, state) {
  const { recall } = state.evaluation;
  const rule = area.append('line').attr('class', 'level').attr('y1', 0).attr('y2', height).style('display', 'none');
  let level = 0;
  const read = (left, top) => {
    rule.style('display', null).attr('x1', x(recall[level])).attr('x2', x(recall[level]));
    const value = (index) => curveOf(state, index)[level];
    const lines = state.visibleMethods.sort((a, b) => value(b) - value(a))
      .map((index) => tipLine([swatch(index), state.report.methods[index].name], value(index).toFixed(4)));
    tooltip.show(left, top, tipHead(`Recall ${number(recall[level])}`), ...lines);
  };
  const leave = () => {
    rule.style('display', 'none');
    tooltip.hide();
  };
  svg.addEventListener('pointermove', (event) => {
    const pointerX = d3.clientPoint(area.node(), event)[0];
    level = d3.scan(recall, (a, b) => Math.abs(x(a) - pointerX) - Math.abs(x(b) - pointerX));
    read(event.clientX, event.clientY);
  });
  svg.addEventListener('pointerleave', leave);
  svg.setAttribute('tabindex', 0);
  svg.addEventListener('blur', leave);
  svg.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === 'Escape') leave();
    if (!step) return;
    event.preventDefault();
    level = Math.max(0, Math.min(recall.length - 1, level + step));
    rule.style('display', null).attr('x1', x(recall[level])).attr('x2', x(recall[level]));
    const { left, top } = rule.node().getBoundingClientRect();
    read(left, top + 40);
  });
}
