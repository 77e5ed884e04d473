// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { remarksOf } from '../../pages/leaderboard/checks.mjs';
import { groupsOf, LeaderboardState, letterOf } from '../../pages/leaderboard/leaderboard_state.mjs';

const standing = (average, rank, letters = 'a') => ({ average, rank, ranks: [rank, rank], letters });

function sampleBoard(count) {
  const evaluation = { protocol: 'psb', measures: ['FT', 'mAP'] };
  return {
    methods: Array.from({ length: count }, (_, i) => ({ name: `m${i}`, evaluations: [evaluation] })), rank_by: 1,
    micro: [[standing(0.2, 2), standing(0.4, 1)], [standing(0.3, 1), standing(0.3, 1)]],
    macro: [[standing(0.9, 1), standing(0.1, 2)], [standing(0.9, 1, 'A'), standing(0.1, 2, 'B')]],
  };
}

test('groups of methods begin where the worst possible rank grows', () => {
  // Nine, eight, seven and three, of which neighbours within 1.5 do not differ.
  assert.deepEqual(groupsOf([2, 3, 3, 4]), [{ first: 0, last: 1 }, { first: 1, last: 2 }, { first: 3, last: 3 }]);
  assert.deepEqual(groupsOf([3, 3, 3]), [{ first: 0, last: 2 }]);
});

test('group letters continue with two letters after z', () => {
  assert.deepEqual([0, 25, 26, 53, 701, 702].map(letterOf), ['a', 'z', 'aa', 'bb', 'zz', 'aaa']);
});

test('leaderboard ranks methods by the chosen measure and average and keeps the order of ties', () => {
  const state = new LeaderboardState(sampleBoard(2));
  assert.equal(state.measure, 'mAP');
  assert.deepEqual(state.ranking, [0, 1]);
  state.change({ measure: 0 });
  assert.deepEqual(state.ranking, [1, 0]);
  state.change({ average: 'macro' });
  assert.deepEqual(state.ranking, [0, 1]);
});

test('group letters over queries precede those over classes', () => {
  assert.equal(new LeaderboardState(sampleBoard(2)).lettersOf(1), 'a B');
});

test('leaderboard initially shows as many methods as there are colours', () => {
  assert.deepEqual(new LeaderboardState(sampleBoard(9)).visibleMethods, [0, 1, 2, 3, 4, 5, 6]);
});

test('a warning shared by methods is listed once with their names', () => {
  const methods = [{ name: 'a', warnings: ['x', 'y'] }, { name: 'b', warnings: ['x'] }];
  assert.deepEqual(remarksOf(methods), [{ warning: 'x', names: ['a', 'b'] }, { warning: 'y', names: ['a'] }]);
});
