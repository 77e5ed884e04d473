// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `shapegauge search`: each query with the shapes that are nearest to it.

import { byId, make, pageData } from '../common/elements.mjs';
import { drawFrame } from '../common/frame.mjs';
import { linked } from '../common/link.mjs';
import { number } from '../common/words.mjs';
import { ComparisonDialog } from './comparison_dialog.mjs';

const page = pageData();
const { shapes, answers } = page;
const dialog = new ComparisonDialog(shapes);

const pictureOf = ({ picture }) => (picture ? make('img', { src: `data:image/png;base64,${picture}`, alt: '' })
  : make('span', { class: 'blank' }, 'no picture'));

function card(index, attributes, ...notes) {
  const shape = shapes[index];
  return make('button', { type: 'button', class: 'card', title: shape.name, ...attributes },
    pictureOf(shape), make('span', { class: 'id' }, shape.name), ...notes);
}

// The bar is as long as the distance is, of the longest in the answer.
function foundItem(answer, rank) {
  const [index, distance] = answer.nearest[rank];
  const longest = answer.nearest[answer.nearest.length - 1][1];
  const share = longest > 0 ? (100 * distance) / longest : 0;
  return make('li', {}, card(index, { click: () => dialog.open(answer, rank) },
    make('span', { class: 'note' }, `${rank + 1}. distance ${number(distance, 3)}`),
    make('span', { class: 'length', style: `width:${share.toFixed(1)}%` })));
}

function answerOf(answer) {
  const { query, failure, nearest } = answer;
  const heading = make('h2', {}, shapes[query].name);
  if (failure) return make('section', { class: 'answer' }, heading, make('p', { class: 'failure' }, failure));
  return make('section', { class: 'answer' }, heading,
    make('div', { class: 'query' }, card(query, { click: () => dialog.open(answer, -1) })),
    make('ol', { class: 'found' }, ...nearest.map((_, rank) => foundItem(answer, rank))));
}

drawFrame(page, page.facts);
byId('answers').replaceChildren(...answers.map(answerOf));
const asked = answers.find(({ query, failure }) => shapes[query].name === linked('query') && !failure);
if (asked) dialog.open(asked, Math.min(Number(linked('rank')), asked.nearest.length - 1));
