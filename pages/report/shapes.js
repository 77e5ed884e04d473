// The shapes: small pictures by class, and one shape with its histograms and what is nearest to it.

function picture(model, width = null) {
  const png = report.pictures && report.pictures.png[model];
  if (!png) return make('span', { class: 'blank' });
  const image = make('img', { src: `data:image/png;base64,${png}`, alt: '', loading: 'lazy', decoding: 'async', width: 120, height: 96 });
  if (width) image.style.width = `${width}px`;
  if (width) image.style.height = 'auto';
  return image;
}

function shapeButton(model, note, kind = '') {
  return make('button', { type: 'button', class: `shape ${kind}`, 'data-model': model, title: `${report.ids[model]}, ${className(model)}`, click: () => openShape(model) },
    report.pictures ? picture(model) : null, make('span', { class: 'id' }, report.ids[model]), note ? make('span', { class: 'note' }, note) : null);
}

const filter = { text: '', label: -1 };

function drawGallery() {
  const tools = byId('shapes-tools');
  if (!tools.hasChildNodes()) {
    const search = make('input', { type: 'search', size: 18, placeholder: 'id or class', input: () => { filter.text = search.value.toLowerCase(); drawGallery(); } });
    tools.append(make('label', {}, 'Find', search), choice('Class', ['all', ...report.classes], 0, (index) => { filter.label = index - 1; drawGallery(); }));
    byId('shapes-scale').append(...(report.pictures ? [pictureScale()] : []));
  }
  stamp('shapes', [`${counted(report.ids.length, 'model')} of ${counted(report.classes.length, 'class')}`],
    ...(report.pictures ? [`Colours are values of the field of \u201c${report.pictures.field}\u201d, on the same scale for all`] : []),
    'Click a shape to see its histograms and what is nearest to it');
  const groups = report.classes.map((name, label) => {
    if (filter.label >= 0 && filter.label !== label) return null;
    const wanted = (model) => report.labels[model] === label && `${report.ids[model]} ${name}`.toLowerCase().includes(filter.text);
    const models = report.ids.map((_, model) => model).filter(wanted);
    if (models.length === 0) return null;
    return make('div', {}, make('h3', {}, `${name} `, make('span', { class: 'count' }, String(models.length))),
      make('div', { class: 'gallery' }, ...models.map((model) => shapeButton(model))));
  }).filter(Boolean);
  byId('shapes-gallery').replaceChildren(...(groups.length ? groups : [make('p', {}, 'No shape like that.')]));
}

function pictureScale() {
  const { low, high } = report.pictures;
  const place = (value) => Math.sqrt((value - low) / (high - low));
  const ticks = [0, 0.04, 0.16, 0.36, 0.64, 1].map((part) => low + part * (high - low));
  return colourScale('Field value, in lengths of shapes of unit area:', ticks, place, (value) => String(Number(value.toPrecision(2))));
}

// Which shape the dialog shows, and which were looked at before it.
const visited = [];

function openShape(model) {
  const dialog = byId('shape');
  if (!dialog.open) visited.length = 0;
  visited.push(model);
  drawShape(dialog, model);
  if (!dialog.open) dialog.showModal();
  dialog.onclose = () => { if (!dialog.open) closeView(); }; // the event may come when the next shape is open
  dialog.scrollTop = 0;
}

// The shape in the dialog, where it can be turned.
let turned = null;

function closeView() {
  if (turned) turned.view.destroy();
  turned = null;
}

// The model as a view, or as its picture where the report has no views. The view of the model that is there already
// stays as its reader turned it.
function portraitOf(model) {
  if (!report.views) return report.pictures ? picture(model) : null;
  if (turned && turned.model === model) return turned.place;
  closeView();
  const { fields, shapes } = report.views;
  const packed = { ...shapes[model], name: report.ids[model], picture: `data:image/png;base64,${report.pictures.png[model]}` };
  packed.fields = packed.fields.map((field, index) => ({ ...field, name: fields[index].name }));
  const scales = Object.fromEntries(fields.filter(({ colours }) => colours).map(({ name, colours }) => [name, colours]));
  const place = make('div', { class: 'turned' });
  turned = { model, place, view: new ShapeView(place, [packed], { scales, note: 'The shape is simplified; lengths are those of shapes of unit area.' }) };
  return place;
}

