// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { MultiDatasetState, contests } from '../../pages/multi_dataset/multi_dataset_state.mjs';
import { deviationText } from '../../pages/multi_dataset/tables.mjs';
import { nameSlots, nameSpace } from '../../pages/multi_dataset/critical_difference.mjs';

function sampleMultiDataset() {
  const tables = ['psb', 'paper'].flatMap((protocol) => ['micro', 'macro'].flatMap((average) =>
    ['NN', 'mAP'].map((measure) => ({ protocol, average, measure }))));
  return { methods: ['a', 'b'], main_measure: 'mAP', tables };
}

test('the page shows the table of the chosen protocol, average and measure', () => {
  const state = new MultiDatasetState(sampleMultiDataset());
  assert.deepEqual(state.table, { protocol: 'psb', average: 'micro', measure: 'mAP' });
  state.change({ protocol: 1, average: 'macro', measure: 0 });
  assert.deepEqual(state.table, { protocol: 'paper', average: 'macro', measure: 'NN' });
});

test('a narrow critical difference diagram leaves room for its axis', () => {
  assert.deepEqual(nameSpace(1000), { side: 240, letters: 26 });
  const { side, letters } = nameSpace(420);
  assert.ok(420 - 2 * side > 120);
  assert.ok(letters >= 10 && 6.6 * (letters + 6) + 14 <= side);
});

test('wins and losses of a pair are mirrored in the table of pairs', () => {
  const rows = contests({ pairs: [{ first: 0, second: 2, p: 0.05, counts: [3, 1, 2] }] }, 3);
  assert.deepEqual(rows[0][2], { text: '3 / 1 / 2', wins: 3, significant: true });
  assert.deepEqual(rows[2][0], { text: '2 / 1 / 3', wins: 2, significant: true });
  assert.equal(rows[0][1], null);
});

test('the standard deviation is shown only for methods with repetitions', () => {
  const table = { deviations: [[null, 0.0125]] };
  assert.equal(deviationText(table, 0, 1), ' \u00b1 1.25');
  assert.equal(deviationText(table, 0, 0), '');
  assert.equal(deviationText({ deviations: [] }, 0, 0), '');
});

test('names in a critical difference diagram stand in two columns without crossing lines', () => {
  assert.deepEqual(nameSlots(5).map(({ left, line }) => [left, line]),
    [[true, 0], [true, 1], [true, 2], [false, 1], [false, 0]]);
});
