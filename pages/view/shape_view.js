// Shapes that can be turned, side by side, with what their colours show: the same in a page of its own and in reports.

// What a view can show of its shapes, in the order of its list: fields, parts, normals, the bare shape.
function channelsOf(shapes) {
  const names = [...new Set(shapes.flatMap(({ fields }) => fields.map(({ name }) => name)))];
  const channels = names.map((name) => ({ name, kind: 'values', of: (shape) => shape.fields.find((field) => field.name === name) }));
  if (shapes.some(({ parts }) => parts)) channels.push({ name: 'Parts', kind: 'parts', of: ({ parts }) => parts });
  if (shapes.some(({ directions }) => directions)) channels.push({ name: 'Normals', kind: 'normals', of: ({ directions }) => directions });
  return [...channels, { name: 'Nothing', kind: 'plain', of: () => null }];
}

// The way from one position of the pointer to the next as a turn about axes in the plane of the picture.
function turnBy(turn, x, y) {
  const step = new THREE.Quaternion().setFromEuler(new THREE.Euler(y, x, 0));
  return turn.premultiply(step).normalize();
}

class ShapeView {
  // scales: by the name of a field { from, to, root }, where its colours have a scale that is set; note: said below.
  constructor(place, packed, { scales = {}, note = '' } = {}) {
    this.shapes = packed.map(unpackShape);
    this.scales = scales;
    this.channels = channelsOf(this.shapes);
    this.channel = this.channels[0];
    this.together = true;
    this.camera = { turn: new THREE.Quaternion(), zoom: 1, shift: new THREE.Vector2() };
    this.live = glRenderer() !== null;
    this.words = make('output', { class: 'view-words' });
    this.legend = make('div', { class: 'view-legend' });
    this.cells = this.shapes.map((shape) => this.makeCell(shape));
    const hint = this.live ? 'Drag to turn, wheel to zoom, Shift and drag to move; arrow keys, + and \u2212 as well.'
      : 'These pictures stand still: turning them takes WebGL, which this browser does not have or has switched off.';
    place.replaceChildren(this.tools(), this.legend,
      make('div', { class: `view-cells${this.shapes.length === 1 ? ' alone' : ''}` }, ...this.cells.map(({ cell }) => cell)),
      make('p', { class: 'stamp' }, `${hint} Click on the bars or drag over them, or use the arrow keys there, to light up where the surface has these values. ${note}`));
    this.onTheme = () => this.show();
    document.addEventListener('themechange', this.onTheme);
    this.resizing = new ResizeObserver(() => this.resized());
    this.resizing.observe(place);
    this.place = place;
    this.show();
  }

  destroy() {
    document.removeEventListener('themechange', this.onTheme);
    this.resizing.disconnect();
    for (const { drawn } of this.cells) if (drawn) drawn.dispose();
    this.cells = [];
    tooltip.hide();
  }

  tools() {
    const parts = [choice('Colours', this.channels.map(({ name }) => name), 0, (index) => { this.channel = this.channels[index]; this.lit = null; this.show(); })];
    if (this.shapes.length > 1) {
      const same = make('input', { type: 'checkbox', checked: true, change: () => { this.together = same.checked; this.lit = null; this.show(); } });
      parts.push(make('label', { class: 'view-same' }, same, 'Same scale for all'));
    }
    if (this.live) parts.push(make('button', { type: 'button', class: 'view-reset', click: () => this.reset() }, 'Reset view'));
    return make('div', { class: 'tools' }, ...parts, this.words);
  }

  makeCell(shape) {
    const cell = { shape, histogram: null, drawn: this.live ? new DrawnShape(shape) : null };
    const picture = make('img', { alt: `Picture of ${shape.name}`, src: shape.picture, hidden: this.live });
    cell.canvas = make('canvas', { tabindex: 0, role: 'img', 'aria-label': `${shape.name}, can be turned`, hidden: !this.live });
    cell.bars = make('div', { class: 'chart view-bars' });
    cell.cell = make('figure', { class: 'view-cell' },
      make('figcaption', {}, make('b', {}, shape.name), make('span', { class: 'count' }, shape.note ? ` ${shape.note}` : '')),
      make('div', { class: 'view-stage' }, picture, cell.canvas), cell.bars);
    if (this.live) this.listen(cell);
    return cell;
  }

