// A measure class by class: bars, and the same as a table.

drawClasses.order = 0;
const classOrders = ['as in the data set', 'lowest first', 'highest first'];

function drawClasses() {
  const { measures, classes } = evaluation();
  const measure = measures[state.measure];
  const tools = byId('classes-tools');
  if (!tools.hasChildNodes()) {
    tools.append(choice('Measure', measures, state.measure, (index) => change({ measure: index })),
      choice('Order', classOrders, drawClasses.order, (index) => { drawClasses.order = index; drawClasses(); }));
  }
  drawLegend(byId('classes-legend'));
  const order = classOrders[drawClasses.order];
  stamp('classes', [`${measure} of each class`, protocolWords(), 'mean over the queries of a class', 'in percent'],
    drawClasses.order > 0 ? `Classes ${order} by ${method().name}` : `Classes ${order}`);
  const rows = classes.map((_, position) => position);
  const own = (position) => evaluation().per_class[position][state.measure];
  if (drawClasses.order > 0) rows.sort((a, b) => (drawClasses.order === 1 ? 1 : -1) * (own(a) - own(b)));
  drawBars(byId('classes-chart'), rows, measure);
  drawClassTable(rows, measure);
}

const classValue = (index, position) => evaluationOf(index).per_class[position][state.measure];

function drawBars(place, rows, measure) {
  const shown = visibleMethods();
  const bar = shown.length > 3 ? 6 : 9;
  const step = Math.max(16, bar * shown.length + 8);
  const { svg, area, width, height } = drawing(place, {
    width: widthIn(place, 1000), height: rows.length * step + 46, left: 170, right: 20, top: 6, bottom: 40, label: `${measure} by class, ${protocolWords()}`,
  });
  const x = d3.scaleLinear([0, 100], [0, width]);
  area.append('g').attr('class', 'grid').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(10).tickSize(-height).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(10));
  area.append('text').attr('x', width / 2).attr('y', height + 34).attr('text-anchor', 'middle').text(`${measure} (percent)`);
  rows.forEach((position, row) => {
    const name = report.classes[evaluation().classes[position]];
    const group = area.append('g').attr('class', 'bar-row').attr('transform', `translate(0,${row * step})`);
    group.append('rect').attr('class', 'bar-ground').attr('x', -170).attr('width', width + 170).attr('height', step);
    group.append('text').attr('x', -8).attr('y', step / 2).attr('dy', '0.32em').attr('text-anchor', 'end').text(shortened(name, 26));
    shown.forEach((index, place_) => {
      group.append('rect').attr('y', (step - bar * shown.length) / 2 + place_ * bar).attr('height', bar - 1)
        .attr('width', x(100 * classValue(index, position))).style('fill', colourOf(index));
    });
    group.on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY, tipHead(`${name}: ${measure}`),
      ...shown.map((index) => tipLine([swatch(index), report.methods[index].name], percent(classValue(index, position))))));
    group.on('pointerleave', tooltip.hide);
  });
  place.append(saveButton(svg.node(), `classes_${measure}_${evaluation().protocol}`));
}

const shortened = (text, length) => (text.length > length ? `${text.slice(0, length - 1)}\u2026` : text);

function drawClassTable(rows, measure) {
  const counts = new Map();
  for (const label of report.labels) counts.set(label, (counts.get(label) || 0) + 1);
  const columns = [{ title: 'Class', text: (position) => report.classes[evaluation().classes[position]] },
    { title: 'Models', numeric: true, value: (position) => counts.get(evaluation().classes[position]), text: (position) => String(counts.get(evaluation().classes[position])) }];
  report.methods.forEach(({ name }, index) => {
    const value = (position) => classValue(index, position);
    columns.push({ title: name, numeric: true, value, text: (position) => percent(value(position)) });
  });
  sortableTable(byId('classes-table'), { caption: `${measure} by class, ${protocolWords()}, percent`, columns, rows });
}
