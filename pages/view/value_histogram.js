// The share of the area at each value, in bins that can be brushed.

// Shares of the area in so many bins from low to high.
function binShares(values, weights, low, high, bins) {
  const shares = new Array(bins).fill(0);
  values.forEach((value, place) => {
    if (Number.isNaN(value)) return;
    const bin = high > low ? Math.floor((bins * (value - low)) / (high - low)) : 0;
    shares[Math.max(0, Math.min(bins - 1, bin))] += weights[place];
  });
  return shares;
}

// chosen(first, last) is called with the bins that are brushed, or with nothing where none are. Answers what moves its
// marks from outside: mark(value) and select(first, last).
function valueHistogram(place, { shares, low, high, label, width, colourOf, ticks, chosen }) {
  const bins = shares.length;
  const high1 = high > low ? high : low + 1;
  const { svg, area, width: wide, height } = drawing(place, { width, height: 170, left: 44, right: 12, top: 8, bottom: 26, label });
  const x = d3.scaleLinear([low, high1], [0, wide]);
  const y = d3.scaleLinear([0, Math.max(...shares) || 1], [height, 0]).nice(3);
  y.domain([0, Math.min(1, y.domain()[1])]);
  const edge = (bin) => (wide * bin) / bins;
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(3).tickSize(-wide).tickFormat(''));
  const bars = area.append('g').selectAll('rect').data(shares).enter().append('rect')
    .attr('x', (_, bin) => edge(bin)).attr('width', Math.max(0.5, wide / bins - 0.5))
    .attr('y', y).attr('height', (share) => height - y(share)).style('fill', (_, bin) => colourOf(bin));
  const axis = d3.axisBottom(x).ticks(5);
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(ticks ? axis.tickValues(ticks).tickFormat((value) => String(value + 1)) : axis);
  area.append('g').attr('class', 'axis').call(d3.axisLeft(y).ticks(3, '%'));
  const marked = area.append('line').attr('class', 'level').attr('y1', 0).attr('y2', height).style('display', 'none');

  let selected = null;
  let moving = false; // the brush, by show()
  const brushed = area.append('g').attr('class', 'brush');
  const brush = d3.brushX().extent([[0, 0], [wide, height]]);
  const show = (first, last) => {
    selected = first === undefined ? null : [first, last];
    bars.style('opacity', (_, bin) => (selected && (bin < first || bin > last) ? 0.25 : 1));
    moving = true;
    brushed.call(brush.move, selected && [edge(first), edge(last + 1)]);
    moving = false;
  };
  const choose = (first, last) => {
    show(first, last);
    chosen(first, last);
  };
  const binAt = (at) => Math.max(0, Math.min(bins - 1, Math.floor((bins * at) / wide)));
  const follow = () => {
    if (moving || !d3.event.sourceEvent) return;
    const ended = d3.event.type === 'end';
    if (d3.event.selection) {
      const [from, to] = d3.event.selection;
      const [first, last] = [binAt(from + 0.01), binAt(to - 0.01)];
      if (ended) choose(first, last);
      else chosen(first, last);
      return;
    }
    if (!ended) return;
    const bin = binAt(d3.mouse(area.node())[0]); // a click
    if (selected && selected[0] === bin && selected[1] === bin) choose();
    else choose(bin, bin);
  };
  brushed.call(brush.on('brush end', follow));
  svg.attr('tabindex', 0).on('keydown', () => {
    const { key, shiftKey } = d3.event;
    if (key === 'Escape' && selected) {
      d3.event.stopPropagation();
      d3.event.preventDefault();
      choose();
    }
    const step = { ArrowLeft: -1, ArrowRight: 1 }[key];
    if (!step) return;
    d3.event.preventDefault();
    const within = (bin) => Math.max(0, Math.min(bins - 1, bin));
    if (!selected) choose(step > 0 ? 0 : bins - 1, step > 0 ? 0 : bins - 1);
    else if (shiftKey) choose(selected[0], Math.max(selected[0], within(selected[1] + step)));
    else choose(within(selected[0] + step), within(selected[0] + step));
  });
  return {
    select: show,
    mark(value) {
      const there = value !== null && !Number.isNaN(value);
      marked.style('display', there ? null : 'none');
      if (there) marked.attr('x1', x(value)).attr('x2', x(value));
    },
  };
}
