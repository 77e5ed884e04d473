// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a cloud as splats() of core/render has them: hexagons in their tangent planes.

import { trianglesPerSplat } from '../common/constants.mjs';
import { cross, unit, vectorAt } from './vectors.mjs';

const corners = trianglesPerSplat + 2;

// Positions of the corners of the hexagons' triangles.
export function hexagonsOf(points, directions, radii) {
  const positions = new Float32Array(9 * trianglesPerSplat * radii.length);
  for (let i = 0; i < radii.length; ++i) {
    const ring = ringAround(vectorAt(points, 3 * i), vectorAt(directions, 3 * i), radii[i]);
    for (let k = 0; k < trianglesPerSplat; ++k) {
      positions.set([...ring[0], ...ring[k + 1], ...ring[k + 2]], 9 * (trianglesPerSplat * i + k));
    }
  }
  return positions;
}

function ringAround(centre, direction, radius) {
  const normal = direction.some((part) => part !== 0) ? unit(direction) : [0, 0, 1];
  const u = unit(cross(Math.abs(normal[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0], normal));
  const v = cross(normal, u);
  return Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * k) / corners;
    return centre.map((middle, axis) => middle + radius * (Math.cos(angle) * u[axis] + Math.sin(angle) * v[axis]));
  });
}
