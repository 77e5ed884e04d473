// SPDX-License-Identifier: GPL-3.0-or-later
// The models in the plane, the nearer the more similar: an embedding of a method's distances.

import { drawing } from '../common/chart.mjs';
import { byId } from '../common/elements.mjs';
import { tipHead, tooltip } from '../common/tooltip.mjs';
import { shortened } from '../common/words.mjs';
import { classOrder } from './heat_map.mjs';
import { colourOf } from './method_look.mjs';
import { stamp, widthIn } from './section.mjs';
import { picture } from './shape_buttons.mjs';
import { saveButton } from './svg_file.mjs';

const size = [50, 40]; // of a picture

// Returns what draws the section again.
export function showMap(state) {
  const draw = () => drawMap(state);
  state.show(['method'], draw);
  return draw;
}

// The models that have a position: { model, x, y }. map: positions in the order of the heat map.
export const modelPoints = (map, order) => order
  .map((model, index) => ({ model, x: map[index][0], y: map[index][1] })).filter(({ x }) => x !== null);

// The mean position of each class: { label, x, y }.
export function classMiddles(points, labels) {
  const byLabel = new Map();
  for (const one of points) byLabel.set(labels[one.model], [...(byLabel.get(labels[one.model]) || []), one]);
  const mean = (models, key) => models.reduce((sum, one) => sum + one[key], 0) / models.length;
  return [...byLabel].map(([label, models]) => ({ label, x: mean(models, 'x'), y: mean(models, 'y') }));
}

// Scales of equal units that show all points in an area.
export function mapScales(points, width, height) {
  const [xs, ys] = ['x', 'y'].map((key) => d3.extent(points, (one) => one[key]));
  const unit = Math.min(width / (xs[1] - xs[0] || 1), height / (ys[1] - ys[0] || 1));
  const around = ([low, high], pixels, sign) => d3.scaleLinear([low, high],
    [(pixels - sign * unit * (high - low)) / 2, (pixels + sign * unit * (high - low)) / 2]);
  return [around(xs, width, 1), around(ys, height, -1)];
}

function drawMap(state) {
  const { report, method } = state;
  stamp('map', [method.name, 'classical multidimensional scaling of the distances',
    report.pictures ? 'dots have the colours of classes' : 'colours of classes'],
    'Point at a model to see its class, click to open it; drag to move, Ctrl and wheel or two fingers to zoom');
  const container = byId('map-chart');
  const whole = widthIn(container, 1110);
  const { svg, area, width, height } = drawing(container, { width: whole, height: Math.min(700, 0.75 * whole),
    left: 30, right: 30, top: 26, bottom: 26, label: `Map of the models by ${method.name}` });
  const points = modelPoints(method.map, classOrder(report));
  const [x, y] = mapScales(points, width, height);
  const models = area.selectAll('g').data(points).enter().append('g').attr('class', 'placed')
    .attr('data-model', ({ model }) => model);
  models.filter(({ model }) => report.pictures && report.pictures.png[model]).append('image')
    .attr('href', ({ model }) => `data:image/png;base64,${report.pictures.png[model]}`)
    .attr('width', size[0]).attr('height', size[1]).attr('x', -size[0] / 2).attr('y', -size[1] / 2);
  models.append('circle').attr('r', report.pictures ? 3 : 5).attr('cy', report.pictures ? size[1] / 2 : 0)
    .style('fill', ({ model }) => colourOf(report.labels[model]));
  const names = area.selectAll('text').data(classMiddles(points, report.labels)).enter().append('text')
    .attr('class', 'class-name').text(({ label }) => shortened(report.classes[label], 20));
  const fade = (label) => models.classed('faded', ({ model }) => label !== null && report.labels[model] !== label);
  models.on('pointermove', ({ model }) => {
    fade(report.labels[model]);
    tooltip.show(d3.event.clientX, d3.event.clientY, tipHead(`${report.ids[model]}, ${state.className(model)}`),
      ...(report.pictures ? [picture(report, model)] : []));
  }).on('pointerleave', () => {
    fade(null);
    tooltip.hide();
  }).on('click', ({ model }) => state.openShape(model));
  const put = (transform) => {
    const [across, up] = [transform.rescaleX(x), transform.rescaleY(y)];
    for (const marks of [models, names]) {
      marks.attr('transform', (one) => `translate(${across(one.x)},${up(one.y)})`);
    }
  };
  const zoom = d3.zoom().scaleExtent([0.5, 40]).filter(() => d3.event.type !== 'wheel' || d3.event.ctrlKey)
    .on('zoom', () => put(d3.event.transform));
  svg.call(zoom).on('dblclick.zoom', null);
  put(d3.zoomIdentity);
  container.append(saveButton(svg.node(), 'map'));
}
