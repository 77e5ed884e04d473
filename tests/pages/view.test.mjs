// SPDX-License-Identifier: GPL-3.0-or-later
// Reads view.json of make_sample_views in the folder SHAPEGAUGE_SAMPLE_VIEWS.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { rampColour, scalePart, scaleTicks } from '../../pages/common/chart.mjs';
import { belowColour, ramp, trianglesPerSplat, unknownColour } from '../../pages/common/constants.mjs';
import { binsOf, channelsOf, scaleOf, shownBy, valueColour } from '../../pages/view/channels.mjs';
import { glbOf } from '../../pages/view/glb.mjs';
import { measuredLine } from '../../pages/view/probe.mjs';
import { cornersOf, unpackShape } from '../../pages/view/shape_data.mjs';
import { planeOf } from '../../pages/view/slice.mjs';
import { cornerNormals, measureTriangles } from '../../pages/view/surface.mjs';
import { binShares, selectionAfter } from '../../pages/view/value_histogram.mjs';
import { cross, difference, dot, scaled, unit, vectorAt } from '../../pages/view/vectors.mjs';

const sample = JSON.parse(readFileSync(join(process.env.SHAPEGAUGE_SAMPLE_VIEWS, 'view.json'), 'utf8'));
const length = (a) => Math.sqrt(dot(a, a));
const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test('triangle corners are decoded from distances to the next unused vertex', () => {
  // Triangles 0 1 2 and 2 1 3: new, new, new, one back of three, two back, new.
  assert.deepEqual([...cornersOf(Buffer.from([0, 0, 0, 1, 2, 0]).toString('base64'), 6)], [0, 1, 2, 2, 1, 3]);
  // Two bytes: 200 new vertices, and the first again.
  const bytes = [...new Array(200).fill(0), 200 & 127 | 128, 200 >> 7];
  assert.equal(cornersOf(Buffer.from(bytes).toString('base64'), 201)[200], 0);
});

test('a scale set by the user is not shared and keeps its logarithm and threshold', () => {
  const field = { name: 'a', from: 1, to: 100, low: 0.5, high: 200, set: true, log: true, below: 2 };
  const [channel] = channelsOf([{ fields: [field], parts: [] }]);
  const other = { fields: [{ name: 'a', from: 0, to: 9, low: 0, high: 9 }] };
  assert.deepEqual(scaleOf(channel, { fields: [field] }, [{ fields: [field] }, other]),
    { from: 1, to: 100, low: 0.5, high: 200, log: true, below: 2 });
  near(scalePart({ from: 1, to: 100, log: true }, 10), 0.5, 1e-12);
  assert.ok(scalePart({ from: 1, to: 100, log: true }, 0) < 0);
  scaleTicks({ from: 1, to: 16, log: true }).forEach((tick, k) => near(tick, 2 ** k, 1e-9));
});

test('a cloud is drawn with the hexagons of the library', () => {
  const { sampleCount, positions, radius, site } = unpackShape(sample.cloud);
  const corners = trianglesPerSplat + 2;
  assert.equal(site, 'point');
  assert.equal(sampleCount, sample.splats.length / corners);
  const ringOf = (splat) => { // three corners of the first triangle, then the last of each further one
    const at = (corner) => scaled(vectorAt(positions, 3 * (3 * trianglesPerSplat * splat + corner)), radius);
    return [at(0), at(1), at(2), ...Array.from({ length: trianglesPerSplat - 1 }, (_, k) => at(3 * (k + 1) + 2))];
  };
  const middle = (ring) => scaled(ring.reduce((sum, point) => sum.map((x, k) => x + point[k])), 1 / ring.length);
  const normal = (ring) => unit(cross(difference(ring[1], ring[0]), difference(ring[2], ring[0])));
  const firstOffset = difference(middle(ringOf(0)), middle(sample.splats.slice(0, corners)));
  for (let splat = 0; splat < sampleCount; ++splat) {
    const [mine, theirs] = [ringOf(splat), sample.splats.slice(corners * splat, corners * (splat + 1))];
    const offset = difference(middle(mine), middle(theirs)); // the whole cloud is moved
    assert.ok(length(difference(offset, firstOffset)) < 1e-4 * radius);
    const size = length(difference(theirs[0], middle(theirs)));
    for (const corner of mine) near(length(difference(corner, middle(mine))), size, 1e-3 * size);
    assert.ok(Math.abs(dot(normal(mine), normal(theirs))) > Math.cos(Math.PI / 180)); // 127 levels
  }
});

