// Shapes as shape_view.cpp packs them, unpacked into what is drawn: triangles, and values at their places. A place is a
// face, a vertex or, of a cloud, a point; each corner of each triangle belongs to one.

const noLevel = 65535; // stands for no value

// Multi-byte numbers are little-endian, in the file as in browsers.
const shortsOf = (text) => new Uint16Array(bytesOf(text).buffer);

// Each corner is written as how far it lies behind the next vertex that is still unused, 7 bits a byte, least first.
function cornersOf(text, count) {
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

// Coordinates around the middle of the box, in half diagonals of what the shape needs to turn in.
function coordinatesOf({ values, step }) {
  const levels = shortsOf(values);
  const low = [65535, 65535, 65535];
  const high = [0, 0, 0];
  levels.forEach((level, i) => {
    low[i % 3] = Math.min(low[i % 3], level);
    high[i % 3] = Math.max(high[i % 3], level);
  });
  let radius = 1;
  for (let i = 0; i < levels.length; i += 3) {
    const arm = Math.hypot(...[0, 1, 2].map((k) => levels[i + k] - (low[k] + high[k]) / 2));
    radius = Math.max(radius, arm);
  }
  return { points: Float32Array.from(levels, (level, i) => (level - (low[i % 3] + high[i % 3]) / 2) / radius), radius: radius * step };
}

const directionsOf = (text) => Float32Array.from(new Int8Array(bytesOf(text).buffer), (level) => level / 127);

// Each point of a cloud as a hexagon in its tangent plane, four triangles.
function hexagonsOf(points, directions, radii) {
  const corners = new Float32Array(points.length * 12);
  const centre = new THREE.Vector3();
  const normal = new THREE.Vector3();
  const [u, v] = [new THREE.Vector3(), new THREE.Vector3()];
  for (let i = 0; i < radii.length; ++i) {
    centre.fromArray(points, 3 * i);
    normal.fromArray(directions, 3 * i);
    if (normal.lengthSq() === 0) normal.set(0, 0, 1);
    u.set(...(Math.abs(normal.x) < 0.6 ? [1, 0, 0] : [0, 1, 0])).cross(normal).normalize();
    v.crossVectors(normal, u);
    const ring = d3.range(6).map((k) => centre.clone().addScaledVector(u, radii[i] * Math.cos((Math.PI * k) / 3)).addScaledVector(v, radii[i] * Math.sin((Math.PI * k) / 3)));
    for (let k = 0; k < 4; ++k) {
      [ring[0], ring[k + 1], ring[k + 2]].forEach((corner, c) => corner.toArray(corners, 36 * i + 9 * k + 3 * c));
    }
  }
  return corners;
}

// Where places are, how much area each stands for, and the normals of the faces (three numbers a triangle).
function measureShape(shape) {
  const { positions, placeOf, places } = shape;
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  shape.weights = new Float64Array(places);
  shape.faceNormals = new Float32Array(positions.length / 3);
  for (let i = 0; i < placeOf.length; i += 3) {
    a.fromArray(positions, 3 * i);
    b.fromArray(positions, 3 * i + 3).sub(a);
    c.fromArray(positions, 3 * i + 6).sub(a);
    b.cross(c);
    const area = b.length();
    for (const corner of [i, i + 1, i + 2]) shape.weights[placeOf[corner]] += area;
    b.multiplyScalar(area > 0 ? 1 / area : 0).toArray(shape.faceNormals, i);
  }
  const total = shape.weights.reduce((sum, weight) => sum + weight, 0) || 1;
  for (let i = 0; i < places; ++i) shape.weights[i] /= total;
}

// Normals at corners, smooth over edges of up to 40 degrees, as in the program's own pictures.
function cornerNormals({ positions, faceNormals, vertexOf }) {
  const count = vertexOf.length;
  const sums = new Float32Array(3 * (1 + vertexOf.reduce((largest, vertex) => Math.max(largest, vertex), 0)));
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  for (let i = 0; i < count; i += 3) {
    a.fromArray(positions, 3 * i);
    b.fromArray(positions, 3 * i + 3).sub(a);
    c.fromArray(positions, 3 * i + 6).sub(a);
    b.cross(c);
    for (let k = 0; k < 3; ++k) {
      const at = 3 * vertexOf[i + k];
      sums[at] += b.x;
      sums[at + 1] += b.y;
      sums[at + 2] += b.z;
    }
  }
  const smooth = Math.cos((40 * Math.PI) / 180);
  const normals = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    b.fromArray(faceNormals, i - (i % 3));
    a.fromArray(sums, 3 * vertexOf[i]).normalize();
    (a.dot(b) > smooth ? a : b).toArray(normals, 3 * i);
  }
  return normals;
}

// A field, or the numbers of the parts, at the places: values, NaN where there is none, and the range of their colours.
function fieldOf({ name, low, high, from, to, values }) {
  const levels = shortsOf(values);
  return { name, from, to, low, high, values: Float64Array.from(levels, (level) => (level === noLevel ? NaN : low + ((high - low) * level) / 65534)) };
}

function unpackShape(packed) {
  const { points, radius } = coordinatesOf(packed.vertices);
  const shape = { name: packed.name, note: packed.note, picture: packed.picture, axes: packed.axes, radius };
  shape.directions = packed.directions ? directionsOf(packed.directions) : null;
  if (packed.radii) {
    const radii = Float32Array.from(shortsOf(packed.radii.values), (level) => (level * packed.radii.step) / radius);
    shape.positions = hexagonsOf(points, directionsOf(packed.radii.directions), radii);
    shape.places = radii.length;
    shape.placeOf = Uint32Array.from({ length: 12 * shape.places }, (_, corner) => Math.floor(corner / 12));
    shape.site = 'point';
  } else {
    shape.vertexOf = cornersOf(packed.triangles.corners, 3 * packed.triangles.count);
    shape.positions = new Float32Array(3 * shape.vertexOf.length);
    shape.vertexOf.forEach((vertex, corner) => { for (let k = 0; k < 3; ++k) shape.positions[3 * corner + k] = points[3 * vertex + k]; });
    shape.places = packed.site === 'faces' ? packed.triangles.count : points.length / 3;
    shape.placeOf = packed.site === 'faces' ? Uint32Array.from(shape.vertexOf, (_, corner) => Math.floor(corner / 3)) : shape.vertexOf;
    shape.site = packed.site === 'faces' ? 'face' : 'vertex';
  }
  measureShape(shape);
  shape.fields = packed.fields.map(fieldOf);
  if (packed.parts) shape.parts = { values: Float64Array.from(shortsOf(packed.parts.values)), colours: packed.parts.colours };
  return shape;
}