// Puts the model into the dialog; focus: the part of it that has the keyboard then.
function drawShape(dialog, model, focus = '.close') {
  tooltip.hide();
  const back = () => { visited.pop(); drawShape(dialog, visited[visited.length - 1]); };
  const head = make('div', { class: 'dialog-head' }, make('h2', { id: 'shape-title' }, `${report.ids[model]}, ${className(model)}`),
    visited.length > 1 ? make('button', { type: 'button', click: back }, 'Back') : null,
    make('button', { type: 'button', class: 'close', click: () => dialog.close() }, 'Close'));
  const chosen = choice('Method', report.methods.map(({ name }) => name), state.method, (index) => change({ method: index }));
  const position = evaluation().queries.indexOf(model);
  const values = position < 0 ? make('p', {}, 'Never a query: its class is too small.')
    : make('dl', { class: 'values' }, ...queryValues(position).flatMap(([name, value]) => [make('dt', {}, name === 'mAP' ? 'AP' : name), make('dd', {}, percent(value))]));
  const portrait = make('div', { class: 'portrait' }, portraitOf(model),
    make('div', {}, make('div', { class: 'tools' }, chosen), make('p', { class: 'stamp' }, `As a query: ${protocolWords()}, in percent.`), values));
  const body = make('div', { class: 'dialog-body' }, portrait, make('h3', {}, 'Nearest ten'), nearestStrip(model), ...histogramParts(model));
  dialog.replaceChildren(head, body);
  if (dialog.open) dialog.querySelector(focus).focus({ preventScroll: true });
}

function redrawShape() {
  const dialog = byId('shape');
  if (dialog.open) drawShape(dialog, visited[visited.length - 1], 'select');
}

// The histograms of the method: its own, or those that it has side by side.
function histogramMethods(index) {
  const { histograms, parts } = report.methods[index];
  return histograms ? [index] : parts.flatMap(histogramMethods);
}

function histogramParts(model) {
  const methods = histogramMethods(state.method);
  if (methods.length === 0) return [];
  return [make('h3', {}, methods.length > 1 ? 'Histograms' : 'Histogram'), ...methods.map((index) => histogramChart(model, index))];
}

function histogramChart(model, index) {
  const { histograms, name } = report.methods[index];
  histograms.numbers = histograms.numbers || unpack(histograms);
  const bins = histograms.numbers.subarray(model * histograms.bins, (model + 1) * histograms.bins);
  const [low, high] = histograms.ranges[model];
  const place = make('div', { class: 'chart histogram' });
  const { svg, area, width, height } = drawing(place, { width: Math.max(420, Math.min(880, window.innerWidth - 90)), height: 190, left: 50, right: 14, top: 22, bottom: 38, label: `Histogram of ${report.ids[model]}, ${name}` });
  const x = d3.scaleLinear([low, high], [0, width]);
  const y = d3.scaleLinear([0, Math.max(...bins)], [height, 0]).nice(4);
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(4).tickSize(-width).tickFormat(''));
  area.append('text').attr('x', 0).attr('y', -8).text(name);
  bins.forEach((part, bin) => {
    const [from, to] = [low + ((high - low) * bin) / bins.length, low + ((high - low) * (bin + 1)) / bins.length];
    area.append('rect').attr('x', (width * bin) / bins.length).attr('width', Math.max(0.5, width / bins.length - 0.6))
      .attr('y', y(part)).attr('height', height - y(part)).style('fill', colourOf(index))
      .append('title').text(`${number(from)} to ${number(to)}: ${percent(part)} % of the area`);
  });
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(8));
  area.append('g').attr('class', 'axis').call(d3.axisLeft(y).ticks(4));
  area.append('text').attr('x', width / 2).attr('y', height + 34).attr('text-anchor', 'middle').text('Field value (shape of unit area)');
  place.append(saveButton(svg.node(), `histogram_${model}`));
  return place;
}
