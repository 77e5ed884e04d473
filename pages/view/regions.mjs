// SPDX-License-Identifier: GPL-3.0-or-later
// The list of regions of a shape: a click turns the view there.

import { make } from '../common/elements.mjs';

// Returns the camera { turn, zoom, shift } that shows a region. upright: turn of the shape into its initial position.
export function cameraAt({ position, towards, size }, radius, upright) {
  const turned = (coordinates) => new THREE.Vector3(...coordinates).applyQuaternion(upright);
  const turn = new THREE.Quaternion().setFromUnitVectors(turned(towards).normalize(), new THREE.Vector3(0, 0, 1));
  const { x, y } = turned(position).divideScalar(radius).applyQuaternion(turn);
  return { turn, zoom: Math.max(1, Math.min(30, radius / size)), shift: new THREE.Vector2(x, y) };
}

// Returns the list; chosen() receives the region.
export function regionList(regions, chosen) {
  const entry = (region) =>
    make('li', {}, make('button', { type: 'button', class: 'quiet', click: () => chosen(region) }, region.text));
  return make('ol', { class: 'view-regions' }, ...regions.map(entry));
}
