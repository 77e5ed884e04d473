// SPDX-License-Identifier: GPL-3.0-or-later
// Legends whose buttons show and hide methods.

import { methodColours } from '../common/constants.mjs';
import { make } from '../common/elements.mjs';
import { swatch } from './method_look.mjs';

// A button for each method that hides it in the charts or shows it again, and lights it up where the pointer or the
// keyboard is; and two for all of them where there are many.
export function drawLegend(container, state) {
  const { report, chosen: { hidden }, methodIndices: all } = state;
  const legend = make('div', { class: 'legend', role: 'group', 'aria-label': 'Methods shown' });
  const add = (attributes, hiddenNext, ...content) => {
    const position = legend.children.length;
    const click = () => {
      state.change({ hidden: new Set(hiddenNext) });
      container.querySelectorAll('button')[position].focus();
    };
    legend.append(make('button', { type: 'button', click, ...attributes }, ...content));
  };
  for (const index of all) {
    const on = () => light(hidden.has(index) ? null : index);
    const off = () => light(null);
    const listeners = { pointerenter: on, focus: on, pointerleave: off, blur: off };
    const toggled = all.filter((other) => hidden.has(other) !== (other === index));
    const pressed = String(!hidden.has(index));
    add({ 'aria-pressed': pressed, ...listeners }, toggled, swatch(index), report.methods[index].name);
  }
  if (all.length > methodColours) {
    add({ class: 'quiet' }, [], 'Show all');
    add({ class: 'quiet' }, all, 'Hide all');
  }
  container.replaceChildren(legend);
}

// Fades what charts show of all methods but one; null: of none.
function light(method) {
  for (const element of document.querySelectorAll('[data-method]')) {
    element.classList.toggle('faded', method !== null && Number(element.dataset.method) !== method);
  }
}