  // Pointers on a canvas: one turns, or moves with Shift; two pinch.
  listen({ canvas, drawn, shape }) {
    const pointers = new Map();
    const at = (event) => ({ x: event.clientX, y: event.clientY });
    const spread = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a.x - b.x, a.y - b.y); };
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, at(event));
      tooltip.hide();
    });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) {
        this.read(drawn, shape, event);
        return;
      }
      const before = pointers.size > 1 ? spread() : 0;
      pointers.set(event.pointerId, at(event));
      const [x, y] = [(event.clientX - last.x) / canvas.clientHeight, (event.clientY - last.y) / canvas.clientHeight];
      if (pointers.size > 1) this.zoomBy(spread() / Math.max(1, before));
      else if (event.shiftKey || event.buttons === 2) this.moveBy(x, y);
      else this.turn(Math.PI * x, Math.PI * y);
    });
    canvas.addEventListener('pointerleave', () => this.leave());
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('dblclick', () => this.reset());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoomBy(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 33 : 1)));
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      const zoom = { '+': 1.1, '=': 1.1, '-': 1 / 1.1 }[event.key];
      if (!step && !zoom) return;
      event.preventDefault();
      if (zoom) this.zoomBy(zoom);
      else if (event.shiftKey) this.moveBy(...step);
      else this.turn(...step);
    });
  }

  turn(x, y) {
    turnBy(this.camera.turn, x, y);
    this.schedule();
  }

  moveBy(x, y) {
    this.camera.shift.add(new THREE.Vector2(-x, y).multiplyScalar(2.08 / this.camera.zoom));
    this.schedule();
  }

  zoomBy(factor) {
    this.camera.zoom = Math.max(0.2, Math.min(60, this.camera.zoom * factor));
    this.schedule();
  }

  reset() {
    this.camera.turn.set(0, 0, 0, 1);
    this.camera.zoom = 1;
    this.camera.shift.set(0, 0);
    this.schedule();
  }

  // The colour scale of a shape: set, its own, or all shapes' together.
  scaleOf(shape) {
    const { name, kind } = this.channel;
    const field = this.channel.of(shape);
    if (kind !== 'values' || !field) return null;
    if (this.scales[name]) return { low: field.low, high: field.high, ...this.scales[name] };
    const fields = this.together ? this.shapes.map((other) => this.channel.of(other)).filter(Boolean) : [field];
    return { from: d3.min(fields, ({ from }) => from), to: d3.max(fields, ({ to }) => to), low: d3.min(fields, ({ low }) => low), high: d3.max(fields, ({ high }) => high) };
  }

  // Draws everything anew: after another channel, theme or scale.
  show() {
    const colour = (name) => getComputedStyle(document.body).getPropertyValue(name).trim();
    const dim = d3.rgb(d3.interpolateRgb(colour('--rule'), colour('--muted'))(0.3));
    const ink = d3.rgb(colour('--ink'));
    for (const cell of this.cells) {
      const { shape, drawn } = cell;
      const data = this.channel.of(shape);
      const scale = this.scaleOf(shape);
      let shown = { kind: 'plain' };
      if (scale) shown = { kind: 'values', values: data.values, ...scale };
      else if (this.channel.kind === 'parts' && data) shown = { kind: 'values', values: data.values, from: 0, to: data.colours.length - 1, colours: data.colours };
      else if (data) shown = { kind: this.channel.kind };
      if (drawn) {
        drawn.show(shown);
        drawn.material.uniforms.unlit.value.setRGB(dim.r / 255, dim.g / 255, dim.b / 255);
        if (drawn.lines) drawn.lines.material.color.setRGB(ink.r / 255, ink.g / 255, ink.b / 255);
      }
      cell.shown = shown;
      this.showBars(cell);
    }
    this.drawLegend();
    this.light();
  }

  drawLegend() {
    const scale = this.shapes.map((shape) => this.scaleOf(shape)).find(Boolean);
    if (!scale || (!this.together && this.shapes.length > 1)) {
      const words = { parts: 'Each part has a colour; neighbours differ.', normals: 'Red, green and blue are the x, y and z of the normals.' };
      this.legend.replaceChildren(make('p', { class: 'stamp' }, scale ? 'Each shape has colours from its own thinnest to its own thickest.' : words[this.channel.kind] || ''));
      return;
    }
    const { from, to, root } = scale;
    const place = (value) => { const part = to > from ? (value - from) / (to - from) : 0.5; return root ? Math.sqrt(part) : part; };
    const ticks = root ? [0, 0.04, 0.16, 0.36, 0.64, 1].map((part) => from + part * (to - from)) : [0, 0.25, 0.5, 0.75, 1].map((part) => from + part * (to - from));
    this.legend.replaceChildren(colourScale(`${this.channel.name}:`, to > from ? ticks : [from], place, (value) => String(Number(value.toPrecision(3)))));
  }

  showBars(cell) {
    const { shape, shown } = cell;
    cell.histogram = null;
    if (shown.kind !== 'values') {
      cell.bars.replaceChildren();
      return;
    }
    const { values, from, to, root, colours } = shown;
    const bins = colours ? colours.length : 64;
    const [low, high] = colours ? [-0.5, bins - 0.5] : [shown.low, shown.high];
    const middle = (bin) => low + ((bin + 0.5) * (high - low)) / bins;
    const rampAt = (value) => {
      const part = Math.max(0, Math.min(1, to > from ? (value - from) / (to - from) : 0.5));
      return rampColours[Math.round(255 * (root ? Math.sqrt(part) : part))];
    };
    const step = Math.ceil(bins / 12);
    cell.shares = binShares(values, shape.weights, low, high, bins);
    cell.edges = (first, last) => [low + (first * (high - low)) / bins, low + ((last + 1) * (high - low)) / bins];
    cell.histogram = valueHistogram(cell.bars, {
      shares: cell.shares, low, high, width: Math.max(260, cell.bars.clientWidth || 420), label: `${this.channel.name} of ${shape.name}: share of the area`,
      colourOf: (bin) => (colours ? colours[bin] : rampAt(middle(bin))),
      ticks: colours && d3.range(0, bins, step),
      chosen: (first, last) => this.choose(cell, first, last),
    });
  }

  // Bins of one histogram: of all of them, where they have the same ones.
  choose(cell, first, last) {
    this.lit = first === undefined ? null : { first, last, of: this.together && this.channel.kind === 'values' && !this.scales[this.channel.name] ? null : cell };
    this.light(cell);
  }

  // Shows what is chosen; from: the cell whose bars already do.
  light(from = null) {
    const told = [];
    for (const cell of this.cells) {
      const mine = this.lit && cell.histogram && (!this.lit.of || this.lit.of === cell);
      if (cell.drawn) cell.drawn.light(mine ? cell.edges(this.lit.first, this.lit.last) : null);
      if (cell.histogram && cell !== from) cell.histogram.select(...(mine ? [this.lit.first, this.lit.last] : []));
      if (mine) told.push(cell);
    }
    this.words.textContent = told.length ? this.wordsOf(told) : '';
    this.schedule();
  }

  wordsOf(cells) {
    const { first, last } = this.lit;
    const [low, high] = cells[0].edges(first, last);
    const range = this.channel.kind === 'parts' ? (first === last ? `Part ${first + 1}` : `Parts ${first + 1} to ${last + 1}`) : `${number(low)} to ${number(high)}`;
    const shares = cells.map(({ shares: all }) => `${(100 * d3.sum(all.slice(first, last + 1))).toFixed(1)} %`);
    return `${range}: ${shares.join(', ')} of the area`;
  }

  // The value under the pointer.
  read(drawn, shape, event) {
    const box = event.target.getBoundingClientRect();
    const hit = drawn.at((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    if (!hit) {
      this.leave();
      return;
    }
    const valueIn = ({ values }) => d3.sum(hit.places, (place, k) => hit.shares[k] * values[place]);
    const known = ({ values }) => hit.places.every((place) => !Number.isNaN(values[place]));
    const words = (field) => (known(field) ? number(valueIn(field)) : 'no value');
    const lines = shape.fields.map((field) => tipLine([field.name], words(field)));
    if (shape.parts) lines.push(tipLine(['Part'], String(shape.parts.values[hit.place] + 1)));
    const head = shape.site === 'vertex' ? shape.name : `${shape.name}, ${shape.site} ${hit.place}`;
    tooltip.show(event.clientX, event.clientY, tipHead(head), ...lines);
    const data = this.channel.of(shape);
    const value = data && data.values && known(data) ? valueIn(data) : null;
    for (const cell of this.cells) if (cell.histogram) cell.histogram.mark(cell.shape === shape ? value : null);
  }

  leave() {
    tooltip.hide();
    for (const { histogram } of this.cells) if (histogram) histogram.mark(null);
  }

  resized() {
    const width = this.place.clientWidth;
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
      for (const { drawn, canvas } of this.cells) drawn.draw(canvas, this.camera);
    });
  }
}
