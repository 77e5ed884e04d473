// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that can be turned, side by side, with what their colours show: the same in a page of its own and in reports.

import { colourScale } from '../common/chart.mjs';
import { choice, make } from '../common/elements.mjs';
import { link, linked } from '../common/link.mjs';
import { saveFile } from '../common/save.mjs';
import { tipHead, tipLine, tooltip } from '../common/tooltip.mjs';
import { number } from '../common/words.mjs';
import { binsOf, channelsOf, scaleOf, shownBy, valueColour } from './channels.mjs';
import { cameraText, readCamera } from './camera.mjs';
import { glbOf } from './glb.mjs';
import { cameraAt, regionList } from './regions.mjs';
import { unpackShape } from './shape_data.mjs';
import { DrawnShape, glRenderer } from './shape_drawing.mjs';
import { planeOf, sliceTools } from './slice.mjs';
import { listenToTurning } from './turning.mjs';
import { binShares, valueHistogram } from './value_histogram.mjs';

const hints = {
  live: 'Drag to turn, wheel to zoom, Shift and drag to move; arrow keys, + and \u2212 as well.',
  still: 'These pictures stand still: turning them takes WebGL, which this browser does not have or has switched off.',
  bars: 'Click on the bars or drag over them, or use the arrow keys there, to light up where the surface has these ' +
    'values.',
};
const legendWords = {
  separateScales: 'Each shape has colours from its own thinnest to its own thickest.',
  parts: 'Each part has a colour; neighbours differ.',
  normals: 'Red, green and blue are the x, y and z of the normals.',
};

export class ShapeView {
  // scales: by the name of a field { from, to, root }, where its colours have a scale that is set;
  // note: said below; unit: of lengths.
  constructor(container, packed, { scales = {}, note = '', unit = '' } = {}) {
    this.container = container;
    this.shapes = packed.map(unpackShape);
    this.scales = scales;
    this.unit = unit;
    this.channels = channelsOf(this.shapes);
    this.channel = this.channels.find(({ name }) => name === linked('colours')) || this.channels[0];
    this.together = true;
    this.lit = null;
    this.camera = readCamera(linked('camera'));
    this.live = glRenderer() !== null;
    this.words = make('output', { class: 'view-words' });
    this.legend = make('div', { class: 'view-legend' });
    this.cells = this.shapes.map((shape) => this.makeCell(shape));
    const alone = this.shapes.length === 1 ? ' alone' : '';
    container.replaceChildren(this.tools(), this.legend,
      make('div', { class: `view-cells${alone}` }, ...this.cells.map(({ figure }) => figure)),
      make('p', { class: 'stamp' }, [this.live ? hints.live : hints.still, hints.bars, note].join(' ')));
    this.onTheme = () => this.show();
    document.addEventListener('themechange', this.onTheme);
    this.resizing = new ResizeObserver(() => this.resized());
    this.resizing.observe(container);
    this.show();
  }

  destroy() {
    document.removeEventListener('themechange', this.onTheme);
    this.resizing.disconnect();
    link({ camera: null, colours: null });
    for (const { drawn } of this.cells) if (drawn) drawn.dispose();
    this.cells = [];
    tooltip.hide();
  }

  tools() {
    const change = (values) => {
      Object.assign(this, values, { lit: null });
      link({ colours: this.channel === this.channels[0] ? null : this.channel.name });
      this.show();
    };
    const names = this.channels.map(({ name }) => name);
    const shown = this.channels.indexOf(this.channel);
    const parts = [choice('Colours', names, shown, (index) => change({ channel: this.channels[index] }))];
    if (this.shapes.length > 1) {
      const toggle = (event) => change({ together: event.target.checked });
      const same = make('input', { type: 'checkbox', checked: true, change: toggle });
      parts.push(make('label', { class: 'view-same' }, same, 'Same scale for all'));
    }
    const button = (kind, text, click) => make('button', { type: 'button', class: kind, click }, text);
    if (this.live) {
      parts.push(sliceTools((slice) => this.cut(slice)),
        button('view-reset', 'Reset view', () => this.reset()),
        button('view-save', 'Download GLB', () => this.save()));
    }
    return make('div', { class: 'tools' }, ...parts, this.words);
  }

