// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts a table of the page by a column when its head is clicked, or Enter is pressed on it.

/** The number that a cell begins with, or NaN: "97.93 [95.17, 99.52]" is 97.93. */
const numberOf = (cell) => Number.parseFloat(cell.textContent.replace(/,/g, '').replace(/−/g, '-'));

const compare = (one, other) => {
  const numbers = [numberOf(one), numberOf(other)];
  if (numbers.every((number) => !Number.isNaN(number))) return numbers[0] - numbers[1];
  return one.textContent.localeCompare(other.textContent);
};

const sortBy = (table, head) => {
  const column = head.cellIndex;
  const descending = head.getAttribute('aria-sort') === 'ascending';
  for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
  const rows = [...table.tBodies[0].rows];
  rows.sort((one, other) => compare(one.cells[column], other.cells[column]) * (descending ? -1 : 1));
  table.tBodies[0].append(...rows);
};

for (const table of document.querySelectorAll('article table')) {
  if (!table.tHead || table.tBodies[0].rows.length < 3) continue;
  for (const head of table.tHead.rows[0].cells) {
    head.tabIndex = 0;
    head.classList.add('sortable');
    head.addEventListener('click', () => sortBy(table, head));
    head.addEventListener('keydown', (event) => event.key === 'Enter' && sortBy(table, head));
  }
}
