// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as files to keep.

import { make } from '../common/elements.mjs';
import { saveFile } from '../common/save.mjs';

const inlinedProperties = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity',
  'opacity', 'font-family', 'font-size', 'font-weight', 'text-anchor', 'display'];

// The drawing as the text of an SVG file that looks the same by itself.
function svgFile(svg) {
  const copy = svg.cloneNode(true);
  const originals = svg.querySelectorAll('*');
  copy.querySelectorAll('*').forEach((element, index) => {
    const style = getComputedStyle(originals[index]);
    element.setAttribute('style', inlinedProperties.map((name) => `${name}:${style.getPropertyValue(name)}`).join(';'));
  });
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.removeAttribute('tabindex');
  copy.setAttribute('style', `background:${getComputedStyle(document.body).backgroundColor}`);
  return new XMLSerializer().serializeToString(copy);
}

export function saveButton(svg, name) {
  const save = () => saveFile(`${name}.svg`, 'image/svg+xml', svgFile(svg));
  return make('button', { type: 'button', class: 'save', click: save }, 'Download SVG');
}