test('an unpacked mesh has the area, normal and values of each face', () => {
  const shape = unpackShape(sample.balls);
  const corners = Array.from({ length: shape.positions.length / 3 }, (_, i) => vectorAt(shape.positions, 3 * i));
  near(Math.max(...corners.map(length)), 1, 1e-6);
  const half = shape.sampleCount / 2; // the large ball of diameter 2, then the small one of 0.5
  near(shape.weights.subarray(0, half).reduce((sum, weight) => sum + weight), 16 / 17, 1e-4);
  assert.deepEqual([...new Set(shape.fields[0].values.subarray(0, half))], [2]);
  assert.deepEqual([...new Set(shape.fields[0].values.subarray(half))], [0.5]);
  assert.deepEqual([...new Set(shape.parts[0].values.subarray(half))], [1]);
  for (let face = 0; face < shape.sampleCount; face += 7) { // the normals point outwards, and are those of the program
    assert.ok(dot(vectorAt(shape.faceNormals, 3 * face), unit(vectorAt(shape.directions, 3 * face))) > 0.999);
  }
});

// A roof: two triangles that meet at an edge, bent by an angle in degrees.
function roof(degrees) {
  const angle = (degrees * Math.PI) / 180;
  const [a, b, c, d] = [[0, 0, 0], [0, 1, 0], [-1, 0, 0], [Math.cos(angle), 0, -Math.sin(angle)]];
  return {
    positions: Float32Array.of(...c, ...a, ...b, ...d, ...b, ...a),
    vertexOf: Uint32Array.of(2, 0, 1, 3, 1, 0), sampleOf: Uint32Array.of(0, 0, 0, 1, 1, 1), sampleCount: 2,
  };
}

test('shading is smooth across edges below an angle and flat beyond', () => {
  const bent = (degrees) => {
    const surface = roof(degrees);
    const normals = cornerNormals({ ...surface, ...measureTriangles(surface) });
    return Math.acos(Math.min(1, dot(vectorAt(normals, 3), vectorAt(normals, 15)))); // of both triangles at one vertex
  };
  near(bent(60), 0, 1e-3); // each 30 degrees from their mean
  near(bent(90), Math.PI / 2, 1e-3);
});

test('triangles are weighted by their fraction of the area', () => {
  const { weights } = measureTriangles(roof(0));
  assert.deepEqual([...weights], [0.5, 0.5]);
});

test('histogram bins sum the area of values and outer bins include values beyond the range', () => {
  assert.deepEqual(binShares([0, 0.4, 1, NaN, 5], [0.1, 0.2, 0.3, 0.3, 0.1], 0, 1, 2), [0.1 + 0.2, 0.3 + 0.1]);
  assert.deepEqual(binShares([2, 2], [0.5, 0.5], 2, 2, 3), [1, 0, 0]);
});

test('arrow keys move and extend the selected histogram bins', () => {
  const right = { key: 'ArrowRight' };
  assert.deepEqual(selectionAfter(null, right, 4), [0, 0]);
  assert.deepEqual(selectionAfter(null, { key: 'ArrowLeft' }, 4), [3, 3]);
  assert.deepEqual(selectionAfter([3, 3], right, 4), [3, 3]);
  assert.deepEqual(selectionAfter([1, 2], { ...right, shiftKey: true }, 4), [1, 3]);
  assert.deepEqual(selectionAfter([1, 1], { key: 'ArrowLeft', shiftKey: true }, 4), [1, 1]);
  assert.equal(selectionAfter([1, 1], { key: 'Escape' }, 4), null);
  assert.equal(selectionAfter(null, { key: 'Escape' }, 4), undefined);
  assert.equal(selectionAfter(null, { key: 'a' }, 4), undefined);
});

test('shapes use a common scale, their own or the given one', () => {
  const field = (k) => ({ name: 'f', from: k, to: k + 1, low: k - 1, high: k + 2, values: [] });
  const shapes = [0, 1].map((k) => ({ fields: [field(k)], parts: [] }));
  const [channel, nothing] = channelsOf(shapes);
  assert.deepEqual(scaleOf(channel, shapes[0], shapes), { from: 0, to: 2, low: -1, high: 3 });
  assert.deepEqual(scaleOf(channel, shapes[1], [shapes[1]]), { from: 1, to: 2, low: 0, high: 3 });
  assert.deepEqual(scaleOf(channel, shapes[1], shapes, { from: 5, to: 6, root: true }),
    { from: 5, to: 6, low: 0, high: 3, root: true });
  assert.equal(scaleOf(nothing, shapes[0], shapes), null);
  assert.deepEqual(shownBy(nothing, shapes[0], null), { kind: 'plain' });
});

