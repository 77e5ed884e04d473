// Tables whose rows a click or the keyboard sorts by any column.

// columns: { title, text(row), value(row), numeric, best, cell(row) }: text is what is shown; value is what is sorted by
// (text unless given); best marks the largest, all of equal text; cell makes the content where it is more than text.
function sortableTable(place, { caption, columns, rows, sort = null, sorted = () => {} }) {
  const order = rows.slice();
  if (sort) {
    const value = columns[sort.column].value || columns[sort.column].text;
    order.sort((a, b) => (sort.ascending ? 1 : -1) * compare(value(a), value(b)));
  }
  const head = make('tr', {}, ...columns.map((column, index) => headCell(column, index)));
  const body = make('tbody', {}, ...order.map((row) => make('tr', {}, ...columns.map((column, index) => bodyCell(column, index, row)))));
  place.replaceChildren(make('table', {}, make('caption', {}, caption), make('thead', {}, head), body));

  function headCell(column, index) {
    const current = sort && sort.column === index;
    const toggle = () => {
      const ascending = current ? !sort.ascending : !column.numeric;
      sortableTable(place, { caption, columns, rows, sort: { column: index, ascending }, sorted });
      sorted({ column: index, ascending });
      place.querySelectorAll('th button')[index].focus();
    };
    return make('th', { scope: 'col', class: column.numeric && 'number', 'aria-sort': current ? (sort.ascending ? 'ascending' : 'descending') : null },
      make('button', { type: 'button', class: column.title.length > 16 && 'long', click: toggle, title: `Sort by ${column.title}` }, column.title));
  }

  function bodyCell(column, index, row) {
    const best = column.best && column.text(row) === bestText(column);
    const content = column.cell ? column.cell(row) : column.text(row);
    return index === 0 ? make('th', { scope: 'row' }, content)
      : make('td', { class: `${column.numeric ? 'number' : ''}${best ? ' best' : ''}` }, content);
  }

  function bestText(column) {
    if (rows.length < 2) return null;
    return column.text(rows.reduce((best, row) => (column.value(row) > column.value(best) ? row : best)));
  }
}

function compare(a, b) {
  return typeof a === 'number' ? a - b : String(a).localeCompare(String(b), 'en', { numeric: true });
}

function drawSummary() {
  const { measures } = evaluation();
  const rows = report.methods.map((_, index) => index);
  const columns = [{
    title: 'Method', text: (row) => report.methods[row].name,
    cell: (row) => {
      const { name, description } = report.methods[row];
      return make('span', { title: description || null }, swatch(row), name);
    },
  }];
  measures.forEach((measure, position) => {
    const value = (row) => evaluationOf(row)[state.average][position];
    columns.push({ title: measure, numeric: true, best: true, value, text: (row) => percent(value(row)) });
  });
  stamp('summary', [counted(evaluation().queries.length, 'query'), protocolWords(), averageWords(), 'in percent'], 'The best of each column is bold');
  sortableTable(byId('summary-table'), {
    caption: `Retrieval measures, ${protocolWords()}, ${averageWords()}, percent`, columns, rows,
    sort: drawSummary.sort, sorted: (sort) => { drawSummary.sort = sort; },
  });
}
