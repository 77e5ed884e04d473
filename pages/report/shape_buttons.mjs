// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of models, and buttons that open their shapes.

import { make } from '../common/elements.mjs';
import { number } from '../common/words.mjs';

export function picture({ pictures }, model, width = null) {
  if (!pictures || !pictures.png[model]) return make('span', { class: 'blank' });
  const src = `data:image/png;base64,${pictures.png[model]}`;
  const style = width && `width:${width}px;height:auto`;
  return make('img', { src, alt: '', loading: 'lazy', decoding: 'async', width: 120, height: 96, style });
}

export function shapeButton(state, model, { note = '', kind = '', mark = '', title = null } = {}) {
  const { report } = state;
  const attributes = {
    type: 'button', class: `shape ${kind}`, 'data-model': model,
    title: title || `${report.ids[model]}, ${state.className(model)}`, click: () => state.openShape(model),
  };
  return make('button', attributes,
    report.pictures ? picture(report, model) : null,
    make('span', { class: 'id' }, mark ? make('span', { class: 'mark' }, `${mark} `) : null, report.ids[model]),
    note ? make('span', { class: 'note' }, note) : null);
}

// Why a method has nothing of a model.
export function missingReason({ failures }, id) {
  const failure = failures.find(([failed]) => failed === id);
  return failure ? failure[1] : 'all models are infinitely far.';
}

// The models nearest to one, each with a mark: of its class or of another.
export function nearestStrip(state, model, method = state.method) {
  const { models, lists, distances } = method.nearest;
  const row = models.indexOf(model);
  if (row < 0) {
    return make('p', {}, 'The nearest models are listed for the worst queries only in data sets of this size.');
  }
  const { ids, labels } = state.report;
  if (lists[row].length === 0) return make('p', {}, `None: ${missingReason(method, ids[model])}`);
  return make('div', { class: 'strip' }, ...lists[row].map((other, rank) => {
    const right = labels[model] === labels[other];
    const note = state.className(other);
    const title = `Rank ${rank + 1}: ${ids[other]}, ${note}, distance ${number(distances[row][rank])}`;
    return shapeButton(state, other,
      { note, title, kind: right ? 'right' : 'wrong', mark: right ? '\u2713' : '\u2717' });
  }));
}
