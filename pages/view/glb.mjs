// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as they are coloured, as a binary glTF 2.0 file with the values as the attribute _VALUE.

const linear = (level) => ((level / 255 + 0.055) / 1.055) ** 2.4; // sRGB; exact enough for the darkest levels as well
const componentTypes = { Float32Array: 5126, Uint8Array: 5121 };

// One chunk: its length, its kind, and the content filled up to a multiple of four bytes.
function chunk(kind, bytes, filler) {
  const length = Math.ceil(bytes.length / 4) * 4;
  const whole = new Uint8Array(8 + length).fill(filler);
  new DataView(whole.buffer).setUint32(0, length, true);
  whole.set(Uint8Array.from(kind, (letter) => letter.charCodeAt(0)), 4);
  whole.set(bytes, 8);
  return whole;
}

function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

// meshes: name; positions, three a corner; colours, [r, g, b] of each corner; values of the corners, or null.
export function glbOf(meshes) {
  const binary = [];
  const accessors = [];
  const bufferViews = [];
  let length = 0;
  const add = (array, type, size, more = {}) => {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
    accessors.push({ bufferView: accessors.length, componentType: componentTypes[array.constructor.name],
      count: array.length / size, type, ...more });
    binary.push(bytes);
    length += bytes.length;
    return accessors.length - 1;
  };
  const extreme = (positions, pick) => [0, 1, 2].map((k) =>
    positions.reduce((best, x, i) => (i % 3 === k ? pick(best, x) : best), positions[k]));
  const gltf = {
    asset: { version: '2.0', generator: 'shapegauge' },
    scene: 0,
    scenes: [{ nodes: meshes.map((_, i) => i) }],
    nodes: meshes.map(({ name }, mesh) => ({ name, mesh })),
    materials: [{ doubleSided: true, pbrMetallicRoughness: { metallicFactor: 0 } }],
    meshes: meshes.map(({ name, positions, colours, values }) => {
      const level = (x) => Math.round(255 * linear(x));
      const rgba = Uint8Array.from(colours.flatMap((colour) => [...colour.map(level), 255]));
      const attributes = {
        POSITION: add(positions, 'VEC3', 3, { min: extreme(positions, Math.min), max: extreme(positions, Math.max) }),
        COLOR_0: add(rgba, 'VEC4', 4, { normalized: true }),
      };
      if (values) attributes._VALUE = add(values, 'SCALAR', 1);
      return { name, primitives: [{ attributes, material: 0 }] };
    }),
    accessors, bufferViews, buffers: [{ byteLength: length }],
  };
  const content = joined([chunk('JSON', new TextEncoder().encode(JSON.stringify(gltf)), 32),
    chunk('BIN\0', joined(binary), 0)]);
  const head = new Uint8Array(12);
  const view = new DataView(head.buffer);
  [0x46546c67, 2, 12 + content.length].forEach((word, i) => view.setUint32(4 * i, word, true));
  return joined([head, content]);
}
