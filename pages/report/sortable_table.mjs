// SPDX-License-Identifier: GPL-3.0-or-later
// Tables whose rows a click or the keyboard sorts by any column.

import { make } from '../common/elements.mjs';

// columns: { title, text(row), value(row), numeric, best, cell(row) }: text is what is shown; value is what is sorted
// by (text unless given); best marks the largest, all of equal text; cell makes the content where it is more than text.
// sort: { column, ascending } to begin with; sorted() receives it when it changes.
export function sortableTable(container, { caption, columns, rows, sort = null, sorted = () => {} }) {
  const best = columns.map((column) => (column.best ? bestText(column, rows) : null));
  const sortBy = (index) => {
    const ascending = sort && sort.column === index ? !sort.ascending : !columns[index].numeric;
    const next = { column: index, ascending };
    sortableTable(container, { caption, columns, rows, sort: next, sorted });
    sorted(next);
    container.querySelectorAll('th button')[index].focus();
  };
  const head = columns.map((column, index) => headCell(column, directionOf(sort, index), () => sortBy(index)));
  const body = sortedRows(rows, columns, sort).map((row) =>
    make('tr', {}, ...columns.map((column, index) => bodyCell(column, index, row, best[index]))));
  container.replaceChildren(make('table', {}, make('caption', {}, caption),
    make('thead', {}, make('tr', {}, ...head)), make('tbody', {}, ...body)));
}

// A table of the program's texts; the columns after the first text_columns have numbers.
export function textTable(container, { header, text_columns: words, rows }, caption = '') {
  const columns = header.map((title, position) => ({
    title, numeric: position >= words, text: (row) => row[position],
    value: (row) => (position < words ? row[position] : parseFloat(row[position].replace('<', ''))),
  }));
  sortableTable(container, { caption, columns, rows });
}

// The rows in the order of a column; equal ones stay in their order.
export function sortedRows(rows, columns, sort) {
  if (!sort) return rows;
  const value = columns[sort.column].value || columns[sort.column].text;
  return rows.slice().sort((a, b) => (sort.ascending ? 1 : -1) * compare(value(a), value(b)));
}

function compare(a, b) {
  return typeof a === 'number' ? a - b : String(a).localeCompare(String(b), 'en', { numeric: true });
}

// The text of the largest value; null of a single row.
export function bestText(column, rows) {
  if (rows.length < 2) return null;
  return column.text(rows.reduce((best, row) => (column.value(row) > column.value(best) ? row : best)));
}

function directionOf(sort, index) {
  if (!sort || sort.column !== index) return null;
  return sort.ascending ? 'ascending' : 'descending';
}

function headCell({ title, numeric }, direction, click) {
  const attributes = { type: 'button', class: title.length > 16 && 'long', click, title: `Sort by ${title}` };
  return make('th', { scope: 'col', class: numeric && 'number', 'aria-sort': direction },
    make('button', attributes, title));
}

function bodyCell(column, index, row, best) {
  const text = column.text(row);
  const content = column.cell ? column.cell(row) : text;
  if (index === 0) return make('th', { scope: 'row' }, content);
  return make('td', { class: `${column.numeric ? 'number' : ''}${text === best ? ' best' : ''}` }, content);
}
