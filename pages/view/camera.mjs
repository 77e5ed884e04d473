// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of a view, { turn, zoom, shift }, as a text for links.

const first = '0,0,0,1,1,0,0';

export function readCamera(text) {
  const numbers = (text || first).split(',').map(Number);
  const [x, y, z, w, zoom, right, up] = numbers.length === 7 && numbers.every(Number.isFinite) ? numbers
    : first.split(',').map(Number);
  return { turn: new THREE.Quaternion(x, y, z, w).normalize(), zoom, shift: new THREE.Vector2(right, up) };
}

// Null where the camera is as it was at first.
export function cameraText({ turn, zoom, shift }) {
  const text = [...turn.toArray(), zoom, ...shift.toArray()].map((x) => Number(x.toFixed(4))).join(',');
  return text === first ? null : text;
}