  makeCell(shape) {
    const label = `${shape.name}, can be turned`;
    const cell = {
      shape,
      drawn: this.live ? new DrawnShape(shape) : null,
      histogram: null,
      canvas: make('canvas', { tabindex: 0, role: 'img', 'aria-label': label, hidden: !this.live }),
      bars: make('div', { class: 'chart view-bars' }),
    };
    const src = `data:image/png;base64,${shape.picture}`;
    const picture = make('img', { alt: `Picture of ${shape.name}`, src: shape.picture && src, hidden: this.live });
    const note = make('span', { class: 'count' }, shape.note ? ` ${shape.note}` : '');
    cell.figure = make('figure', { class: 'view-cell' },
      make('figcaption', {}, make('b', {}, shape.name), note),
      make('div', { class: 'view-stage' }, picture, cell.canvas),
      make('div', { class: 'view-side' }, cell.bars,
        shape.regions.length ? regionList(shape.regions, (region) => this.goTo(cell, region)) : null));
    if (this.live) {
      listenToTurning(cell.canvas, {
        turn: (x, y) => this.turn(x, y),
        move: (x, y) => this.move(x, y),
        zoom: (factor) => this.zoom(factor),
        reset: () => this.reset(),
        hover: (event) => this.read(cell, event),
        leave: () => this.leave(),
      });
    }
    return cell;
  }

  // Turns about axes in the plane of the picture.
  turn(x, y) {
    const step = new THREE.Quaternion().setFromEuler(new THREE.Euler(y, x, 0));
    this.camera.turn.premultiply(step).normalize();
    this.schedule();
  }

  move(x, y) {
    this.camera.shift.add(new THREE.Vector2(-x, y).multiplyScalar(2.08 / this.camera.zoom));
    this.schedule();
  }

  zoom(factor) {
    this.camera.zoom = Math.max(0.2, Math.min(60, this.camera.zoom * factor));
    this.schedule();
  }

  reset() {
    this.camera.turn.set(0, 0, 0, 1);
    this.camera.zoom = 1;
    this.camera.shift.set(0, 0);
    this.schedule();
  }

  goTo({ drawn, shape }, region) {
    if (!this.live) return;
    Object.assign(this.camera, cameraAt(region, shape.radius, drawn.upright));
    this.schedule();
  }

  // Cuts off the half that is towards the viewer at this moment.
  cut(slice) {
    for (const { drawn } of this.cells) {
      if (!drawn) continue;
      const turn = drawn.upright.clone().premultiply(this.camera.turn).inverse();
      drawn.cut(slice && planeOf(slice, new THREE.Vector3(0, 0, 1).applyQuaternion(turn).toArray()));
    }
    this.schedule();
  }

  save() {
    const shown = this.cells.map(({ drawn, shown: channel }) => drawn.coloured(channel));
    saveFile(`${this.shapes[0].name || 'shape'}.glb`, 'model/gltf-binary', glbOf(shown));
  }

  scale(shape) {
    return scaleOf(this.channel, shape, this.together ? this.shapes : [shape], this.scales[this.channel.name]);
  }

  // Draws everything again after another channel, theme or scale.
  show() {
    const colour = (name) => getComputedStyle(document.body).getPropertyValue(name).trim();
    const dim = d3.rgb(d3.interpolateRgb(colour('--rule'), colour('--muted'))(0.3));
    for (const cell of this.cells) {
      cell.shown = shownBy(this.channel, cell.shape, this.scale(cell.shape));
      if (cell.drawn) {
        cell.drawn.show(cell.shown);
        cell.drawn.setColours(dim, ...['--ink', '--muted', '--wrong'].map((name) => d3.rgb(colour(name))));
      }
      this.showBars(cell);
    }
    this.drawLegend();
    this.light();
  }

  drawLegend() {
    const scale = this.shapes.map((shape) => this.scale(shape)).find(Boolean);
    if (!scale || (!this.together && this.shapes.length > 1)) {
      const words = scale ? legendWords.separateScales : legendWords[this.channel.kind] || '';
      this.legend.replaceChildren(make('p', { class: 'stamp' }, words));
      return;
    }
    this.legend.replaceChildren(colourScale(this.channelWords, scale));
    if (scale.below !== undefined) this.legend.append(make('p', { class: 'stamp' }, this.thinWords()));
  }

  get channelWords() { return `${this.channel.name}${this.unit && ` (${this.unit})`}`; }

  // How much of each shape is thinner than the threshold.
  thinWords() {
    const words = this.shapes.map((shape) => {
      const { below } = this.scale(shape) || {};
      const field = this.channel.of(shape);
      if (below === undefined || !field) return '';
      const areaWhere = (holds) => d3.sum(shape.weights, (weight, k) => (holds(field.values[k]) ? weight : 0));
      const missing = areaWhere(Number.isNaN);
      const known = areaWhere((value) => !Number.isNaN(value));
      const name = this.shapes.length > 1 ? `${shape.name}: ` : '';
      const percent = (area, all) => `${((100 * area) / all).toFixed(2)} % of the area`;
      const thin = percent(areaWhere((value) => value < below), known);
      const red = known > 0 && `${thin} below ${number(below)}${this.unit && ` ${this.unit}`}`;
      const grey = missing > 0 && `${percent(missing, known + missing)} without a value (grey)`;
      return name + [red, grey].filter(Boolean).join(', ');
    });
    return `Red: ${words.filter(Boolean).join('; ')}.`;
  }