test('a view lists the fields, parts and normals of its shapes', () => {
  const shapes = [sample.balls, sample.cloud].map(unpackShape);
  assert.deepEqual(channelsOf(shapes).map(({ name }) => name), ['thickness', 'height', 'rare', 'Parts', 'Normals',
    'Nothing']);
  assert.deepEqual(channelsOf(shapes.slice(1)).map(({ name }) => name), ['thickness', 'Nothing']);
  assert.equal(channelsOf(shapes)[1].of(shapes[1]), null);
  assert.equal(shownBy(channelsOf(shapes)[3], shapes[0], null).to, 1);
});

test('histograms have one bin per part or 64 bins of values', () => {
  assert.deepEqual([binsOf({ colours: ['#000', '#fff'] }).edge(0), binsOf({ colours: ['#000', '#fff'] }).edge(2)],
    [-0.5, 1.5]);
  const { bins, edge } = binsOf({ low: 1, high: 3 });
  assert.deepEqual([bins, edge(0), edge(32), edge(64)], [64, 1, 2, 3]);
});

test('scale ticks lie between the ends of the scale', () => {
  for (const root of [false, true]) {
    const scale = { from: 2, to: 6, root };
    const percents = scaleTicks(scale).map((tick) => Math.round(100 * scalePart(scale, tick)));
    assert.deepEqual(percents, root ? [0, 20, 40, 60, 80, 100] : [0, 25, 50, 75, 100]);
  }
  assert.equal(scalePart({ from: 1, to: 1 }, 1), 0.5);
  assert.equal(rampColour(-1), ramp[0]);
  assert.equal(rampColour(2), ramp[255]);
});

test('a slice removes the half towards the viewer', () => {
  assert.deepEqual(planeOf({ axis: 'y', at: 0.25 }, [0, 0.9, 0.1]), { normal: [0, 1, 0], at: 0.25 });
  assert.deepEqual(planeOf({ axis: 'y', at: 0.25 }, [0, -0.9, 0.1]), { normal: [0, -1, 0], at: -0.25 });
});

test('the line of a ball lies inside the surface and that of a gap outside', () => {
  assert.deepEqual(measuredLine([1, 0, 0], [1, 0, 0], 'ball', 0.5), { from: [1, 0, 0], to: [0.5, 0, 0] });
  assert.deepEqual(measuredLine([1, 0, 0], [1, 0, 0], 'gap', 0.5), { from: [1, 0, 0], to: [1.5, 0, 0] });
});

test('a value is coloured by its scale or part, or marked as unknown or below the threshold', () => {
  const scale = { from: 0, to: 4 };
  assert.equal(valueColour(scale, 4), ramp[255]);
  assert.equal(valueColour({ ...scale, root: true }, 1), rampColour(0.5));
  assert.equal(valueColour({ ...scale, below: 1 }, 0.9), belowColour);
  assert.equal(valueColour({ ...scale, below: 1 }, 1), rampColour(0.25));
  assert.equal(valueColour(scale, NaN), unknownColour);
  assert.equal(valueColour({ ...scale, colours: ['#000000', '#0000ff'] }, 1), '#0000ff');
});

test('a GLB file contains the corners with colours and values', () => {
  const positions = Float32Array.from([0, 0, 0, 2, 0, 0, 0, 3, 0]);
  const file = glbOf([{ name: 'a', positions, colours: [[255, 0, 0], [0, 255, 0], [128, 0, 0]],
    values: Float32Array.from([1, 2, 3]) }]);
  const view = new DataView(file.buffer);
  assert.deepEqual([0, 4, 8].map((at) => view.getUint32(at, true)), [0x46546c67, 2, file.length]);
  const jsonLength = view.getUint32(12, true);
  assert.equal(jsonLength % 4, 0);
  const gltf = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + jsonLength)));
  const begin = 20 + jsonLength + 8;
  assert.equal(view.getUint32(begin - 8, true), file.length - begin);
  const { attributes } = gltf.meshes[0].primitives[0];
  const bytesOf = (name) => {
    const { byteOffset, byteLength } = gltf.bufferViews[gltf.accessors[attributes[name]].bufferView];
    return file.slice(begin + byteOffset, begin + byteOffset + byteLength);
  };
  assert.deepEqual(new Float32Array(bytesOf('POSITION').buffer), positions);
  assert.deepEqual([...new Float32Array(bytesOf('_VALUE').buffer)], [1, 2, 3]);
  // Half of sRGB is a fifth of the light (IEC 61966-2-1).
  assert.deepEqual([...bytesOf('COLOR_0')], [255, 0, 0, 255, 0, 255, 0, 255, 55, 0, 0, 255]);
  assert.deepEqual([gltf.accessors[0].min, gltf.accessors[0].max, gltf.accessors[0].count], [[0, 0, 0], [2, 3, 0], 3]);
});
