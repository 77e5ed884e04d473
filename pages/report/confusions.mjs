// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest neighbours class by class: which classes are confused with which.

import { drawing } from '../common/chart.mjs';
import { byId, make } from '../common/elements.mjs';
import { tipHead, tooltip } from '../common/tooltip.mjs';
import { counted, percent, shortened } from '../common/words.mjs';
import { stamp } from './section.mjs';
import { sortableTable } from './sortable_table.mjs';
import { saveButton } from './svg_file.mjs';

const mostClassesInGrid = 120;
const mostConfusionsInTable = 15;

export function showConfusions(state) {
  state.show(['method'], () => drawConfusions(state));
}

// The numbers of queries by class, and the confusions, most frequent first. confusion: by class, pairs of the nearest
// neighbour's class and the number of queries.
export function countConfusions(confusion) {
  const totals = confusion.map((row) => row.reduce((sum, [, count]) => sum + count, 0));
  const wrong = confusion.flatMap((row, label) => row.filter(([other]) => other !== label)
    .map(([other, count]) => ({ label, other, count, part: count / totals[label] })));
  wrong.sort((a, b) => b.count - a.count || a.label - b.label || a.other - b.other);
  return { totals, wrong };
}

function drawConfusions({ report: { classes }, method: { confusion, name } }) {
  stamp('confusions',
    [name, 'number of queries of the class of a row whose nearest neighbour is of the class of a column']);
  const { totals, wrong } = countConfusions(confusion);
  const container = byId('confusions-chart');
  if (classes.length > mostClassesInGrid) {
    container.replaceChildren(make('p', {}, `The grid is left out for more than ${mostClassesInGrid} classes.`));
  } else {
    drawGrid(container, { confusion, totals, classes, name });
  }
  drawTable(byId('confusions-table'), wrong, classes);
}

function drawTable(container, wrong, classes) {
  if (wrong.length === 0) {
    container.replaceChildren(make('p', {}, 'Every query\u2019s nearest neighbour is of its own class.'));
    return;
  }
  const columns = [
    { title: 'Class', text: ({ label }) => classes[label] },
    { title: 'Taken for', text: ({ other }) => classes[other] },
    { title: 'Queries', numeric: true, value: ({ count }) => count, text: ({ count }) => String(count) },
    { title: 'Percent of class', numeric: true, value: ({ part }) => part, text: ({ part }) => percent(part) },
  ];
  const caption = wrong.length > mostConfusionsInTable
    ? `The ${mostConfusionsInTable} most frequent of ${wrong.length} confusions` : counted(wrong.length, 'confusion');
  sortableTable(container, { caption, columns, rows: wrong.slice(0, mostConfusionsInTable) });
}

function drawGrid(container, { confusion, totals, classes, name }) {
  const count = classes.length;
  const cell = Math.max(9, Math.min(26, Math.floor(560 / count)));
  const labelled = cell >= 11;
  const longest = Math.max(...classes.map((text) => text.length));
  const margin = labelled ? 8 + 6.4 * Math.min(18, longest) : 10;
  const { svg, area } = drawing(container, {
    width: margin + count * cell + margin / 2, height: margin + count * cell + 4,
    left: margin, right: margin / 2, top: margin, bottom: 4, label: `Confusion matrix of ${name}`,
  });
  confusion.forEach((row, label) => {
    area.append('rect').attr('x', 0).attr('y', label * cell).attr('width', count * cell).attr('height', cell - 1)
      .style('fill', 'var(--raised)');
    for (const [other, queries] of row) {
      const words = [tipHead(`${classes[label]} \u2192 ${classes[other]}`),
        make('div', {}, `${queries} of ${totals[label]} queries, ${percent(queries / totals[label])} %`)];
      drawCell(area, { x: other * cell, y: label * cell, cell, queries, part: queries / totals[label], words });
    }
    if (labelled) drawNames(area, shortened(classes[label], 18), (label + 0.5) * cell);
  });
  container.append(saveButton(svg.node(), 'confusions'));
}

function drawCell(area, { x, y, cell, queries, part, words }) {
  area.append('rect').attr('x', x).attr('y', y).attr('width', cell - 1).attr('height', cell - 1)
    .style('fill', `rgba(var(--accent-channels), ${0.15 + 0.85 * part})`)
    .on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY, ...words))
    .on('pointerleave', tooltip.hide);
  if (cell < 16) return;
  area.append('text').attr('x', x + 0.5 * cell).attr('y', y + 0.5 * cell).attr('dy', '0.35em')
    .attr('text-anchor', 'middle').style('pointer-events', 'none').style('font-size', '11px')
    .style('fill', part > 0.75 ? 'var(--paper)' : null).text(queries);
}

// The name of a class next to its row and above its column.
function drawNames(area, name, middle) {
  const words = () => area.append('text').attr('dy', '0.35em').style('font-size', '11px').text(name);
  words().attr('x', -6).attr('y', middle).attr('text-anchor', 'end');
  words().attr('transform', `translate(${middle},-6) rotate(-60)`);
}