  showBars(cell) {
    const { shape, shown } = cell;
    cell.histogram = null;
    if (shown.kind !== 'values') {
      cell.bars.replaceChildren();
      return;
    }
    const { colours } = shown;
    const alone = this.cells.length === 1;
    const { bins, low, high, edge } = binsOf(shown);
    cell.edges = (first, last) => [edge(first), edge(last + 1)];
    cell.shares = binShares(shown.values, shape.weights, low, high, bins);
    cell.histogram = valueHistogram(cell.bars, {
      shares: cell.shares, low, high,
      label: `${this.channel.name} of ${shape.name}: share of the area`,
      colourOf: (bin) => valueColour(shown, colours ? bin : edge(bin + 0.5)),
      title: colours ? this.channel.name : this.channelWords, mark: shown.below,
      size: { width: Math.max(260, cell.bars.clientWidth || 420), height: alone && !shape.regions.length ? 420 : 200 },
      ticks: colours && d3.range(0, bins, Math.ceil(bins / 12)),
      chosen: (first, last) => this.choose(cell, first, last),
    });
  }

  // Bins of one histogram: of all of them, where they have the same ones.
  choose(cell, first, last) {
    const shared = this.together && this.channel.kind === 'values' && !this.scales[this.channel.name];
    this.lit = first === undefined ? null : { first, last, of: shared ? null : cell };
    this.light(cell);
  }

  // Shows what is chosen; from: the cell whose bars already do.
  light(from = null) {
    const lit = this.lit ? [this.lit.first, this.lit.last] : [];
    const lighted = this.cells.filter((cell) => this.lit && cell.histogram && (!this.lit.of || this.lit.of === cell));
    for (const cell of this.cells) {
      const mine = lighted.includes(cell);
      if (cell.drawn) cell.drawn.light(mine ? cell.edges(...lit) : null);
      if (cell.histogram && cell !== from) cell.histogram.select(...(mine ? lit : []));
    }
    this.words.textContent = lighted.length ? this.wordsOf(lighted) : '';
    this.schedule();
  }

  wordsOf(cells) {
    const { first, last } = this.lit;
    const [low, high] = cells[0].edges(first, last);
    const parts = first === last ? `Part ${first + 1}` : `Parts ${first + 1} to ${last + 1}`;
    const range = this.channel.kind === 'parts' ? parts : `${number(low)} to ${number(high)}`;
    const shares = cells.map((cell) => `${(100 * d3.sum(cell.shares.slice(first, last + 1))).toFixed(1)} %`);
    return `${range}: ${shares.join(', ')} of the area`;
  }

  // The value under the pointer.
  read({ drawn, shape }, event) {
    const box = event.target.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    const hit = drawn.at(2 * x - 1, 1 - 2 * y);
    if (!hit) {
      this.leave();
      return;
    }
    const valueIn = ({ values }) => d3.sum(hit.samples, (sample, k) => hit.shares[k] * values[sample]);
    const known = ({ values }) => hit.samples.every((sample) => !Number.isNaN(values[sample]));
    const words = (field) => (known(field) ? number(valueIn(field)) : 'no value');
    const lines = shape.fields.map((field) => tipLine([field.name], words(field)));
    const alone = shape.parts.length === 1;
    for (const { name, values } of shape.parts) {
      lines.push(tipLine([alone ? 'Part' : name], String(values[hit.sample] + 1)));
    }
    const head = shape.site === 'vertex' ? shape.name : `${shape.name}, ${shape.site} ${hit.sample}`;
    tooltip.show(event.clientX, event.clientY, tipHead(head), ...lines);
    const data = this.channel.of(shape);
    const value = data && data.values && known(data) ? valueIn(data) : null;
    if (value !== null && data.measured) {
      drawn.measure(hit, data.measured.by, (value * data.measured.unit) / shape.radius);
      this.schedule();
    } else {
      this.hideProbes();
    }
    for (const cell of this.cells) if (cell.histogram) cell.histogram.mark(cell.shape === shape ? value : null);
  }

  hideProbes() {
    for (const { drawn } of this.cells) drawn.probe.hide();
    this.schedule();
  }

  leave() {
    tooltip.hide();
    this.hideProbes();
    for (const { histogram } of this.cells) if (histogram) histogram.mark(null);
  }

  resized() {
    const width = this.container.clientWidth;
    if (width !== this.width) {
      this.width = width;
      for (const cell of this.cells) this.showBars(cell);
      this.light();
    }
    this.schedule();
  }

  schedule() {
    if (!this.live || this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      link({ camera: cameraText(this.camera) });
      for (const { drawn, canvas } of this.cells) drawn.draw(canvas, this.camera);
    });
  }
}
