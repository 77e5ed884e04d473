// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a multi-dataset experiment: methods by data sets, wins and losses, data sets.

import { byId, make } from '../common/elements.mjs';
import { counted, number, percent } from '../common/words.mjs';
import { swatch } from '../report/method_look.mjs';
import { stamp } from '../report/section.mjs';
import { sortableTable } from '../report/sortable_table.mjs';
import { contests } from './multi_dataset_state.mjs';

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const lettersCell = (letters) => make('span', { class: 'letters' }, letters);

export function showMethods(state) {
  let sort = null; // as the reader chose
  state.show(['protocol', 'average', 'measure'], () => {
    const { table, words, report: { datasets, methods } } = state;
    const nameCell = (index) => make('span', { class: 'method-name' }, swatch(index), methods[index].name);
    const columns = [{ title: 'Method', text: (index) => methods[index].name, cell: nameCell }];
    datasets.forEach(({ name }, set) => {
      const value = (index) => table.values[set][index];
      columns.push({ title: name, numeric: true, best: true, value,
        text: (index) => percent(value(index)) + deviationText(table, set, index) });
    });
    const average = (index) => mean(table.values.map((row) => row[index]));
    const letters = (index) => table.letters[table.order.indexOf(index)];
    columns.push({ title: 'Mean', numeric: true, best: true, value: average, text: (index) => percent(average(index)) },
      { title: 'Mean rank', numeric: true, value: (index) => -table.mean_ranks[index],
        text: (index) => table.mean_ranks[index].toFixed(2) },
      ...rankColumns(table),
      { title: 'Group', text: letters, cell: (index) => lettersCell(letters(index)) });
    stamp('table', [...words, 'in percent'], 'The best of each data set is bold',
      'Methods that share a letter do not differ significantly');
    sortableTable(byId('methods-table'), {
      caption: `${words.join(', ')}, percent`, columns, rows: table.order, sort, sorted: (chosen) => { sort = chosen; },
    });
  });
}

// The standard deviation over repetitions of a method.
export function deviationText({ deviations }, set, method) {
  const deviation = deviations.length ? deviations[set][method] : null;
  return deviation === null ? '' : ` \u00b1 ${percent(deviation)}`;
}

// The column of intervals of ranks, if there are any.
function rankColumns({ rank_intervals: intervals }) {
  if (!intervals.length) return [];
  const text = (index) => [...new Set(intervals[index])].join(' \u2013 ');
  return [{ title: 'Ranks', numeric: true, value: (index) => -intervals[index][1], text }];
}

export function showWins(state) {
  state.show(['protocol', 'average', 'measure'], () => {
    const { table, words, report: { methods } } = state;
    const cells = contests(table, methods.length);
    const columns = [{ title: 'Method', text: (row) => methods[row].name }];
    for (const index of table.order) {
      columns.push({
        title: methods[index].name, numeric: true, value: (row) => (cells[row][index] ? cells[row][index].wins : -1),
        text: (row) => (cells[row][index] ? cells[row][index].text : ''),
        cell: (row) => (cells[row][index] && cells[row][index].significant ?
          make('b', {}, cells[row][index].text) : (cells[row][index] || { text: '' }).text),
      });
    }
    stamp('wins', words, 'On how many data sets the method of the row is better, equal, worse',
      'Bold: significantly different mean ranks');
    sortableTable(byId('wins-table'), { caption: `Wins / ties / losses, ${words.join(', ')}`, columns,
      rows: table.order });
  });
}

export function drawDatasets({ datasets, failures }) {
  const nameCell = ({ name, page }) => (page ? make('a', { href: page }, name) : name);
  const columns = [{ title: 'Data set', text: ({ name }) => name, cell: nameCell },
    ...['models', 'queries'].map((key) => ({ title: key === 'models' ? 'Models' : 'Queries', numeric: true,
      value: (dataset) => dataset[key], text: (dataset) => number(dataset[key], 9) }))];
  stamp('datasets', [counted(datasets.length, 'data set')], 'A name leads to the report of the data set');
  sortableTable(byId('datasets-table'), { caption: 'Data sets', columns, rows: datasets });
  if (failures.length === 0) return;
  const container = make('div', { class: 'wide', id: 'failures-table' });
  sortableTable(container, { caption: 'Left out', rows: failures,
    columns: [{ title: 'Name', text: ([name]) => name }, { title: 'Reason', text: ([, reason]) => reason }] });
  byId('failures').append(make('h3', {}, 'Left out'),
    make('p', {}, 'These could not be used; all figures are without them.'), container);
}
