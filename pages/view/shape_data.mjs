// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as shape_view.cpp packs them, unpacked into what is drawn: triangles, and values at their samples. A sample is
// a face, a vertex or, of a cloud, a point; each corner of each triangle belongs to one.

import { directionLevels, trianglesPerSplat } from '../common/constants.mjs';
import { bytesOf, shortsOf, valuesBetween } from '../common/packed.mjs';
import { measureTriangles } from './surface.mjs';
import { hexagonsOf } from './splats.mjs';

// Each corner is written as how far it lies behind the next vertex that is still unused, 7 bits a byte, least first.
export function cornersOf(text, count) {
  const bytes = bytesOf(text);
  const corners = new Uint32Array(count);
  let unused = 0;
  let at = 0;
  for (let i = 0; i < count; ++i) {
    let back = 0;
    for (let shift = 1, more = true; more; shift *= 128) {
      back += shift * (bytes[at] & 127);
      more = bytes[at++] > 127;
    }
    corners[i] = unused - back;
    if (back === 0) ++unused;
  }
  return corners;
}

// Coordinates around the middle of the box, in units of the radius that the shape needs to turn in; and that radius.
export function coordinatesOf({ values, step }) {
  const levels = shortsOf(values);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  levels.forEach((level, i) => {
    low[i % 3] = Math.min(low[i % 3], level);
    high[i % 3] = Math.max(high[i % 3], level);
  });
  const middle = low.map((least, k) => (least + high[k]) / 2);
  let radius = 1;
  for (let i = 0; i < levels.length; i += 3) {
    radius = Math.max(radius, Math.hypot(...middle.map((centre, k) => levels[i + k] - centre)));
  }
  const points = Float32Array.from(levels, (level, i) => (level - middle[i % 3]) / radius);
  return { points, radius: radius * step };
}

const directionsOf = (text) =>
  Float32Array.from(new Int8Array(bytesOf(text).buffer), (level) => level / directionLevels);

function fieldOf({ values, ...field }) {
  return { ...field, values: valuesBetween(values, field.low, field.high, NaN) };
}

// The triangles of a cloud: positions of their corners, and the samples that the corners belong to.
function unpackCloud({ radii }, points, radius) {
  const splatRadii = Float32Array.from(shortsOf(radii.values), (level) => (level * radii.step) / radius);
  const corners = 3 * trianglesPerSplat;
  return {
    site: 'point',
    positions: hexagonsOf(points, directionsOf(radii.directions), splatRadii),
    sampleCount: splatRadii.length,
    sampleOf: Uint32Array.from({ length: corners * splatRadii.length }, (_, corner) => Math.floor(corner / corners)),
  };
}

// The same for a mesh, with the vertices of the corners.
function unpackMesh({ triangles, site }, points) {
  const vertexOf = cornersOf(triangles.corners, 3 * triangles.count);
  const faces = site === 'faces';
  return {
    site: faces ? 'face' : 'vertex',
    vertexOf,
    positions: Float32Array.from({ length: 3 * vertexOf.length },
      (_, i) => points[3 * vertexOf[Math.floor(i / 3)] + (i % 3)]),
    sampleCount: faces ? triangles.count : points.length / 3,
    sampleOf: faces ? vertexOf.map((_, corner) => Math.floor(corner / 3)) : vertexOf,
  };
}

export function unpackShape(packed) {
  const { name, note, picture, axes, parts = [] } = packed;
  const { points, radius } = coordinatesOf(packed.vertices);
  const surface = packed.radii ? unpackCloud(packed, points, radius) : unpackMesh(packed, points);
  return {
    name, note, picture, axes, radius,
    regions: packed.regions || [],
    ...surface,
    ...measureTriangles(surface),
    directions: packed.directions ? directionsOf(packed.directions) : null,
    fields: packed.fields.map(fieldOf),
    parts: parts.map(({ values, ...rest }) => ({ values: Float64Array.from(shortsOf(values)), ...rest })),
  };
}
