// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and normals of triangles.

import { smoothEdgeDegrees } from '../common/constants.mjs';
import { cross, difference, dot, scaled, unit, vectorAt } from './vectors.mjs';

// Normal of the triangle that begins at a corner, as long as twice its area.
function areaNormal(positions, corner) {
  const a = vectorAt(positions, 3 * corner);
  return cross(difference(vectorAt(positions, 3 * corner + 3), a), difference(vectorAt(positions, 3 * corner + 6), a));
}

// How much of the area each sample has, and the unit normals of the faces (zero where there is none).
export function measureTriangles({ positions, sampleOf, sampleCount }) {
  const weights = new Float64Array(sampleCount);
  const faceNormals = new Float32Array(positions.length / 3);
  for (let i = 0; i < sampleOf.length; i += 3) {
    const normal = areaNormal(positions, i);
    const area = Math.sqrt(dot(normal, normal));
    for (const corner of [i, i + 1, i + 2]) weights[sampleOf[corner]] += area;
    faceNormals.set(area > 0 ? scaled(normal, 1 / area) : [0, 0, 0], i);
  }
  const total = weights.reduce((sum, weight) => sum + weight, 0) || 1;
  return { weights: weights.map((weight) => weight / total), faceNormals };
}

// Normals at corners, smooth over edges of up to smoothEdgeDegrees, as in the program's pictures (render_shape.cpp).
export function cornerNormals({ positions, faceNormals, vertexOf }) {
  const vertices = 1 + vertexOf.reduce((largest, vertex) => Math.max(largest, vertex), 0);
  const sums = new Float32Array(3 * vertices);
  for (let i = 0; i < vertexOf.length; i += 3) {
    const normal = areaNormal(positions, i);
    for (const vertex of vertexOf.subarray(i, i + 3)) for (let k = 0; k < 3; ++k) sums[3 * vertex + k] += normal[k];
  }
  const smooth = Math.cos((smoothEdgeDegrees * Math.PI) / 180);
  const normals = new Float32Array(3 * vertexOf.length);
  vertexOf.forEach((vertex, corner) => {
    const faceNormal = vectorAt(faceNormals, corner - (corner % 3));
    const mean = unit(vectorAt(sums, 3 * vertex));
    normals.set(dot(mean, faceNormal) > smooth ? mean : faceNormal, 3 * corner);
  });
  return normals;
}
