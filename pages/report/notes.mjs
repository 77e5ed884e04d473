// The last section: warnings, models left out, settings of the methods.

import { byId, make } from '../common/elements.mjs';
import { counted } from '../common/words.mjs';
import { sortableTable } from './sortable_table.mjs';

const list = (items) => make('ul', { class: 'notes' }, ...items);

export function drawNotes(report) {
  const place = byId('notes-text');
  const { left_out: leftOut } = report.methods[0].evaluations[0];
  const few = counted(leftOut, 'model');
  const small = `${few} of classes that are too small: never a query, but in the lists of others.`;
  const notes = [...(leftOut > 0 ? [small] : []), ...report.warnings].map((note) => make('li', {}, note));
  place.append(notes.length ? list(notes) : make('p', {}, 'No warnings.'));
  if (report.failures.length) place.append(...failureTable(report.failures));
  const described = report.methods.filter(({ description }) => description);
  if (described.length === 0) return;
  const items = described.map(({ name, description }) => make('li', {}, make('b', {}, name), `: ${description}`));
  place.append(make('h3', {}, 'Methods'), list(items));
}

function failureTable(failures) {
  const table = make('div', { class: 'wide' });
  const columns = [{ title: 'Model', text: ([id]) => id }, { title: 'Reason', text: ([, reason]) => reason }];
  sortableTable(table, { caption: counted(failures.length, 'model'), columns, rows: failures });
  return [make('h3', {}, 'Models left out'),
    make('p', {}, 'These could not be used; all figures are without them.'), table];
}
