// SPDX-License-Identifier: GPL-3.0-or-later
// A method's colour, dashes and sign: the same in all charts. Methods of one colour differ in both others.

import { methodColours, methodDashes } from '../common/constants.mjs';

const signs = ['Circle', 'Square', 'Triangle', 'Diamond', 'Cross', 'Star', 'Wye'];

// The position in lists of `count`: one further with each round of the colours.
export const shifted = (index, count) => (index + Math.floor(index / methodColours)) % count;

export const colourOf = (index) => `var(--method-${index % methodColours})`;
export const dashesOf = (index) => methodDashes[shifted(index, methodDashes.length)];
export const signOf = (index) => d3.symbol().type(d3[`symbol${signs[shifted(index, signs.length)]}`]).size(34)();

export function swatch(index) {
  const svg = d3.create('svg').attr('class', 'swatch').attr('viewBox', '0 0 34 10').attr('aria-hidden', 'true');
  svg.append('line').attr('x1', 0).attr('x2', 34).attr('y1', 5).attr('y2', 5)
    .style('stroke', colourOf(index)).style('stroke-dasharray', dashesOf(index));
  svg.append('path').attr('transform', 'translate(17,5)').attr('d', signOf(index)).style('fill', colourOf(index));
  return svg.node();
}
