// SPDX-License-Identifier: GPL-3.0-or-later
// One shape in a dialog, with its values as a query, its histograms and what is nearest to it.

import { dialogButton, fillDialog } from '../common/dialog.mjs';
import { byId, choice, make } from '../common/elements.mjs';
import { link } from '../common/link.mjs';
import { tooltip } from '../common/tooltip.mjs';
import { ShapeView } from '../view/shape_view.mjs';
import { HistogramCharts } from './histograms.mjs';
import { valueItems } from './queries.mjs';
import { nearestStrip, picture } from './shape_buttons.mjs';

const viewNote = 'The shape is simplified; lengths are those of shapes of unit area.';

export class ShapeDialog {
  constructor(state) {
    this.state = state;
    this.dialog = byId('shape');
    this.histograms = new HistogramCharts(state.report);
    this.visited = []; // the shape that is shown, last, and those that were looked at before it
    this.turned = null; // that shape, where it can be turned: { model, container, view }
    this.dialog.onclose = () => {
      if (this.dialog.open) return; // the event may come when the next shape is open
      this.closeView();
      link({ query: null });
    };
    state.show(['method', 'protocol'], () => this.redraw());
  }

  open(model) {
    if (!this.dialog.open) this.visited = [];
    this.visited.push(model);
    link({ query: this.state.report.ids[model] });
    this.draw();
    if (!this.dialog.open) this.dialog.showModal();
    this.dialog.scrollTop = 0;
  }

  redraw() {
    if (this.dialog.open) this.draw('select');
  }

  back() {
    this.visited.pop();
    link({ query: this.state.report.ids[this.visited[this.visited.length - 1]] });
    this.draw();
  }

  closeView() {
    if (this.turned) this.turned.view.destroy();
    this.turned = null;
  }

  // Puts the last shape into the dialog; focus: the part of it that has the keyboard then.
  draw(focus = '.close') {
    const { state } = this;
    const model = this.visited[this.visited.length - 1];
    tooltip.hide();
    const back = this.visited.length > 1 ? [dialogButton('Back', () => this.back())] : [];
    fillDialog(this.dialog, [`${state.report.ids[model]}, ${state.className(model)}`], back,
      make('div', { class: 'portrait' }, this.portraitOf(model), this.valuesOf(model)),
      make('h3', {}, 'Nearest ten'), nearestStrip(state, model),
      ...this.histograms.elements(model, state.chosen.method));
    if (this.dialog.open) this.dialog.querySelector(focus).focus({ preventScroll: true });
  }

  // The method's measures for the model as a query.
  valuesOf(model) {
    const { state } = this;
    const names = state.report.methods.map(({ name }) => name);
    const methods = choice('Method', names, state.chosen.method, (index) => state.change({ method: index }));
    const position = state.evaluation.queries.indexOf(model);
    const values = position < 0 ? make('p', {}, 'Never a query: its class is too small.')
      : make('dl', { class: 'values' }, ...valueItems(state.queryValues(position)));
    return make('div', {}, make('div', { class: 'tools' }, methods),
      make('p', { class: 'stamp' }, `As a query: ${state.protocolWords}, in percent.`), values);
  }

  // The model as a view, or as its picture where the report has no views. The view of the model that is there already
  // stays as its reader turned it.
  portraitOf(model) {
    const { report } = this.state;
    if (!report.views) return report.pictures ? picture(report, model) : null;
    if (this.turned && this.turned.model === model) return this.turned.container;
    this.closeView();
    const { fields, shapes } = report.views;
    const packed = {
      ...shapes[model], name: report.ids[model], picture: report.pictures && report.pictures.png[model],
      fields: shapes[model].fields.map((field, index) =>
        ({ ...field, name: fields[index].name, measured: fields[index].measured })),
    };
    const scales = {};
    for (const { name, colours } of fields) if (colours) scales[name] = colours;
    const container = make('div', { class: 'turned' });
    this.turned = { model, container, view: new ShapeView(container, [packed], { scales, note: viewNote }) };
    return container;
  }
}
