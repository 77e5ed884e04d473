// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of all methods.

import { byId, make } from '../common/elements.mjs';
import { counted, percent } from '../common/words.mjs';
import { swatch } from './method_look.mjs';
import { stamp } from './section.mjs';
import { sortableTable } from './sortable_table.mjs';

export function showSummary(state) {
  let sort = null; // as the reader chose
  state.show(['protocol', 'average', 'method'], () => {
    const { report, evaluation, protocolWords, averageWords, methodIndices } = state;
    const failedNote = (index) => {
      const failed = report.methods[index].failures.length;
      const text = `${failed} of ${counted(report.ids.length, 'model')} failed`;
      return failed ? [' ', make('span', { class: 'interval' }, text)] : [];
    };
    const methodCell = (index) => {
      const { name, settings } = report.methods[index];
      const title = settings.map(([key, value]) => `${key}: ${value}`).join(', ');
      return make('span', { class: 'method-name', title: title || null }, swatch(index), name, ...failedNote(index));
    };
    const columns = [{ title: 'Method', text: (index) => report.methods[index].name, cell: methodCell }];
    const distances = [...new Set(report.methods.map(({ distance }) => distance))];
    if (distances.length > 1) {
      columns.push({ title: 'Distance', text: (index) => report.methods[index].distance });
    }
    evaluation.measures.forEach((measure, position) => {
      const value = (index) => state.evaluationOf(index)[state.chosen.average][position];
      const text = (index) => percent(value(index));
      const interval = (index) => intervalOf(state.evaluationOf(index), state.chosen.average, position);
      const cell = (index) => valueCell(text(index), interval(index));
      columns.push({ title: measure, numeric: true, best: true, value, text, cell });
    });
    const { intervals } = evaluation;
    const level = intervals && Math.round(1000 * intervals.confidence) / 10;
    const meaning = intervals ? [`Below each value stands its confidence interval (${level} %)`] : [];
    const sameDistance = distances.length === 1 && distances[0] ? [`distance ${distances[0]}`] : [];
    stamp('summary', [counted(evaluation.queries.length, 'query'), ...sameDistance, protocolWords, averageWords,
      'in percent'], 'The best of each column is bold', ...meaning);
    sortableTable(byId('summary-table'), {
      caption: `Retrieval measures, ${protocolWords}, ${averageWords}, percent`, columns, rows: methodIndices,
      sort, sorted: (chosen) => { sort = chosen; },
    });
  });
}

// The ends of a measure's confidence interval; null where there is none.
export function intervalOf({ intervals }, average, measure) {
  return intervals ? intervals[average][measure] : null;
}

function valueCell(text, interval) {
  if (!interval) return text;
  const [low, high] = interval.map((end) => (100 * end).toFixed(1));
  return make('span', {}, text, ' ', make('span', { class: 'interval' }, `${low}\u2013${high}`));
}
