// SPDX-License-Identifier: GPL-3.0-or-later
// The queries that did worst, each with what was nearest to it.

import { byId, make } from '../common/elements.mjs';
import { percent } from '../common/words.mjs';
import { stamp } from './section.mjs';
import { nearestStrip, shapeButton } from './shape_buttons.mjs';

const shownAtFirst = 8;

export function showQueries(state) {
  let most = shownAtFirst;
  const draw = () => drawQueries(state, most);
  byId('queries-more').onclick = () => {
    most = Infinity;
    draw();
  };
  state.show(['method', 'protocol'], draw);
}

// Names and values as the items of a list of definitions.
export const valueItems = (values) =>
  values.map(([name, value]) => make('div', {}, make('dt', {}, name), make('dd', {}, percent(value))));

function drawQueries(state, most) {
  const { worst, queries, measures } = state.evaluation;
  const by = measures.includes('mAP') ? 'average precision' : measures[0];
  stamp('queries', [state.method.name, state.protocolWords, `lowest ${by} first`, 'measures in percent'],
    'The ten nearest from left to right: \u2713 of the query\u2019s class, \u2717 of another');
  const items = worst.slice(0, most).map((position) => {
    const model = queries[position];
    return make('li', {}, shapeButton(state, model, { note: state.className(model) }),
      make('dl', {}, ...valueItems(state.queryValues(position))), nearestStrip(state, model));
  });
  byId('queries-list').replaceChildren(...items);
  const more = byId('queries-more');
  more.hidden = most >= worst.length;
  more.textContent = `Show all ${worst.length}`;
}
