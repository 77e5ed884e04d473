// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a leaderboard.

import { byId, make } from '../common/elements.mjs';
import { saveFile } from '../common/save.mjs';
import { counted, ended, percent } from '../common/words.mjs';
import { swatch } from '../report/method_look.mjs';
import { stamp } from '../report/section.mjs';
import { sortableTable } from '../report/sortable_table.mjs';

const intervalText = ({ interval }) => (interval ? interval.map(percent).join(' \u2013 ') : '');
const ranksText = ({ ranks: [best, worst] }) => (best === worst ? String(best) : `${best} \u2013 ${worst}`);

const unbroken = (text) => make('span', { class: 'unbroken' }, text);
const lettersCell = (letters) => make('span', { class: 'letters' }, letters);

export function showStandings(state) {
  let sort = { column: 0, ascending: true }; // as the reader chose
  state.show(['measure', 'average'], () => {
    const { measure, protocolWords, averageWords, standings, report, evaluation } = state;
    stamp('standings', [`by ${measure}`, counted(evaluation.queries, 'query'), protocolWords, averageWords,
      'in percent'], 'The best of each column is bold', report.significance);
    const rank = (index) => standings[index].rank;
    const columns = [
      { title: 'Rank', numeric: true, value: rank, text: (index) => String(rank(index)) },
      { title: 'Method', text: (index) => report.methods[index].name, cell: (index) => methodCell(index, report) },
      ...measureColumns(state),
      { title: 'Interval', numeric: true, value: (index) => standings[index].average,
        text: (index) => intervalText(standings[index]), cell: (index) => unbroken(intervalText(standings[index])) },
      { title: 'Ranks possible', text: (index) => ranksText(standings[index]), value: rank, numeric: true },
      { title: 'Group', text: (index) => state.lettersOf(index), cell: (index) => lettersCell(state.lettersOf(index)),
        value: rank },
    ];
    sortableTable(byId('standings-table'), {
      caption: `Methods by ${measure}, ${protocolWords}, ${averageWords}, percent`, columns, rows: state.methodIndices,
      sort, sorted: (chosen) => { sort = chosen; },
    });
  });
}

function measureColumns(state) {
  return state.evaluation.measures.map((measure, position) => {
    const value = (index) => state.standingsOf(position)[index].average;
    const text = (index) => percent(value(index)) + deviationText(state, index, position);
    return { title: measure, numeric: true, best: true, value, text };
  });
}

// The standard deviation over repetitions of the method.
export function deviationText({ report, chosen: { average } }, method, measure) {
  const deviations = report.methods[method].deviations[average];
  return deviations.length ? ` \u00b1 ${percent(deviations[measure])}` : '';
}

// The name, which leads to the method's own page, with its authors and the paper below.
function methodCell(index, report) {
  const { name, authors, paper, url, page } = report.methods[index];
  const title = page ? make('a', { href: page }, name) : name;
  const source = url ? make('a', { href: url, rel: 'noopener' }, paper || url) : paper;
  const parts = [authors, source].filter((part) => part);
  const words = parts.length > 1 ? [`${ended(authors)} `, source] : parts;
  const about = parts.length ? make('span', { class: 'about' }, ...words) : null;
  return make('div', { class: 'method-name' }, swatch(index), title, about);
}

export function showDownloads({ downloads }, name) {
  const button = (text, extension, type, content) =>
    make('button', { type: 'button', click: () => saveFile(`${name}.${extension}`, type, content) }, text);
  byId('downloads').append(button('Download CSV', 'csv', 'text/csv', downloads.csv),
    button('Download LaTeX', 'tex', 'application/x-tex', downloads.latex));
}
