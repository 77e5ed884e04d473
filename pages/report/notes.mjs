// SPDX-License-Identifier: GPL-3.0-or-later
// The last section: warnings, models left out, settings of the methods.

import { byId, make } from '../common/elements.mjs';
import { counted, percent } from '../common/words.mjs';
import { sortableTable } from './sortable_table.mjs';

const list = (items) => make('ul', { class: 'notes' }, ...items);

export function drawNotes(report) {
  const container = byId('notes-text');
  const { left_out: leftOut } = report.methods[0].evaluations[0];
  const few = counted(leftOut, 'model');
  const small = `${few} of classes that are too small: never a query, but in the lists of others.`;
  const notes = [...(leftOut > 0 ? [small] : []), ...report.warnings].map((note) => make('li', {}, note));
  container.append(notes.length ? list(notes) : make('p', {}, 'No warnings.'));
  if (report.failures.length) container.append(...failureTable(report.failures));
  const ofMethods = report.methods.flatMap(({ name, failures }) => failures.map((failure) => [name, ...failure]));
  if (ofMethods.length) container.append(...methodFailureTable(ofMethods));
  if (report.leaks.length) container.append(...leakTable(report.leaks));
  if (report.perturbations.length) {
    const title = (type, index) => `${index + 1}. ${type}`;
    container.append(make('h3', {}, 'Perturbations'),
      settingsTables(report.perturbations.map(([type, settings], index) => [title(type, index), settings])));
  }
  const described = report.methods.filter(({ settings }) => settings.length);
  if (described.length === 0) return;
  container.append(make('h3', {}, 'Methods'), settingsTables(described.map(({ name, settings, distance }) =>
    [name, distance ? [...settings, ['distance', distance]] : settings])));
}

// A table of settings for each title.
function settingsTables(described) {
  const table = ([title, settings]) => make('table', { class: 'settings' }, make('caption', {}, title),
    make('tbody', {}, ...settings.map(([key, value]) =>
      make('tr', {}, make('th', { scope: 'row' }, key), make('td', {}, value)))));
  return make('div', { class: 'all-settings' }, ...described.map(table));
}

function leakTable(leaks) {
  const table = make('div', { class: 'wide' });
  const size = (title, position) => ({
    title, numeric: true, value: (leak) => leak[position], text: (leak) => `${percent(leak[position])} %`,
  });
  const columns = [{ title: 'Shape', text: ([id]) => id }, { title: 'Field', text: ([, field]) => field },
    size('Offset', 2), size('Offset that closes the gaps', 3)];
  const shapes = new Set(leaks.map(([id]) => id)).size;
  sortableTable(table, { caption: `${counted(shapes, 'shape')}; percent of the diagonal`, columns, rows: leaks });
  return [make('h3', {}, 'Shapes that leak'),
    make('p', {}, 'Their gaps are wider than the offset of a field: values near them are not those of a closed shape.'),
    leaks.length > 20 ? make('details', {}, make('summary', {}, counted(shapes, 'shape')), table) : table];
}

function methodFailureTable(rows) {
  const table = make('div', { class: 'wide' });
  const columns = ['Method', 'Model', 'Reason'].map((title, position) => ({ title, text: (row) => row[position] }));
  sortableTable(table, { caption: counted(rows.length, 'failure'), columns, rows });
  return [make('h3', {}, 'Models that a method cannot process'),
    make('p', {}, 'The method never finds these, and finds nothing for them; the other methods are judged with them.'),
    rows.length > 20 ? make('details', {}, make('summary', {}, counted(rows.length, 'failure')), table) : table];
}

function failureTable(failures) {
  const table = make('div', { class: 'wide' });
  const columns = [{ title: 'Model', text: ([id]) => id }, { title: 'Reason', text: ([, reason]) => reason }];
  sortableTable(table, { caption: counted(failures.length, 'model'), columns, rows: failures });
  return [make('h3', {}, 'Models left out'),
    make('p', {}, 'These could not be used; all figures are without them.'), table];
}
