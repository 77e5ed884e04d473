// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { counted, number, percent, sentences, shortened } from '../../pages/common/words.mjs';

test('counts use singular and plural', () => {
  assert.equal(counted(1, 'class'), '1 class');
  assert.equal(counted(0, 'class'), '0 classes');
  assert.equal(counted(2, 'query'), '2 queries');
  assert.equal(counted(3, 'model'), '3 models');
});

test('numbers are printed with four significant digits', () => {
  assert.equal(number(0.123456), '0.1235');
  assert.equal(number(1234.56), '1235');
  assert.equal(number(0.5), '0.5');
  assert.equal(number(0.123456, 2), '0.12');
  assert.equal(number(null), '\u221e');
  assert.equal(percent(0.98765), '98.77');
});

test('long texts are cut with an ellipsis', () => {
  assert.equal(shortened('abcdef', 6), 'abcdef');
  assert.equal(shortened('abcdefg', 6), 'abcde\u2026');
});

test('parts are joined into one sentence and hints into one each', () => {
  assert.equal(sentences(['protocol psb', 'in percent'], ['the best is bold']),
    'Protocol psb, in percent. The best is bold.');
  assert.equal(sentences(['mAP of each class']), 'mAP of each class.');
});
