// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { bytesOf, scaledNumbers, shortsOf, valuesBetween } from '../../pages/common/packed.mjs';
import { cellsOf, namePositions, quantileOf } from '../../pages/report/heat_map.mjs';

// The bytes of little-endian numbers in base64.
const packed = (numbers) => Buffer.from(Uint16Array.from(numbers).buffer).toString('base64');

test('base64 is decoded to bytes and little-endian 16-bit numbers', () => {
  assert.deepEqual([...bytesOf('AP8Q')], [0, 255, 16]);
  assert.deepEqual([...shortsOf('AAEBAP//')], [256, 1, 65535]);
});

test('packed levels become values between two bounds and the last level a missing value', () => {
  const values = valuesBetween(packed([0, 65534, 32767, 65535]), -1, 3, NaN);
  assert.deepEqual([...values], [-1, 3, 1, NaN]);
  assert.deepEqual([...scaledNumbers({ scale: 2, values: packed([0, 65534, 65535]) })], [0, 2, Infinity]);
});

test('a symmetric matrix is restored from its upper half', () => {
  const values = packed([0, 65534, 32767, 0, 65535, 0]);
  assert.deepEqual([...cellsOf({ side: 3, symmetric: true, scale: 2, values })],
    [0, 2, 1, 2, 0, Infinity, 1, Infinity, 0]);
  assert.deepEqual([...cellsOf({ side: 2, symmetric: false, scale: 1, values: packed([0, 65534, 0, 65534]) })],
    [0, 1, 0, 1]);
});

test('quantiles use finite cells in numerical order', () => {
  assert.equal(quantileOf(Float64Array.of(10, 9, Infinity, 100, 1), 1), 100);
  assert.equal(quantileOf(Float64Array.of(10, 9, Infinity, 100, 1), 0.5), 9);
  assert.equal(quantileOf(Float64Array.of(0, 0), 1), 1);
});

test('class names are centred on their rows and do not overlap', () => {
  assert.deepEqual(namePositions([0, 2, 1, 3], [0, 1, 0, 1]), [{ label: 0, middle: 0.25 }, { label: 1, middle: 0.75 }]);
  const labels = Array.from({ length: 1000 }, (_, model) => model);
  const middles = namePositions(labels, labels).map(({ middle }) => middle);
  assert.ok(middles.length > 40 && middles.length < 60);
});
