// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a segmentation experiment: puts the page together.

import { fillDialog } from '../common/dialog.mjs';
import { byId, make, pageData } from '../common/elements.mjs';
import { drawFrame, followResizing } from '../common/frame.mjs';
import { counted } from '../common/words.mjs';
import { showClasses } from '../report/classes.mjs';
import { stamp } from '../report/section.mjs';
import { textTable } from '../report/sortable_table.mjs';
import { ShapeView } from '../view/shape_view.mjs';
import { SegmentationState } from './segmentation_state.mjs';

const page = pageData();
const { errors, perturbation_effects: perturbationEffects, consistency, failures, shown, typical } = page;

function openShape({ title, view }) {
  const dialog = byId('shape');
  const container = make('div', { class: 'turned' });
  fillDialog(dialog, [title], [], container);
  dialog.showModal();
  const live = new ShapeView(container, [{ ...view, name: title }], { note: 'The shape is simplified.' });
  dialog.onclose = () => live.destroy();
}

function figure(shape) {
  const pictures = shape.pictures.map(({ png, caption }) =>
    make('span', {}, make('img', { src: `data:image/png;base64,${png}`, alt: '', loading: 'lazy' }), caption));
  return make('button', { type: 'button', class: 'figure', click: () => openShape(shape), disabled: !shape.view },
    make('b', {}, shape.title), make('span', { class: 'views' }, ...pictures));
}

function drawErrors() {
  stamp('errors', ['less is better', `triangles count ${errors.weights}`]);
  for (const table of errors.tables) {
    const container = make('div', { class: 'wide' });
    textTable(container, table);
    byId('errors-tables').append(container);
  }
}

function drawShapes() {
  const hint = 'Click a shape to turn it';
  stamp('typical', [errors ? 'the shape of median error of each class' : 'one shape of each class'], hint);
  stamp('shapes', errors ? ['largest Rand error first', `by ${errors.methods[0]}`] : ['all shapes'], hint);
  byId('typical-figures').append(...typical.map((index) => figure(shown[index])));
  byId('shapes-figures').append(...shown.map(figure));
}

const present = {
  errors, classes: errors, damage: perturbationEffects.rows.length, typical: shown.length, shapes: shown.length,
  notes: failures.length,
};
for (const [section, there] of Object.entries(present)) if (!there) byId(section).remove();
drawFrame(page, [counted(page.labels.length, 'shape'), counted(page.classes.length, 'class')]);
if (errors) {
  drawErrors();
  followResizing(showClasses(new SegmentationState(page)));
}
if (perturbationEffects.rows.length) textTable(byId('damage-table'), perturbationEffects);
textTable(byId('consistency-table'), consistency);
if (shown.length) drawShapes();
if (failures.length) {
  textTable(byId('notes-table'), { header: ['Shape', 'Reason'], text_columns: 2, rows: failures });
}
