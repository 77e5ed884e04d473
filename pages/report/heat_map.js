// The distance matrix of a method as a picture, its rows and columns ordered by class.

const modelOrder = report.labels.map((_, model) => model).sort((a, b) => report.labels[a] - report.labels[b] || a - b);

function cellsOf({ side, symmetric, ...packed }) {
  const numbers = unpack(packed);
  if (!symmetric) return numbers;
  const cells = new Float64Array(side * side);
  let next = 0;
  for (let row = 0; row < side; ++row) {
    for (let column = row; column < side; ++column) {
      cells[row * side + column] = cells[column * side + row] = numbers[next++];
    }
  }
  return cells;
}

const viridis = d3.range(256).map((level) => d3.rgb(d3.interpolateViridis(level / 255)));

function paint(canvas, cells, side, largest) {
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  const image = context.createImageData(side, side);
  cells.forEach((value, index) => {
    const colour = Number.isFinite(value) ? viridis[Math.min(255, Math.round((255 * value) / largest))] : { r: 160, g: 160, b: 160 };
    image.data.set([colour.r, colour.g, colour.b, 255], 4 * index);
  });
  context.putImageData(image, 0, 0);
}

function drawHeatMap() {
  const { heat_map: map, name } = method();
  const cells = cellsOf(map);
  const finite = Float64Array.from(cells.filter(Number.isFinite)).sort();
  const largest = finite[Math.floor(0.99 * (finite.length - 1))] || 1;
  stamp('distances', [name, 'rows are queries', 'rows and columns in the order of the classes',
    ...(map.block > 1 ? [`each cell the mean over ${map.block} by ${map.block} models`] : [])], 'Point at a cell, or move with the arrow keys, to see the pair; click for the query');
  const canvas = make('canvas', { role: 'img', tabindex: 0, 'aria-label': `Distance matrix of ${name}, ordered by class` });
  paint(canvas, cells, map.side, largest);
  readCells(canvas, cells, map);
  const ticks = d3.ticks(0, largest, 4);
  byId('distances-chart').replaceChildren(make('div', { class: 'heat' }, classNames(), canvas),
    colourScale('Distance; the largest hundredth in the last colour:', ticks, (value) => value / largest));
}

// The names of the classes beside their rows; where they are too many, every so many.
function classNames() {
  const names = make('div', { class: 'names', 'aria-hidden': 'true' });
  const models = modelOrder.length;
  let last = -1;
  for (let begin = 0; begin < models;) {
    let end = begin;
    while (end < models && report.labels[modelOrder[end]] === report.labels[modelOrder[begin]]) ++end;
    const middle = (begin + end) / 2 / models;
    if (middle - last > 0.018) {
      names.append(make('span', { style: `top:${100 * middle}%` }, className(modelOrder[begin])));
      last = middle;
    }
    begin = end;
  }
  return names;
}

function readCells(canvas, cells, { side, block }) {
  let row = 0;
  let column = 0;
  const group = (cell) => modelOrder.slice(cell * block, (cell + 1) * block);
  const words = (cell) => {
    const models = group(cell);
    const first = `${report.ids[models[0]]} (${className(models[0])})`;
    return models.length > 1 ? `${first} and ${models.length - 1} more` : first;
  };
  const read = (x, y) => {
    const value = cells[row * side + column];
    const children = [tipHead(number(Number.isFinite(value) ? value : null)), make('div', {}, `query ${words(row)}`), make('div', {}, `model ${words(column)}`)];
    if (block === 1 && report.pictures) children.push(make('div', { class: 'pair' }, picture(modelOrder[row], 90), picture(modelOrder[column], 90)));
    tooltip.show(x, y, ...children);
  };
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    const cell = (place, size) => Math.max(0, Math.min(side - 1, Math.floor((place / size) * side)));
    column = cell(event.clientX - box.left, box.width);
    row = cell(event.clientY - box.top, box.height);
  };
  canvas.addEventListener('pointermove', (event) => { at(event); read(event.clientX, event.clientY); });
  canvas.addEventListener('pointerleave', tooltip.hide);
  canvas.addEventListener('blur', tooltip.hide);
  canvas.addEventListener('click', (event) => { at(event); openShape(group(row)[0]); });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
    if (event.key === 'Enter') openShape(group(row)[0]);
    if (!step) return;
    event.preventDefault();
    const within = (cell) => Math.max(0, Math.min(side - 1, cell));
    row = within(row + step[0]);
    column = within(column + step[1]);
    const box = canvas.getBoundingClientRect();
    read(box.left + ((column + 0.5) / side) * box.width, box.top + ((row + 0.5) / side) * box.height);
  });
}
