// The queries that did worst, each with what was nearest to it.

drawQueries.shown = 8;

// The value of a query (by position) under a measure.
const queryValues = (position) => evaluation().measures.map((measure, index) => [measure, evaluation().per_query[position][index]]);

function drawQueries() {
  const { worst, queries, measures } = evaluation();
  const by = measures.includes('mAP') ? 'average precision' : measures[0];
  stamp('queries', [method().name, protocolWords(), `lowest ${by} first`, 'measures in percent'], 'The ten nearest from left to right: \u2713 of the query\u2019s class, \u2717 of another');
  byId('queries-list').replaceChildren(...worst.slice(0, drawQueries.shown).map((position) => queryItem(queries[position], position)));
  const more = byId('queries-more');
  more.hidden = drawQueries.shown >= worst.length;
  more.textContent = `Show all ${worst.length}`;
  more.onclick = () => { drawQueries.shown = Infinity; drawQueries(); };
}

function queryItem(model, position) {
  const values = queryValues(position).map(([name, value]) => [name === 'mAP' ? 'AP' : name, percent(value)]);
  return make('li', {}, shapeButton(model, className(model)),
    make('dl', {}, ...values.flatMap(([name, value]) => [make('dt', {}, name), make('dd', {}, value)])), nearestStrip(model));
}

function nearestStrip(model) {
  const { models, lists, distances } = method().nearest;
  const row = models.indexOf(model);
  const strip = make('div', { class: 'strip' });
  if (row < 0) return make('p', {}, 'The nearest models are listed for the worst queries only in data sets of this size.');
  lists[row].forEach((other, rank) => strip.append(nearestButton(model, other, rank, distances[row][rank])));
  return strip;
}

function nearestButton(model, other, rank, distance) {
  const right = report.labels[model] === report.labels[other];
  const button = shapeButton(other, className(other), right ? 'right' : 'wrong');
  button.querySelector('.id').prepend(make('span', { class: 'mark' }, right ? '\u2713 ' : '\u2717 '));
  button.title = `Rank ${rank + 1}: ${report.ids[other]}, ${className(other)}, distance ${number(distance)}`;
  return button;
}
