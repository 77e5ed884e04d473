// SPDX-License-Identifier: GPL-3.0-or-later
// What the checks of the submissions found.

import { byId, make } from '../common/elements.mjs';
import { counted } from '../common/words.mjs';
import { sortableTable } from '../report/sortable_table.mjs';

export function drawChecks({ methods, refused }) {
  const container = byId('notes-text');
  container.append(make('h3', {}, 'Refused'));
  if (refused.length) {
    const columns = [{ title: 'Submission', text: ([file]) => file },
      { title: 'Reason', text: ([, reason]) => reason }];
    const table = make('div', { class: 'wide', id: 'refused-table' });
    sortableTable(table, { caption: counted(refused.length, 'submission'), columns, rows: refused });
    container.append(table);
  } else {
    container.append(make('p', {}, 'No submission was refused.'));
  }
  container.append(make('h3', {}, 'Remarks'));
  const items = remarksOf(methods)
    .map(({ warning, names }) => make('li', {}, make('b', {}, names.join(', ')), `: ${warning}`));
  container.append(items.length ? make('ul', { class: 'notes' }, ...items) : make('p', {}, 'Nothing is odd.'));
}

// Each warning once, with the methods that it is about.
export function remarksOf(methods) {
  const byWarning = new Map();
  for (const { name, warnings } of methods) {
    for (const warning of warnings) byWarning.set(warning, [...(byWarning.get(warning) || []), name]);
  }
  return [...byWarning].map(([warning, names]) => ({ warning, names }));
}
