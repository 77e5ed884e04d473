// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a multi-dataset experiment, and the reader's choices.

import { ReportState } from '../report/report_state.mjs';

const unique = (values) => [...new Set(values)];

export class MultiDatasetState extends ReportState {
  // results: as multi_dataset_page.cpp writes it.
  constructor(results) {
    const protocols = unique(results.tables.map(({ protocol }) => protocol));
    const measures = unique(results.tables.map(({ measure }) => measure));
    const evaluations = protocols.map((protocol) => ({ protocol, measures }));
    super({ ...results, methods: results.methods.map((name) => ({ name, evaluations })) });
    this.chosen.measure = Math.max(0, measures.indexOf(results.main_measure));
    this.protocols = protocols;
  }

  get measure() { return this.evaluation.measures[this.chosen.measure]; }
  get words() { return [this.measure, this.protocolWords, this.averageWords]; }

  // The table of the chosen protocol, average and measure.
  get table() {
    const { measure, evaluation: { protocol }, chosen: { average } } = this;
    return this.report.tables.find((table) =>
      table.protocol === protocol && table.average === average && table.measure === measure);
  }
}

// Wins, ties and losses of each method against each other one: texts by row and column, and whether they differ.
export function contests({ pairs }, count, alpha = 0.05) {
  const rows = Array.from({ length: count }, () => Array.from({ length: count }, () => null));
  for (const { first, second, p, counts: [wins, ties, losses] } of pairs) {
    rows[first][second] = { text: `${wins} / ${ties} / ${losses}`, wins, significant: p <= alpha };
    rows[second][first] = { text: `${losses} / ${ties} / ${wins}`, wins: losses, significant: p <= alpha };
  }
  return rows;
}
