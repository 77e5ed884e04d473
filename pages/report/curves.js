// Precision against recall, a curve a method.

drawCurves.whole = true;

// Where the axis of precision begins: at 0, or at the tenth below all that is shown.
function lowestPrecision() {
  const lowest = d3.min(visibleMethods(), (index) => d3.min(curveOf(index)));
  return drawCurves.whole || lowest === undefined ? 0 : Math.min(0.9, Math.floor(10 * lowest) / 10);
}

function drawCurves() {
  const tools = byId('curves-tools');
  if (!tools.hasChildNodes()) {
    tools.append(choice('Precision', ['from 0', 'from the lowest shown'], 0, (index) => { drawCurves.whole = index === 0; drawCurves(); }));
  }
  drawLegend(byId('curves-legend'));
  stamp('curves', [protocolWords(), averageWords(), 'fractions'], 'Point at the chart, or use the arrow keys in it, to read values');
  const place = byId('curves-chart');
  const { recall } = evaluation();
  const { svg, area, width, height } = drawing(place, {
    width: widthIn(place, 980), height: 470, left: 56, right: 16, top: 10, bottom: 44,
    label: `Precision-recall curves, ${protocolWords()}, ${averageWords()}`,
  });
  const x = d3.scaleLinear([0, 1], [0, width]);
  const y = d3.scaleLinear([lowestPrecision(), 1], [height, 0]);
  drawAxes(area, x, y, width, height);
  for (const index of visibleMethods()) drawCurve(area, x, y, index);
  readValues(svg.node(), area, x, height, recall);
  place.append(saveButton(svg.node(), `precision_recall_${evaluation().protocol}_${state.average}`));
}

const curveOf = (index) => evaluationOf(index)[`${state.average}_curve`];

function drawAxes(area, x, y, width, height) {
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(10).tickSize(-width).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(10));
  area.append('g').attr('class', 'axis precision').call(d3.axisLeft(y).ticks(10));
  area.append('text').attr('x', width / 2).attr('y', height + 38).attr('text-anchor', 'middle').text('Recall');
  area.append('text').attr('transform', `translate(-42,${height / 2}) rotate(-90)`).attr('text-anchor', 'middle').text('Precision');
}

function drawCurve(area, x, y, index) {
  const points = curveOf(index).map((precision, level) => [x(evaluation().recall[level]), y(precision)]);
  const group = area.append('g').attr('class', 'method').attr('data-method', index);
  group.append('path').attr('class', 'curve').attr('d', d3.line()(points))
    .style('stroke', colourOf(index)).style('stroke-dasharray', dashesOf(index));
  group.selectAll('.sign').data(points).enter().append('path').attr('class', 'sign')
    .attr('transform', (point) => `translate(${point})`).attr('d', signOf(index)).style('fill', colourOf(index));
}

// A rule at the level of recall nearest to the pointer, or moved by the arrow keys, with the values there.
function readValues(svg, area, x, height, recall) {
  const rule = area.append('line').attr('class', 'level').attr('y1', 0).attr('y2', height).style('display', 'none');
  let level = 0;
  const read = (place) => {
    rule.style('display', null).attr('x1', x(recall[level])).attr('x2', x(recall[level]));
    const lines = visibleMethods().sort((a, b) => curveOf(b)[level] - curveOf(a)[level])
      .map((index) => tipLine([swatch(index), report.methods[index].name], curveOf(index)[level].toFixed(4)));
    tooltip.show(place.x, place.y, tipHead(`Recall ${number(recall[level])}`), ...lines);
  };
  const leave = () => { rule.style('display', 'none'); tooltip.hide(); };
  const onScreen = () => {
    const { left, top } = rule.node().getBoundingClientRect();
    return { x: left, y: top + 40 };
  };
  svg.addEventListener('pointermove', (event) => {
    const place = d3.clientPoint(area.node(), event)[0];
    level = d3.scan(recall, (a, b) => Math.abs(x(a) - place) - Math.abs(x(b) - place));
    read({ x: event.clientX, y: event.clientY });
  });
  svg.addEventListener('pointerleave', leave);
  svg.setAttribute('tabindex', 0);
  svg.addEventListener('blur', leave);
  svg.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === 'Escape') leave();
    if (!step) return;
    event.preventDefault();
    level = Math.max(0, Math.min(recall.length - 1, level + step));
    read(onScreen());
  });
}
