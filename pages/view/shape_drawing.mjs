// SPDX-License-Identifier: GPL-3.0-or-later
// Draws shapes with WebGL. One context draws all of them, one after the other, and each is copied to its own canvas:
// browsers allow few contexts.

import { scalePart } from '../common/chart.mjs';
import { plainColour, ramp } from '../common/constants.mjs';
import { valueColour } from './channels.mjs';
import { measuredLine, Probe } from './probe.mjs';
import { channelNumbers, fragmentShader, parityShader, vertexShader } from './shaders.mjs';
import { Section } from './slice.mjs';
import { cornerNormals } from './surface.mjs';
import { unit, vectorAt } from './vectors.mjs';

const mostNormalLines = 4000;

// Returns the one renderer, or null where the browser has no WebGL. The context is asked for first: three.js would
// complain on the console.
export const glRenderer = (() => {
  let renderer;
  return () => {
    if (renderer !== undefined) return renderer;
    const canvas = document.createElement('canvas');
    const settings = { alpha: true, antialias: true, stencil: true };
    const context = canvas.getContext('webgl2', settings) || canvas.getContext('webgl', settings);
    renderer = context ? new THREE.WebGLRenderer({ canvas, context, ...settings }) : null;
    if (renderer) renderer.setClearColor(0, 0);
    return renderer;
  };
})();

