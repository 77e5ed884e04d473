// The share of the area at each value, in bins that can be brushed.

import { drawing } from '../common/chart.mjs';

// Shares of the area in so many bins from low to high; values beyond are in the first and in the last.
export function binShares(values, weights, low, high, bins) {
  const shares = new Array(bins).fill(0);
  values.forEach((value, place) => {
    if (Number.isNaN(value)) return;
    const bin = high > low ? Math.floor((bins * (value - low)) / (high - low)) : 0;
    shares[Math.max(0, Math.min(bins - 1, bin))] += weights[place];
  });
  return shares;
}

// The bins after a key, [first, last]; null where it selects none, undefined where it does nothing.
export function selectionAfter(selected, { key, shiftKey }, bins) {
  if (key === 'Escape') return selected ? null : undefined;
  const step = { ArrowLeft: -1, ArrowRight: 1 }[key];
  if (!step) return undefined;
  const within = (bin) => Math.max(0, Math.min(bins - 1, bin));
  if (!selected) return step > 0 ? [0, 0] : [bins - 1, bins - 1];
  const [first, last] = selected;
  return shiftKey ? [first, Math.max(first, within(last + step))] : [within(first + step), within(first + step)];
}

// Draws the bars and axes. Returns the drawing, its bars and the scale of the values.
function drawBars(place, { shares, low, high, label, width: wanted, colourOf, ticks }) {
  const bins = shares.length;
  const { svg, area, width, height } =
    drawing(place, { width: wanted, height: 170, left: 44, right: 12, top: 8, bottom: 26, label });
  const x = d3.scaleLinear([low, high > low ? high : low + 1], [0, width]);
  const y = d3.scaleLinear([0, Math.max(...shares) || 1], [height, 0]).nice(3);
  y.domain([0, Math.min(1, y.domain()[1])]);
  area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(3).tickSize(-width).tickFormat(''));
  const bars = area.append('g').selectAll('rect').data(shares).enter().append('rect')
    .attr('x', (_, bin) => (width * bin) / bins).attr('width', Math.max(0.5, width / bins - 0.5))
    .attr('y', y).attr('height', (share) => height - y(share)).style('fill', (_, bin) => colourOf(bin));
  const axis = d3.axisBottom(x).ticks(5);
  if (ticks) axis.tickValues(ticks).tickFormat((value) => String(value + 1));
  area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(axis);
  area.append('g').attr('class', 'axis').call(d3.axisLeft(y).ticks(3, '%'));
  return { svg, area, width, height, bars, x };
}

export class ValueHistogram {
  // options: as drawBars() takes them, and chosen(first, last), which receives the bins that are brushed, or nothing
  // where none are.
  constructor(place, options) {
    Object.assign(this, drawBars(place, options));
    this.chosen = options.chosen;
    this.bins = options.shares.length;
    this.selected = null; // [first, last]
    this.moving = false; // the brush, by select()
    this.marked = this.area.append('line').attr('class', 'level').attr('y1', 0).attr('y2', this.height)
      .style('display', 'none');
    this.brush = d3.brushX().extent([[0, 0], [this.width, this.height]]);
    this.brushed = this.area.append('g').attr('class', 'brush');
    this.brushed.call(this.brush.on('brush end', () => this.followBrush(d3.event)));
    this.svg.attr('tabindex', 0).on('keydown', () => this.followKey(d3.event));
  }

  // Shows bins as selected, or none.
  select(first, last) {
    const edge = (bin) => (this.width * bin) / this.bins;
    this.selected = first === undefined ? null : [first, last];
    this.bars.style('opacity', (_, bin) => (this.selected && (bin < first || bin > last) ? 0.25 : 1));
    this.moving = true;
    this.brushed.call(this.brush.move, this.selected && [edge(first), edge(last + 1)]);
    this.moving = false;
  }

  // Marks a value; null: none.
  mark(value) {
    const there = value !== null && !Number.isNaN(value);
    this.marked.style('display', there ? null : 'none');
    if (there) this.marked.attr('x1', this.x(value)).attr('x2', this.x(value));
  }

  choose(...range) {
    this.select(...range);
    this.chosen(...range);
  }

  binAt(x) {
    return Math.max(0, Math.min(this.bins - 1, Math.floor((this.bins * x) / this.width)));
  }

  followBrush({ type, selection, sourceEvent }) {
    if (this.moving || !sourceEvent) return;
    if (selection) {
      const range = [this.binAt(selection[0] + 0.01), this.binAt(selection[1] - 0.01)];
      if (type === 'end') this.choose(...range);
      else this.chosen(...range);
    } else if (type === 'end') { // a click
      const bin = this.binAt(d3.mouse(this.area.node())[0]);
      const again = this.selected && this.selected.every((end) => end === bin);
      this.choose(...(again ? [] : [bin, bin]));
    }
  }

  followKey(event) {
    const range = selectionAfter(this.selected, event, this.bins);
    if (range === undefined) return;
    event.preventDefault();
    if (range === null) event.stopPropagation(); // Escape would close a dialog, too
    this.choose(...(range || []));
  }
}
