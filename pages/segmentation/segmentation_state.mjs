// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of a segmentation experiment, as a report has the measures of methods.

import { ReportState } from '../report/report_state.mjs';

export class SegmentationState extends ReportState {
  // page: as segmentation_page.cpp writes it.
  constructor({ classes, labels, errors: { methods, by_class: byClass } }) {
    const evaluation = (method) => ({
      protocol: '', measures: ['Rand error'], classes: classes.map((_, label) => label),
      per_class: byClass.map((errors) => [errors[method] === null ? NaN : errors[method]]),
    });
    super({ classes, labels, methods: methods.map((name, method) => ({ name, evaluations: [evaluation(method)] })) });
  }

  get classWords() { return ['mean over the shapes of a class']; }

  // The errors are far below 1: up to the next tenth.
  get highest() {
    const errors = this.report.methods.flatMap(({ evaluations }) => evaluations[0].per_class.flat());
    return Math.ceil(10 * Math.max(0.1, ...errors.filter((error) => !Number.isNaN(error)))) / 10;
  }
}
