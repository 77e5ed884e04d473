// The data, what the reader chose to see, and words for it.

const report = JSON.parse(byId('report-data').textContent);

// What is shown. Positions: of the method, of the protocol; hidden: methods that charts leave out.
const measureNames = report.methods[0].evaluations[0].measures;
const state = { method: 0, protocol: 0, average: 'micro', measure: Math.max(0, measureNames.indexOf('FT')), hidden: new Set() };

const views = [];

// Draws a part of the page now and whenever one of these keys of the state changes.
function show(keys, draw) {
  views.push({ keys, draw });
  draw();
}

function change(values) {
  Object.assign(state, values);
  for (const { keys, draw } of views) {
    if (keys.some((key) => key in values)) draw();
  }
}

const method = () => report.methods[state.method];
const evaluationOf = (index) => report.methods[index].evaluations[state.protocol];
const evaluation = () => evaluationOf(state.method);
const visibleMethods = () => report.methods.map((_, index) => index).filter((index) => !state.hidden.has(index));
const className = (model) => report.classes[report.labels[model]];

const averageWords = () => (state.average === 'micro' ? 'mean over queries (micro)' : 'mean over classes (macro)');
const protocolWords = () => `protocol ${evaluation().protocol}`;

// Says under a section's title what it shows.
function stamp(section, words, ...hints) {
  const sentences = [words.join(', '), ...hints].map((text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`);
  byId(section).querySelector('.stamp').textContent = sentences.join(' ');
}

// A method's colour, dashes and sign: alike in all charts. Methods of one colour differ in both others.
const methodColours = 7;
const dashes = ['none', '7 3', '2 3', '9 3 2 3', '12 4', '5 2 1 2 1 2', '3 2'];
const signs = [d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolStar, d3.symbolWye];
const shifted = (index) => (index + Math.floor(index / methodColours)) % methodColours;
const colourOf = (index) => `var(--method-${index % methodColours})`;
const dashesOf = (index) => dashes[shifted(index)];
const signOf = (index) => d3.symbol().type(signs[shifted(index)]).size(34)();

function swatch(index) {
  const svg = d3.create('svg').attr('class', 'swatch').attr('viewBox', '0 0 34 10').attr('aria-hidden', 'true');
  svg.append('line').attr('x1', 0).attr('x2', 34).attr('y1', 5).attr('y2', 5)
    .style('stroke', colourOf(index)).style('stroke-dasharray', dashesOf(index));
  svg.append('path').attr('transform', 'translate(17,5)').attr('d', signOf(index)).style('fill', colourOf(index));
  return svg.node();
}

// Numbers that were packed in two bytes each; null where there is none.
function unpack({ scale, values }) {
  const bytes = bytesOf(values);
  const numbers = new Float64Array(bytes.length / 2);
  for (let i = 0; i < numbers.length; ++i) {
    const level = bytes[2 * i] + 256 * bytes[2 * i + 1];
    numbers[i] = level === 65535 ? Infinity : (scale * level) / 65534;
  }
  return numbers;
}
