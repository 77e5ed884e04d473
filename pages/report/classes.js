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
  const crowded = visibleMethods().length > methodColours;
  const order = classOrders[drawClasses.order];
  stamp('classes', [`${measure} of each class`, protocolWords(), 'mean over the queries of a class', 'in percent'],
    drawClasses.order > 0 ? `Classes ${order} by ${method().name}` : `Classes ${order}`, ...(crowded ? ['The fuller the colour, the higher the value'] : []));
  const rows = classes.map((_, position) => position);
  const own = (position) => evaluation().per_class[position][state.measure];
  if (drawClasses.order > 0) rows.sort((a, b) => (drawClasses.order === 1 ? 1 : -1) * (own(a) - own(b)));
  (crowded ? drawCells : drawBars)(byId('classes-chart'), rows, measure);
  drawClassTable(rows, measure);
}

const classValue = (index, position) => evaluationOf(index).per_class[position][state.measure];

// A row of a chart, with what its drawings share: a ground, the class' name, all values where the pointer is.
function classRow(area, position, measure, { top, left, width, height }) {
  const name = report.classes[evaluation().classes[position]];
  const group = area.append('g').attr('class', 'bar-row').attr('transform', `translate(0,${top})`);
  group.append('rect').attr('class', 'bar-ground').attr('x', -left).attr('width', width + left).attr('height', height);
  group.append('text').attr('x', -8).attr('y', height / 2).attr('dy', '0.32em').attr('text-anchor', 'end').text(shortened(name, 26));
  group.on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY, tipHead(`${name}: ${measure}`),
    ...visibleMethods().map((index) => tipLine([swatch(index), report.methods[index].name], percent(classValue(index, position))))));
  group.on('pointerleave', tooltip.hide);
  return group;
}

const saveClasses = (svg, measure) => saveButton(svg.node(), `classes_${measure}_${evaluation().protocol}`);

// For no more methods than there are colours.
function drawBars(place, rows, measure) {
  const shown = visibleMethods();
  const bar = shown.length > 3 ? 6 : 9;
  const step = Math.max(16, bar * shown.length + 8);
  const left = 170;
  const { svg, area, width, height } = drawing(place, {
    width: widthIn(place, 1000), height: rows.length * step + 46, left, right: 20, top: 6, bottom: 40, label: `${measure} by class, ${protocolWords()}`,
  });
  const x = d3.scaleLinear([0, 100], [0, width]);
  area.append('g').attr('class', 'grid').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(10).tickSize(-height).tickFormat(''));
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(10));
  area.append('text').attr('x', width / 2).attr('y', height + 34).attr('text-anchor', 'middle').text(`${measure} (percent)`);
  rows.forEach((position, row) => {
    const group = classRow(area, position, measure, { top: row * step, left, width, height: step });
    shown.forEach((index, place_) => {
      group.append('rect').attr('data-method', index).attr('y', (step - bar * shown.length) / 2 + place_ * bar).attr('height', bar - 1)
        .attr('width', x(100 * classValue(index, position))).style('fill', colourOf(index));
    });
  });
  place.append(saveClasses(svg, measure));
}

// For more: a row a class, a column a method, the values in colour from the lowest shown to the highest.
function drawCells(place, rows, measure) {
  const shown = visibleMethods();
  const step = 21;
  const left = 170;
  const names = shown.map((index) => shortened(report.methods[index].name, 30));
  const space = 12 + 6.4 * Math.max(...names.map((name) => name.length));
  const right = Math.min(100, 0.5 * space);
  const { svg, area, width } = drawing(place, {
    width: widthIn(place, 1110), height: rows.length * step + 0.87 * space + 4, left, right, top: 0.87 * space, bottom: 4, label: `${measure} by class, ${protocolWords()}`,
  });
  const cell = Math.min(64, width / shown.length);
  const digits = [42, 35, 22].findIndex((needed) => cell >= needed);
  const [lowest, highest] = d3.extent(shown.flatMap((index) => rows.map((position) => classValue(index, position))));
  shown.forEach((index, column) => {
    area.append('text').attr('data-method', index).attr('transform', `translate(${(column + 0.5) * cell},-8) rotate(-60)`).text(names[column]);
  });
  rows.forEach((position, row) => {
    const group = classRow(area, position, measure, { top: row * step, left, width: cell * shown.length, height: step });
    shown.forEach((index, column) => {
      const value = classValue(index, position);
      const part = highest > lowest ? (value - lowest) / (highest - lowest) : 1;
      group.append('rect').attr('class', 'cell').attr('data-method', index).attr('x', column * cell).attr('width', cell - 1).attr('height', step - 1)
        .style('fill', `rgba(var(--accent-channels), ${0.05 + 0.5 * part})`);
      if (digits < 0) return;
      group.append('text').attr('data-method', index).attr('x', (column + 0.5) * cell).attr('y', step / 2).attr('dy', '0.32em')
        .attr('text-anchor', 'middle').style('font-size', '11px').text((100 * value).toFixed(2 - digits));
    });
  });
  place.append(saveClasses(svg, measure));
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
