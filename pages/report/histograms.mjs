// SPDX-License-Identifier: GPL-3.0-or-later
// The histograms of a model.

import { drawing } from '../common/chart.mjs';
import { make } from '../common/elements.mjs';
import { scaledNumbers } from '../common/packed.mjs';
import { number, percent } from '../common/words.mjs';
import { colourOf } from './method_look.mjs';
import { saveButton } from './svg_file.mjs';

// The methods with histograms that a method stands for: itself, or those that it has side by side.
export function histogramMethods(methods, index) {
  const { histograms, parts } = methods[index];
  return histograms ? [index] : parts.flatMap((part) => histogramMethods(methods, part));
}

// Makes charts of histograms, whose numbers are unpacked once a method.
export class HistogramCharts {
  constructor(report) {
    this.report = report;
    this.numbers = new Map();
  }

  // The elements for a model and a method; none where the method has no histograms.
  elements(model, method) {
    const indices = histogramMethods(this.report.methods, method);
    if (indices.length === 0) return [];
    const title = make('h3', {}, indices.length > 1 ? 'Histograms' : 'Histogram');
    return [title, ...indices.map((index) => this.chartOrReason(model, index))];
  }

  chartOrReason(model, index) {
    const method = this.report.methods[index];
    const failure = method.failures.find(([id]) => id === this.report.ids[model]);
    return failure ? make('p', {}, `${method.name}: ${failure[1]}`) : this.chart(model, index);
  }

  binsOf(model, index) {
    const { histograms } = this.report.methods[index];
    if (!this.numbers.has(index)) this.numbers.set(index, scaledNumbers(histograms));
    return this.numbers.get(index).subarray(model * histograms.bins, (model + 1) * histograms.bins);
  }

  chart(model, index) {
    const { histograms, name } = this.report.methods[index];
    const bins = this.binsOf(model, index);
    const [low, high] = histograms.ranges[model];
    const edge = (bin) => low + ((high - low) * bin) / bins.length;
    const container = make('div', { class: 'chart histogram' });
    const { svg, area, width, height } = drawing(container, {
      width: Math.max(420, Math.min(880, window.innerWidth - 90)), height: 190,
      left: 50, right: 14, top: 22, bottom: 38, label: `Histogram of ${this.report.ids[model]}, ${name}`,
    });
    const x = d3.scaleLinear([low, high], [0, width]);
    const y = d3.scaleLinear([0, Math.max(...bins)], [height, 0]).nice(4);
    area.append('g').attr('class', 'grid').call(d3.axisLeft(y).ticks(4).tickSize(-width).tickFormat(''));
    area.append('text').attr('x', 0).attr('y', -8).text(name);
    bins.forEach((part, bin) => {
      area.append('rect').attr('x', (width * bin) / bins.length).attr('width', Math.max(0.5, width / bins.length - 0.6))
        .attr('y', y(part)).attr('height', height - y(part)).style('fill', colourOf(index))
        .append('title').text(`${number(edge(bin))} to ${number(edge(bin + 1))}: ${percent(part)} % of the area`);
    });
    area.append('g').attr('class', 'axis').attr('transform', `translate(0,${height})`).call(d3.axisBottom(x).ticks(8));
    area.append('g').attr('class', 'axis').call(d3.axisLeft(y).ticks(4));
    area.append('text').attr('x', width / 2).attr('y', height + 34).attr('text-anchor', 'middle')
      .text('Field value (shape of unit area)');
    container.append(saveButton(svg.node(), `histogram_${model}`));
    return container;
  }
}
