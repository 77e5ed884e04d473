// SPDX-License-Identifier: GPL-3.0-or-later
// Two methods side by side: the queries whose answers differ most.

import { byId, choice, make } from '../common/elements.mjs';
import { link, linked } from '../common/link.mjs';
import { percent } from '../common/words.mjs';
import { stamp } from './section.mjs';
import { nearestStrip, shapeButton } from './shape_buttons.mjs';

const shownQueries = 8;

// Positions of the queries by how much a measure changes, most first; those without a change are left out.
export function mostChanged(values, others, measure) {
  const change = (position) => Math.abs(values[position][measure] - others[position][measure]);
  return values.map((_, position) => position).filter((position) => change(position) > 0)
    .sort((a, b) => change(b) - change(a) || a - b);
}

export function showChanges(state) {
  const names = state.report.methods.map(({ name }) => name);
  const asked = names.indexOf(linked('with'));
  let other = asked >= 0 ? asked : names.length - 1;
  const draw = () => drawChanges(state, other);
  byId('changes-tools').append(choice('Compared with', names, other, (index) => {
    other = index;
    link({ with: names[index] });
    draw();
  }));
  state.show(['method', 'protocol'], draw);
}

function drawChanges(state, other) {
  const { report: { methods }, evaluation: { measures, queries, per_query: values }, method } = state;
  const measure = Math.max(0, measures.indexOf('mAP'));
  const others = state.evaluationOf(other).per_query;
  const positions = mostChanged(values, others, measure);
  const both = [[method, values], [methods[other], others]];
  stamp('changes', [both.map(([{ name }]) => name).join(' and '), state.protocolWords,
    `largest change of ${measures.includes('mAP') ? 'average precision' : measures[0]} first`, 'in percent'],
    `${positions.length} of ${queries.length} queries change`);
  byId('changes-list').replaceChildren(...positions.slice(0, shownQueries).map((position) => {
    const model = queries[position];
    const answers = both.map(([one, scores]) => make('div', {},
      make('p', { class: 'count' }, `${one.name}: ${percent(scores[position][measure])}`),
      nearestStrip(state, model, one)));
    return make('li', {}, shapeButton(state, model, { note: state.className(model) }), make('div', {}, ...answers));
  }));
}
