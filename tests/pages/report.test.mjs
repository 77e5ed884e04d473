// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { methodColours } from '../../pages/common/constants.mjs';
import { mostChanged } from '../../pages/report/changes.mjs';
import { chosenBy } from '../../pages/report/choices.mjs';
import { orderedClasses } from '../../pages/report/classes.mjs';
import { classMiddles, modelPoints } from '../../pages/report/collection_map.mjs';
import { countConfusions } from '../../pages/report/confusions.mjs';
import { lowestPrecision } from '../../pages/report/curves.mjs';
import { filteredModels } from '../../pages/report/gallery.mjs';
import { histogramMethods } from '../../pages/report/histograms.mjs';
import { colourOf, dashesOf } from '../../pages/report/method_look.mjs';
import { ReportState } from '../../pages/report/report_state.mjs';
import { intervalOf } from '../../pages/report/summary.mjs';
import { bestText, sortedRows } from '../../pages/report/sortable_table.mjs';

function sampleReport() {
  const evaluation = (protocol) => ({ protocol, measures: ['NN', 'FT', 'mAP'], per_query: [[0, 0.5, 1]] });
  return {
    methods: ['a', 'b'].map((name) => ({ name, evaluations: ['psb', 'paper'].map(evaluation) })),
    classes: ['ants', 'cups'], ids: ['T1', 'T2', 'T3'], labels: [0, 1, 0],
  };
}

test('a change of state redraws each view that depends on it once and no other', () => {
  const state = new ReportState(sampleReport());
  const drawn = [];
  state.show(['method', 'protocol'], () => drawn.push('both'));
  state.show(['hidden'], () => drawn.push('hidden'));
  assert.deepEqual(drawn, ['both', 'hidden']);
  state.change({ method: 1, protocol: 1 });
  assert.deepEqual(drawn, ['both', 'hidden', 'both']);
  assert.equal(state.method.name, 'b');
  assert.equal(state.protocolWords, 'protocol paper');
});

test('the report initially shows FT and names mAP of a query AP', () => {
  const state = new ReportState(sampleReport());
  assert.equal(state.chosen.measure, 1);
  assert.deepEqual(state.queryValues(0), [['NN', 0], ['FT', 0.5], ['AP', 1]]);
});

test('hidden methods are excluded from the visible methods', () => {
  const state = new ReportState(sampleReport());
  state.change({ hidden: new Set([0]) });
  assert.deepEqual(state.visibleMethods, [1]);
});

test('methods of one colour differ in their dashes', () => {
  const looks = Array.from({ length: methodColours ** 2 }, (_, index) => `${colourOf(index)} ${dashesOf(index)}`);
  assert.equal(new Set(looks).size, looks.length);
});

test('table rows are sorted numerically or in natural order of texts', () => {
  const rows = [{ id: 'T10', value: 9 }, { id: 'T9', value: 10 }, { id: 'T1', value: 9 }];
  const columns = [{ text: ({ id }) => id }, { text: ({ value }) => String(value), value: ({ value }) => value }];
  const ids = (column, ascending) => sortedRows(rows, columns, { column, ascending }).map(({ id }) => id);
  assert.deepEqual(ids(0, true), ['T1', 'T9', 'T10']);
  assert.deepEqual(ids(1, false), ['T9', 'T10', 'T1']); // rows of equal value keep their order
  assert.equal(bestText(columns[1], rows), '10');
  assert.equal(bestText(columns[1], rows.slice(0, 1)), null);
});

test('the precision axis begins at the tenth below the lowest value', () => {
  assert.equal(lowestPrecision([[1, 0.57], [0.8, 0.62]], false), 0.5);
  assert.equal(lowestPrecision([[1, 0.57]], true), 0);
  assert.equal(lowestPrecision([[1, 1]], false), 0.9);
  assert.equal(lowestPrecision([], false), 0);
});

test('classes are sorted by value in ascending or descending order', () => {
  assert.deepEqual(orderedClasses([0.5, 0.9, 0.1], 0), [0, 1, 2]);
  assert.deepEqual(orderedClasses([0.5, 0.9, 0.1], 1), [2, 0, 1]);
  assert.deepEqual(orderedClasses([0.5, 0.9, 0.1], 2), [1, 0, 2]);
});

test('confusions between classes are counted and sorted by frequency', () => {
  const { totals, wrong } = countConfusions([[[0, 3], [1, 1]], [[0, 2], [2, 2]], [[1, 2], [2, 2]], []]);
  assert.deepEqual(totals, [4, 4, 4, 0]);
  assert.deepEqual(wrong, [
    { label: 1, other: 0, count: 2, part: 0.5 }, { label: 1, other: 2, count: 2, part: 0.5 },
    { label: 2, other: 1, count: 2, part: 0.5 }, { label: 0, other: 1, count: 1, part: 0.25 },
  ]);
});

test('the confidence interval shown is that of the chosen average and measure', () => {
  const intervals = { confidence: 0.95, micro: [[0.1, 0.2], [0.3, 0.4]], macro: [[0.5, 0.6], [0.7, 0.8]] };
  assert.deepEqual(intervalOf({ intervals }, 'macro', 1), [0.7, 0.8]);
  assert.equal(intervalOf({}, 'micro', 0), null);
  assert.equal(intervalOf({ intervals: null }, 'micro', 0), null);
});

test('the gallery filters models by words of ids and classes and by class', () => {
  const report = sampleReport();
  assert.deepEqual(filteredModels(report, { text: '', label: -1 }),
    [{ label: 0, models: [0, 2] }, { label: 1, models: [1] }]);
  assert.deepEqual(filteredModels(report, { text: 'cup', label: -1 }), [{ label: 1, models: [1] }]);
  assert.deepEqual(filteredModels(report, { text: 't3', label: 0 }), [{ label: 0, models: [2] }]);
  assert.deepEqual(filteredModels(report, { text: 't3', label: 1 }), []);
});

test('a concatenated method shows the histograms of its inputs', () => {
  const methods = [{ histograms: {}, parts: [] }, { histograms: {}, parts: [] }, { histograms: null, parts: [0, 1] },
    { histograms: null, parts: [2, 0] }, { histograms: null, parts: [] }];
  assert.deepEqual(histogramMethods(methods, 1), [1]);
  assert.deepEqual(histogramMethods(methods, 3), [0, 1, 0]);
  assert.deepEqual(histogramMethods(methods, 4), []);
});

test('changed queries are sorted by the size of the change and unchanged ones omitted', () => {
  const values = [[0, 0.5], [1, 0.2], [0, 0.9], [1, 0.4]];
  const others = [[1, 0.6], [0, 0.2], [1, 0.4], [0, 0.5]];
  assert.deepEqual(mostChanged(values, others, 1), [2, 0, 3]);
});

test('the page address selects existing methods, protocols and averages and ignores unknown ones', () => {
  const state = new ReportState(sampleReport());
  const asked = { method: 'b', protocol: 'paper', measure: 'no such one', average: 'classes' };
  assert.deepEqual(chosenBy((key) => asked[key], state, Object.keys(asked)),
    { method: 1, protocol: 1, average: 'macro' });
  assert.deepEqual(chosenBy(() => null, state, Object.keys(asked)), {});
});

test('the map places models in class order and omits models without a position', () => {
  const points = modelPoints([[0, 1], [2, 3], [null, null]], [0, 2, 1]);
  assert.deepEqual(points, [{ model: 0, x: 0, y: 1 }, { model: 2, x: 2, y: 3 }]);
  assert.deepEqual(classMiddles(points, [0, 1, 0]), [{ label: 0, x: 1, y: 2 }]);
});
