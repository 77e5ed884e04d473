// SPDX-License-Identifier: GPL-3.0-or-later
// A measure class by class: bars, or cells for many methods, and the same as a table.

import { drawing, tickCount } from '../common/chart.mjs';
import { methodColours } from '../common/constants.mjs';
import { byId, choice } from '../common/elements.mjs';
import { tipHead, tipLine, tooltip } from '../common/tooltip.mjs';
import { percent, shortened } from '../common/words.mjs';
import { drawLegend } from './legend.mjs';
import { colourOf, swatch } from './method_look.mjs';
import { stamp, widthIn } from './section.mjs';
import { sortableTable } from './sortable_table.mjs';
import { saveButton } from './svg_file.mjs';

const orders = ['as in the data set', 'lowest first', 'highest first'];
const left = 170; // for the names of the classes

// Returns what draws the section again.
export function showClasses(state) {
  let order = 0;
  const draw = () => drawClasses(state, order);
  byId('classes-tools').append(choice('Order', orders, order, (index) => {
    order = index;
    draw();
  }));
  state.show(['protocol', 'hidden', 'measure', 'method'], draw);
  return draw;
}

const classValue = (state, index, position) => state.evaluationOf(index).per_class[position][state.chosen.measure];

// Positions of classes, in one of the orders by their values.
export function orderedClasses(values, order) {
  const positions = values.map((_, position) => position);
  if (order > 0) positions.sort((a, b) => (order === 1 ? 1 : -1) * (values[a] - values[b]));
  return positions;
}

function drawClasses(state, order) {
  const { report, evaluation, visibleMethods, classWords, chosen } = state;
  const measure = evaluation.measures[chosen.measure];
  const crowded = visibleMethods.length > methodColours;
  drawLegend(byId('classes-legend'), state);
  stamp('classes', [`${measure} of each class`, ...classWords, 'in percent'],
    `Classes ${orders[order]}${order > 0 ? ` by ${state.method.name}` : ''}`,
    ...(crowded ? ['The fuller the colour, the higher the value'] : []));
  const chart = {
    state, measure,
    rows: orderedClasses(evaluation.per_class.map((values) => values[chosen.measure]), order),
    names: evaluation.classes.map((label) => report.classes[label]),
    label: `${measure} by class, ${classWords[0]}`,
  };
  const container = byId('classes-chart');
  const svg = crowded ? drawCells(container, chart) : drawBars(container, chart);
  container.append(saveButton(svg.node(), `classes_${measure}_${evaluation.protocol}`));
  drawClassTable(chart);
}

// A row of a chart, with what its drawings share: a ground, the class' name, all values where the pointer is.
function classRow(area, position, { state, measure, names }, { top, width, height }) {
  const group = area.append('g').attr('class', 'bar-row').attr('transform', `translate(0,${top})`);
  group.append('rect').attr('class', 'bar-ground').attr('x', -left).attr('width', width + left).attr('height', height);
  group.append('text').attr('x', -8).attr('y', height / 2).attr('dy', '0.32em').attr('text-anchor', 'end')
    .text(shortened(names[position], 26));
  const line = (index) =>
    tipLine([swatch(index), state.report.methods[index].name], percent(classValue(state, index, position)));
  group.on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY,
    tipHead(`${names[position]}: ${measure}`), ...state.visibleMethods.map(line)));
  group.on('pointerleave', tooltip.hide);
  return group;
}

// For no more methods than there are colours.
function drawBars(container, chart) {
  const { state, measure, rows, label } = chart;
  const shown = state.visibleMethods;
  const bar = shown.length > 3 ? 6 : 9;
  const step = Math.max(16, bar * shown.length + 8);
  const { svg, area, width, height } = drawing(container, {
    width: widthIn(container, 1000), height: rows.length * step + 46, left, right: 20, top: 6, bottom: 40, label,
  });
  const x = d3.scaleLinear([0, 100 * state.highest], [0, width]);
  const below = `translate(0,${height})`;
  area.append('g').attr('class', 'grid').attr('transform', below)
    .call(d3.axisBottom(x).ticks(tickCount(width)).tickSize(-height).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', below).call(d3.axisBottom(x).ticks(tickCount(width)));
  area.append('text').attr('x', width / 2).attr('y', height + 34).attr('text-anchor', 'middle')
    .text(`${measure} (percent)`);
  rows.forEach((position, row) => {
    const group = classRow(area, position, chart, { top: row * step, width, height: step });
    const first = (step - bar * shown.length) / 2;
    shown.forEach((index, rank) => {
      group.append('rect').attr('data-method', index).attr('y', first + rank * bar).attr('height', bar - 1)
        .attr('width', x(100 * classValue(state, index, position)) || 0).style('fill', colourOf(index));
    });
  });
  return svg;
}

// For more: one row per class, one column per method, the values in colour from the lowest shown to the highest.
function drawCells(container, chart) {
  const { state, rows, label } = chart;
  const shown = state.visibleMethods;
  const step = 21;
  const names = shown.map((index) => shortened(state.report.methods[index].name, 30));
  const space = 16 + 6.6 * Math.max(...names.map((name) => name.length));
  const { svg, area, width } = drawing(container, {
    width: widthIn(container, 1110), height: rows.length * step + 0.87 * space + 4, left,
    right: Math.min(100, 0.5 * space), top: 0.87 * space, bottom: 4, label,
  });
  const cell = Math.min(64, width / shown.length);
  const digits = [42, 35, 22].findIndex((needed) => cell >= needed);
  const values = shown.map((index) => rows.map((position) => classValue(state, index, position)));
  const [lowest, highest] = d3.extent(values.flat()); // without NaN
  shown.forEach((index, column) => {
    area.append('text').attr('data-method', index)
      .attr('transform', `translate(${(column + 0.5) * cell},-8) rotate(-60)`).text(names[column]);
  });
  rows.forEach((position, row) => {
    const group = classRow(area, position, chart, { top: row * step, width: cell * shown.length, height: step });
    shown.forEach((index, column) => {
      const value = values[column][row];
      const part = highest > lowest ? (value - lowest) / (highest - lowest) : 1;
      group.append('rect').attr('class', 'cell').attr('data-method', index).attr('x', column * cell)
        .attr('width', cell - 1).attr('height', step - 1)
        .style('fill', `rgba(var(--accent-channels), ${0.05 + 0.5 * part})`);
      if (digits < 0) return;
      group.append('text').attr('data-method', index).attr('x', (column + 0.5) * cell).attr('y', step / 2)
        .attr('dy', '0.32em').attr('text-anchor', 'middle').style('font-size', '11px')
        .text((100 * value).toFixed(2 - digits));
    });
  });
  return svg;
}

function drawClassTable({ state, measure, rows, names }) {
  const { report, evaluation } = state;
  const models = (position) => report.labels.filter((label) => label === evaluation.classes[position]).length;
  const columns = [{ title: 'Class', text: (position) => names[position] },
    { title: 'Models', numeric: true, value: models, text: (position) => String(models(position)) }];
  report.methods.forEach(({ name }, index) => {
    const value = (position) => classValue(state, index, position);
    columns.push({ title: name, numeric: true, value, text: (position) => percent(value(position)) });
  });
  const caption = `${measure} by class, ${state.classWords[0]}, percent`;
  sortableTable(byId('classes-table'), { caption, columns, rows });
}
