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
    const methodCell = (index) => {
      const { name, description } = report.methods[index];
      return make('span', { title: description || null }, swatch(index), name);
    };
    const columns = [{ title: 'Method', text: (index) => report.methods[index].name, cell: methodCell }];
    evaluation.measures.forEach((measure, position) => {
      const value = (index) => state.evaluationOf(index)[state.chosen.average][position];
      columns.push({ title: measure, numeric: true, best: true, value, text: (index) => percent(value(index)) });
    });
    stamp('summary', [counted(evaluation.queries.length, 'query'), protocolWords, averageWords, 'in percent'],
      'The best of each column is bold');
    sortableTable(byId('summary-table'), {
      caption: `Retrieval measures, ${protocolWords}, ${averageWords}, percent`, columns, rows: methodIndices,
      sort, sorted: (chosen) => { sort = chosen; },
    });
  });
}
