// SPDX-License-Identifier: GPL-3.0-or-later
// The choices in the bar of a page, which are in its address as well.

import { byId, choice } from '../common/elements.mjs';
import { link, linked } from '../common/link.mjs';

// By key of ReportState.chosen: label, words of the options, and what is chosen by them, if not their position.
const choices = {
  method: { label: 'Method', words: ({ report }) => report.methods.map(({ name }) => name) },
  measure: { label: 'Measure', words: ({ evaluation }) => evaluation.measures },
  protocol: { label: 'Protocol', words: ({ report }) => report.methods[0].evaluations.map(({ protocol }) => protocol) },
  average: { label: 'Mean over', words: () => ['queries', 'classes'], values: ['micro', 'macro'] },
};

const valueAt = (key, index) => (choices[key].values ? choices[key].values[index] : index);
const indexOf = ({ chosen }, key) => (choices[key].values ? choices[key].values.indexOf(chosen[key]) : chosen[key]);

// What an address chooses; asked(key): its words, or null.
export function chosenBy(asked, state, keys) {
  const chosen = {};
  for (const key of keys) {
    const index = choices[key].words(state).indexOf(asked(key));
    if (index >= 0) chosen[key] = valueAt(key, index);
  }
  return chosen;
}

// Shows those of these choices that have several options. To be called before anything else is drawn.
export function showChoices(state, keys) {
  Object.assign(state.chosen, chosenBy(linked, state, keys));
  for (const key of keys) {
    const { label, words } = choices[key];
    const options = words(state);
    if (options.length < 2) continue;
    const shown = choice(label, options, indexOf(state, key), (index) => {
      state.change({ [key]: valueAt(key, index) });
      link({ [key]: options[index] });
    });
    byId('choices').append(shown);
    state.show([key], () => { shown.querySelector('select').selectedIndex = indexOf(state, key); });
  }
}