// A row of colours for the shader; smooth: blended between.
function colourTexture(colours, smooth) {
  const bytes = new Uint8Array(4 * colours.length);
  colours.forEach((text, i) => {
    const { r, g, b } = d3.rgb(text);
    bytes.set([r, g, b, 255], 4 * i);
  });
  const texture = new THREE.DataTexture(bytes, colours.length, 1, THREE.RGBAFormat);
  texture.magFilter = texture.minFilter = smooth ? THREE.LinearFilter : THREE.NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

// The values of three numbers per sample, at corners.
const atCorners = (sampleOf, values) =>
  Float32Array.from({ length: 3 * sampleOf.length }, (_, i) => values[3 * sampleOf[Math.floor(i / 3)] + (i % 3)]);

function geometryOf(shape) {
  const { sampleOf, positions, directions, faceNormals, vertexOf } = shape;
  const count = sampleOf.length;
  const faceOf = Uint32Array.from({ length: count }, (_, corner) => Math.floor(corner / 3));
  const attributes = {
    position: [positions, 3],
    normal: [vertexOf ? cornerNormals(shape) : atCorners(faceOf, faceNormals), 3],
    direction: [directions ? atCorners(sampleOf, directions) : new Float32Array(3 * count), 3],
    value: [new Float32Array(count), 1],
    known: [new Float32Array(count), 1],
  };
  const geometry = new THREE.BufferGeometry();
  for (const [name, [array, size]] of Object.entries(attributes)) {
    geometry.setAttribute(name, new THREE.BufferAttribute(array, size));
  }
  return geometry;
}

function shapeMaterial() {
  const uniforms = {
    colours: null, levels: ramp.length, range: new THREE.Vector2(0, 1), root: false, what: channelNumbers.plain,
    marking: false, below: 0, lighting: false, lit: new THREE.Vector2(0, 1), unlit: new THREE.Color(0.6, 0.6, 0.6),
    cut: new THREE.Vector4(0, 0, 0, 1),
  };
  for (const name of Object.keys(uniforms)) uniforms[name] = { value: uniforms[name] };
  return new THREE.ShaderMaterial({ vertexShader, fragmentShader, side: THREE.DoubleSide, uniforms });
}

// Normals as lines; of many samples, every so many.
function normalLines({ directions, sampleOf, positions, sampleCount }) {
  const step = Math.ceil(sampleCount / mostNormalLines);
  const feet = new Float32Array(3 * sampleCount);
  const corners = new Uint32Array(sampleCount);
  sampleOf.forEach((sample, corner) => {
    ++corners[sample];
    for (let k = 0; k < 3; ++k) feet[3 * sample + k] += positions[3 * corner + k];
  });
  const ends = [];
  for (let sample = 0; sample < sampleCount; sample += step) {
    if (!corners[sample]) continue;
    const foot = [0, 1, 2].map((k) => feet[3 * sample + k] / corners[sample]);
    ends.push(...foot, ...foot.map((x, k) => x + 0.04 * directions[3 * sample + k]));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(ends), 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial());
  lines.visible = false;
  return lines;
}

export class DrawnShape {
  constructor(shape) {
    this.shape = shape;
    this.material = shapeMaterial();
    this.mesh = new THREE.Mesh(geometryOf(shape), this.material);
    this.lines = shape.directions ? normalLines(shape) : null;
    this.section = shape.vertexOf ? new Section(this.mesh.geometry, { cut: this.material.uniforms.cut },
      { vertexShader, fragmentShader: parityShader }) : null; // a cloud has none
    this.probe = new Probe();
    const helpers = [this.section, this.probe].flatMap((one) => (one ? one.drawn : []));
    this.drawn = [this.mesh, ...(this.lines ? [this.lines] : []), ...helpers];
    this.plane = null;
    this.turned = new THREE.Group();
    this.turned.add(...this.drawn);
    this.scene = new THREE.Scene();
    this.scene.add(this.turned);
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 20);
    this.camera.position.z = 10;
    // The rows are the picture's axes: to the right, upwards, towards the viewer.
    const axes = new THREE.Matrix4().set(...shape.axes.flatMap((row) => [...row, 0]), 0, 0, 0, 1);
    this.upright = new THREE.Quaternion().setFromRotationMatrix(axes);
    this.caster = new THREE.Raycaster();
  }

  // Shows { kind: 'values' (with values, from, to, root, log, below, colours), 'normals' or 'plain' }.
  show(shown) {
    const { uniforms } = this.material;
    uniforms.what.value = channelNumbers[shown.kind];
    if (this.lines) this.lines.visible = shown.kind === 'normals';
    if (shown.kind !== 'values') return;
    const { value, known } = this.mesh.geometry.attributes;
    // As parts of the range of colours: single precision suffices then, whatever the unit.
    this.part = shown.to > shown.from ? (x) => scalePart({ ...shown, root: false }, x) : (x) => x - shown.from;
    this.shape.sampleOf.forEach((sample, corner) => {
      const x = shown.values[sample];
      known.array[corner] = Number.isNaN(x) ? 0 : 1;
      value.array[corner] = Number.isNaN(x) ? 0 : this.part(x);
    });
    value.needsUpdate = known.needsUpdate = true;
    uniforms.range.value.set(...(shown.to > shown.from ? [0, 1] : [-0.5, 0.5]));
    uniforms.root.value = Boolean(shown.root);
    uniforms.marking.value = shown.below !== undefined;
    if (shown.below !== undefined) uniforms.below.value = this.part(shown.below);
    if (uniforms.colours.value) uniforms.colours.value.dispose();
    uniforms.colours.value = colourTexture(shown.colours || ramp, !shown.colours);
    uniforms.levels.value = (shown.colours || ramp).length;
  }

  // Sets the colours, as d3.rgb() has them, of what is not lit up, of lines, sections, and what was measured.
  setColours(unlit, lines, section, accent) {
    this.probe.setColour(accent);
    if (this.section) this.section.material.color.setRGB(section.r / 255, section.g / 255, section.b / 255);
    this.material.uniforms.unlit.value.setRGB(unlit.r / 255, unlit.g / 255, unlit.b / 255);
    if (this.lines) this.lines.material.color.setRGB(lines.r / 255, lines.g / 255, lines.b / 255);
  }

  // Lights up the samples with values in the interval only; null: all.
  light(interval) {
    const { lighting, lit } = this.material.uniforms;
    lighting.value = Boolean(interval);
    if (interval) lit.value.set(this.part(interval[0]) - 1e-6, this.part(interval[1]) + 1e-6);
  }

  // Cuts the shape by a plane (slice.mjs); null: not.
  cut(plane) {
    this.plane = plane;
    this.material.uniforms.cut.value.set(...(plane ? [...plane.normal, plane.at] : [0, 0, 0, 1]));
    if (this.section) this.section.show(plane);
  }

  // Shows what was measured at a point that at() returned: by: 'ball', 'gap' or 'ray'; length: in units of the radius.
  measure({ point, normal }, by, length) {
    this.probe.show(measuredLine(point, normal, by, length), by);
  }

  // camera: { turn, zoom, shift }, the same for all shapes.
  draw(canvas, camera) {
    const renderer = glRenderer();
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const pixels = (side) => Math.max(1, Math.round(side * ratio));
    const [width, height] = [pixels(canvas.clientWidth), pixels(canvas.clientHeight)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const size = renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) renderer.setSize(width, height, false);
    this.setCamera(camera, width / height);
    renderer.render(this.scene, this.camera);
    const context = canvas.getContext('2d');
    context.clearRect(0, 0, width, height);
    context.drawImage(renderer.domElement, 0, 0);
  }

  setCamera({ turn, zoom, shift }, aspect) {
    this.turned.quaternion.multiplyQuaternions(turn, this.upright);
    const half = 1.04 / zoom;
    const [wide, high] = aspect > 1 ? [half * aspect, half] : [half, half / aspect];
    const sides = { left: -wide + shift.x, right: wide + shift.x, top: high + shift.y, bottom: -high + shift.y };
    Object.assign(this.camera, sides).updateProjectionMatrix();
    this.scene.updateMatrixWorld();
  }

  // What is at a point of the canvas (from -1 to 1): the sample and, where values belong to vertices, the three around
  // it with their shares. Null where there is nothing.
  at(x, y) {
    this.caster.setFromCamera(new THREE.Vector2(x, y), this.camera);
    const hits = this.caster.intersectObject(this.mesh).filter(({ point }) => !this.isCutOff(point));
    const [hit] = hits;
    if (!hit || this.looksAtSection(hits)) return null;
    const corners = [0, 1, 2].map((k) => 3 * hit.faceIndex + k);
    const samples = corners.map((corner) => this.shape.sampleOf[corner]);
    const point = this.mesh.worldToLocal(hit.point.clone());
    const found = (sample, others, shares) =>
      ({ sample, samples: others, shares, point: point.toArray(), normal: this.normalAt(sample, hit.faceIndex) });
    if (this.shape.site !== 'vertex') return found(samples[0], [samples[0]], [1]);
    const ends = corners.map((corner) => new THREE.Vector3().fromArray(this.shape.positions, 3 * corner));
    const shares = THREE.Triangle.getBarycoord(point, ...ends, new THREE.Vector3()).toArray();
    return found(samples[shares.indexOf(Math.max(...shares))], samples, shares);
  }

  isCutOff(point) {
    if (!this.plane) return false;
    const { normal, at } = this.plane;
    return this.mesh.worldToLocal(point.clone()).dot(new THREE.Vector3(...normal)) > at;
  }

  // Whether the first thing that a ray meets is the section: it enters the retained half, inside the shape.
  looksAtSection(hits) {
    if (!this.plane || !this.section || hits.length % 2 === 0) return false;
    const normal = new THREE.Vector3(...this.plane.normal).applyQuaternion(this.turned.quaternion);
    return normal.dot(this.caster.ray.direction) < 0;
  }

  // The unit normal where values were measured, or that of the face.
  normalAt(sample, face) {
    const { directions, faceNormals } = this.shape;
    const normal = directions ? vectorAt(directions, 3 * sample) : [0, 0, 0];
    return unit(normal.some((x) => x !== 0) ? normal : vectorAt(faceNormals, 3 * face));
  }

  // Positions in lengths of the shape, colours [r, g, b] and values of all corners as they are shown (glb.mjs).
  coloured(shown) {
    const { sampleOf, positions, radius, name, directions } = this.shape;
    const channels = (text) => {
      const { r, g, b } = d3.rgb(text);
      return [r, g, b];
    };
    const colourAt = (sample) => {
      if (shown.kind === 'normals') return vectorAt(directions, 3 * sample).map((x) => Math.round(127.5 * (1 + x)));
      if (shown.kind === 'plain') return channels(plainColour);
      return channels(valueColour(shown, shown.values[sample]));
    };
    const colours = Array.from({ length: this.shape.sampleCount }, (_, sample) => colourAt(sample));
    return {
      name,
      positions: positions.map((x) => x * radius),
      colours: Array.from(sampleOf, (sample) => colours[sample]),
      values: shown.kind === 'values' ? Float32Array.from(sampleOf, (sample) => shown.values[sample]) : null,
    };
  }

  dispose() {
    if (this.material.uniforms.colours.value) this.material.uniforms.colours.value.dispose();
    for (const { geometry, material } of this.drawn) {
      geometry.dispose();
      material.dispose();
    }
  }
}
