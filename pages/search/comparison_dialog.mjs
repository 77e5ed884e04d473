// SPDX-License-Identifier: GPL-3.0-or-later
// A query next to one of the shapes that were found, both to be turned together.

import { dialogButton, fillDialog } from '../common/dialog.mjs';
import { byId, make } from '../common/elements.mjs';
import { link } from '../common/link.mjs';
import { tooltip } from '../common/tooltip.mjs';
import { number } from '../common/words.mjs';
import { ShapeView } from '../view/shape_view.mjs';

const note = 'Both shapes are simplified, and scaled to unit area.';

export class ComparisonDialog {
  constructor(shapes) {
    this.shapes = shapes;
    this.dialog = byId('comparison');
    this.view = null;
    this.dialog.onclose = () => {
      this.closeView();
      link({ query: null, rank: null });
    };
  }

  // rank: that of the shape, from 0 on; -1: the query alone.
  open(answer, rank) {
    this.answer = answer;
    this.rank = rank;
    link({ query: this.shapes[answer.query].name });
    this.draw('.close');
    if (!this.dialog.open) this.dialog.showModal();
    this.dialog.scrollTop = 0;
  }

  step(by) {
    this.rank += by;
    this.draw(by > 0 ? '.next' : '.previous');
  }

  closeView() {
    if (this.view) this.view.destroy();
    this.view = null;
  }

  draw(focus) {
    const { shapes, answer: { query, nearest }, rank } = this;
    tooltip.hide();
    this.closeView();
    link({ rank });
    const found = rank < 0 ? null : nearest[rank];
    const shown = (found ? [query, found[0]] : [query]).map((index) => shapes[index]);
    const words = found ? `, rank ${rank + 1}, distance ${number(found[1], 3)}` : '';
    const container = make('div');
    fillDialog(this.dialog, [shown[shown.length - 1].name, make('span', { class: 'count' }, words)], [
      dialogButton('Nearer', () => this.step(-1), { class: 'previous', disabled: rank < 1 }),
      dialogButton('Farther', () => this.step(1), { class: 'next', disabled: rank + 1 >= nearest.length }),
    ], container);
    const drawn = shown.filter((shape) => shape.vertices);
    if (drawn.length === 0) container.append(make('p', {}, 'The file cannot be read any more.'));
    if (drawn.length > 0) this.view = new ShapeView(container, drawn, { note });
    const target = this.dialog.querySelector(focus);
    (target.disabled ? this.dialog.querySelector('.close') : target).focus({ preventScroll: true });
  }
}
