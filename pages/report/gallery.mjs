// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of all shapes, by class.

import { colourScale } from '../common/chart.mjs';
import { byId, choice, make } from '../common/elements.mjs';
import { counted } from '../common/words.mjs';
import { stamp } from './section.mjs';
import { shapeButton } from './shape_buttons.mjs';

export function showGallery(state) {
  const { report } = state;
  const filter = { text: '', label: -1 };
  const change = (values) => {
    Object.assign(filter, values);
    drawGallery(state, filter);
  };
  const find = (event) => change({ text: event.target.value.toLowerCase() });
  const search = make('input', { type: 'search', size: 18, placeholder: 'id or class', input: find });
  byId('shapes-tools').append(make('label', {}, 'Find', search),
    choice('Class', ['all', ...report.classes], 0, (index) => change({ label: index - 1 })));
  if (report.pictures) byId('shapes-scale').append(pictureScale(report.pictures));
  const models = `${counted(report.ids.length, 'model')} of ${counted(report.classes.length, 'class')}`;
  const coloured = report.pictures
    ? [`Colours are values of the field of \u201c${report.pictures.field}\u201d, on the same scale for all`] : [];
  stamp('shapes', [models], ...coloured, 'Click a shape to see its histograms and what is nearest to it');
  drawGallery(state, filter);
}

// The models that a filter leaves, by class: { label, models }. text: in lower case; label: of a class, or -1.
export function filteredModels({ classes, ids, labels }, { text, label: only }) {
  return classes.map((name, label) => {
    const matches = (model) => labels[model] === label && `${ids[model]} ${name}`.toLowerCase().includes(text);
    const models = only < 0 || only === label ? ids.map((_, model) => model).filter(matches) : [];
    return { label, models };
  }).filter(({ models }) => models.length > 0);
}

function drawGallery(state, filter) {
  const groups = filteredModels(state.report, filter).map(({ label, models }) => {
    const count = make('span', { class: 'count' }, String(models.length));
    return make('div', {}, make('h3', {}, `${state.report.classes[label]} `, count),
      make('div', { class: 'gallery' }, ...models.map((model) => shapeButton(state, model))));
  });
  byId('shapes-gallery').replaceChildren(...(groups.length ? groups : [make('p', {}, 'No shape like that.')]));
}

function pictureScale({ low, high }) {
  return colourScale('Field value, in lengths of shapes of unit area', { from: low, to: high, root: true });
}
