// SPDX-License-Identifier: GPL-3.0-or-later
// The distance matrix of a method as a picture, its rows and columns ordered by class.

import { colourScale } from '../common/chart.mjs';
import { ramp, unknownColour } from '../common/constants.mjs';
import { byId, make } from '../common/elements.mjs';
import { scaledNumbers } from '../common/packed.mjs';
import { tipHead, tooltip } from '../common/tooltip.mjs';
import { number } from '../common/words.mjs';
import { stamp } from './section.mjs';
import { picture } from './shape_buttons.mjs';

// The models in the order of their classes, as rows of the heat map.
export const classOrder = ({ labels }) =>
  labels.map((_, model) => model).sort((a, b) => labels[a] - labels[b] || a - b);

export function showHeatMap(state) {
  const order = classOrder(state.report);
  state.show(['method'], () => drawHeatMap(state, order));
}

// The cells row by row; of a symmetric picture the data have one half.
export function cellsOf({ side, symmetric, ...packed }) {
  const numbers = scaledNumbers(packed);
  if (!symmetric) return numbers;
  const cells = new Float64Array(side * side);
  let next = 0;
  for (let row = 0; row < side; ++row) {
    for (let column = row; column < side; ++column) {
      cells[row * side + column] = cells[column * side + row] = numbers[next++];
    }
  }
  return cells;
}

// The value at a part of the finite cells in ascending order, or 1.
export function quantileOf(cells, part) {
  const finite = cells.filter(Number.isFinite).sort();
  return finite[Math.floor(part * (finite.length - 1))] || 1;
}

// The positions along the rows (0 to 1) for the names of the classes; where they are too close, every so many.
export function namePositions(order, labels) {
  const positions = [];
  let last = -1;
  for (let begin = 0; begin < order.length;) {
    const label = labels[order[begin]];
    let end = begin;
    while (end < order.length && labels[order[end]] === label) ++end;
    const middle = (begin + end) / 2 / order.length;
    if (middle - last > 0.018) {
      positions.push({ label, middle });
      last = middle;
    }
    begin = end;
  }
  return positions;
}

function drawHeatMap(state, order) {
  const { report, method: { heat_map: map, name } } = state;
  const cells = cellsOf(map);
  const largest = quantileOf(cells, 0.99);
  const means = map.block > 1 ? [`each cell the mean over ${map.block} by ${map.block} models`] : [];
  stamp('distances', [name, 'rows are queries', 'rows and columns in the order of the classes', ...means],
    'Point at a cell, or move with the arrow keys, to see the pair; click for the query');
  const label = `Distance matrix of ${name}, ordered by class`;
  const canvas = make('canvas', { role: 'img', tabindex: 0, 'aria-label': label });
  paint(canvas, cells, map.side, largest);
  readCells(canvas, cells, map, state, order);
  const names = namePositions(order, report.labels).map(({ label: at, middle }) =>
    make('span', { style: `top:${100 * middle}%` }, report.classes[at]));
  byId('distances-chart').replaceChildren(
    make('div', { class: 'heat' }, make('div', { class: 'names', 'aria-hidden': 'true' }, ...names), canvas),
    colourScale('Distance; the largest hundredth in the last colour', { from: 0, to: largest }));
}

function paint(canvas, cells, side, largest) {
  const channels = (text) => {
    const { r, g, b } = d3.rgb(text);
    return [r, g, b, 255];
  };
  const colours = ramp.map(channels);
  const unknown = channels(unknownColour);
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  const image = context.createImageData(side, side);
  cells.forEach((value, index) => {
    const known = Number.isFinite(value);
    image.data.set(known ? colours[Math.min(255, Math.round((255 * value) / largest))] : unknown, 4 * index);
  });
  context.putImageData(image, 0, 0);
}

// What a tooltip says of a cell.
function describeCell(state, rows, columns, value) {
  const { report } = state;
  const words = ([first, ...more]) => {
    const text = `${report.ids[first]} (${state.className(first)})`;
    return more.length > 0 ? `${text} and ${more.length} more` : text;
  };
  const children = [tipHead(number(Number.isFinite(value) ? value : null)),
    make('div', {}, `query ${words(rows)}`), make('div', {}, `model ${words(columns)}`)];
  if (rows.length === 1 && columns.length === 1 && report.pictures) {
    children.push(make('div', { class: 'pair' }, picture(report, rows[0], 90), picture(report, columns[0], 90)));
  }
  return children;
}

function readCells(canvas, cells, { side, block }, state, order) {
  let row = 0;
  let column = 0;
  const within = (cell) => Math.max(0, Math.min(side - 1, cell));
  const models = (cell) => order.slice(cell * block, (cell + 1) * block);
  const read = (x, y) =>
    tooltip.show(x, y, ...describeCell(state, models(row), models(column), cells[row * side + column]));
  const moveTo = (event) => {
    const box = canvas.getBoundingClientRect();
    column = within(Math.floor(((event.clientX - box.left) / box.width) * side));
    row = within(Math.floor(((event.clientY - box.top) / box.height) * side));
  };
  canvas.addEventListener('pointermove', (event) => {
    moveTo(event);
    read(event.clientX, event.clientY);
  });
  canvas.addEventListener('pointerleave', tooltip.hide);
  canvas.addEventListener('blur', tooltip.hide);
  canvas.addEventListener('click', (event) => {
    moveTo(event);
    state.openShape(models(row)[0]);
  });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
    if (event.key === 'Enter') state.openShape(models(row)[0]);
    if (!step) return;
    event.preventDefault();
    row = within(row + step[0]);
    column = within(column + step[1]);
    const box = canvas.getBoundingClientRect();
    read(box.left + ((column + 0.5) / side) * box.width, box.top + ((row + 0.5) / side) * box.height);
  });
}
