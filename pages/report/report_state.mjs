// SPDX-License-Identifier: GPL-3.0-or-later
// A report and what its reader chose to see of it.

export class ReportState {
  // report: as report_json.cpp writes it. Positions: of the method, of the protocol, of the measure; hidden: methods
  // that charts leave out.
  constructor(report) {
    this.report = report;
    const { measures } = report.methods[0].evaluations[0];
    this.chosen = {
      method: 0, protocol: 0, average: 'micro', measure: Math.max(0, measures.indexOf('FT')), hidden: new Set(),
    };
    this.drawings = [];
  }

  // Draws a part of the page now and whenever one of these keys of `chosen` changes.
  show(keys, draw) {
    this.drawings.push({ keys, draw });
    draw();
  }

  change(values) {
    Object.assign(this.chosen, values);
    for (const { keys, draw } of this.drawings) {
      if (keys.some((key) => key in values)) draw();
    }
  }

  get method() { return this.report.methods[this.chosen.method]; }
  get evaluation() { return this.evaluationOf(this.chosen.method); }
  get methodIndices() { return this.report.methods.map((_, index) => index); }
  get visibleMethods() { return this.methodIndices.filter((index) => !this.chosen.hidden.has(index)); }
  get averageWords() {
    return this.chosen.average === 'micro' ? 'mean over queries (micro)' : 'mean over classes (macro)';
  }
  get classWords() { return [this.protocolWords, 'mean over the queries of a class']; }
  get highest() { return 1; } // of the values of classes
  get protocolWords() { return `protocol ${this.evaluation.protocol}`; }

  evaluationOf(index) { return this.report.methods[index].evaluations[this.chosen.protocol]; }
  className(model) { return this.report.classes[this.report.labels[model]]; }

  // The measures of a query, by its position, as [name, value]; the mean average precision of one is its AP.
  queryValues(position) {
    const { measures, per_query: values } = this.evaluation;
    return measures.map((measure, index) => [measure === 'mAP' ? 'AP' : measure, values[position][index]]);
  }
}
