// Draws shapes with WebGL. One context draws all of them, one after the other, and each is copied to its own canvas:
// browsers allow few contexts.

const vertexShader = `
  attribute float value;
  attribute float known;
  attribute vec3 direction;
  varying float vValue;
  varying float vKnown;
  varying vec3 vDirection;
  varying vec3 vNormal;
  void main() {
    vValue = value;
    vKnown = known;
    vDirection = direction;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

// Light from the upper left that wraps around the form, as render_shape.cpp has it.
const fragmentShader = `
  uniform sampler2D colours;
  uniform float levels;
  uniform vec2 range;
  uniform bool root;
  uniform int what;
  uniform bool lighting;
  uniform vec2 lit;
  uniform vec3 unlit;
  varying float vValue;
  varying float vKnown;
  varying vec3 vDirection;
  varying vec3 vNormal;
  void main() {
    vec3 colour = vec3(0.63);
    if (what == 0 && vKnown > 0.99) {
      float place = clamp((vValue - range.x) / (range.y - range.x), 0.0, 1.0);
      if (root) place = sqrt(place);
      colour = texture2D(colours, vec2((place * (levels - 1.0) + 0.5) / levels, 0.5)).rgb;
    } else if (what == 1 && dot(vDirection, vDirection) > 0.01) {
      colour = 0.5 + 0.5 * normalize(vDirection);
    } else if (what == 2) {
      colour = vec3(0.78, 0.78, 0.76);
    }
    if (lighting && (vKnown < 0.99 || vValue < lit.x || vValue > lit.y)) colour = mix(colour, unlit, 0.9);
    vec3 normal = normalize(vNormal);
    if (normal.z < 0.0) normal = -normal;
    float wrapped = (dot(normal, normalize(vec3(-0.6, 1.0, 0.9))) + 0.6) / 1.6;
    gl_FragColor = vec4(colour * (0.36 + 0.54 * max(0.0, wrapped) + 0.1 * normal.z), 1.0);
  }`;

// The one renderer, or null where the browser has no WebGL. The context is asked for first: three.js would complain on
// the console.
const glRenderer = (() => {
  let renderer;
  return () => {
    if (renderer !== undefined) return renderer;
    const canvas = document.createElement('canvas');
    const settings = { alpha: true, antialias: true };
    const context = canvas.getContext('webgl2', settings) || canvas.getContext('webgl', settings);
    renderer = context ? new THREE.WebGLRenderer({ canvas, context, alpha: true, antialias: true }) : null;
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

const rampColours = d3.range(256).map((level) => d3.interpolateViridis(level / 255));

class DrawnShape {
  constructor(shape) {
    this.shape = shape;
    const count = shape.placeOf.length;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(shape.positions, 3));
    const normals = shape.vertexOf ? cornerNormals(shape) : Float32Array.from({ length: 3 * count }, (_, i) => shape.faceNormals[3 * Math.floor(i / 9) + (i % 3)]);
    geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    geometry.setAttribute('value', new THREE.BufferAttribute(new Float32Array(count), 1));
    geometry.setAttribute('known', new THREE.BufferAttribute(new Float32Array(count), 1));
    geometry.setAttribute('direction', new THREE.BufferAttribute(this.cornerDirections(), 3));
    this.material = new THREE.ShaderMaterial({
      vertexShader,
      fragmentShader,
      side: THREE.DoubleSide,
      uniforms: Object.fromEntries(Object.entries({ colours: null, levels: 256, range: new THREE.Vector2(0, 1), root: false, what: 2, lighting: false, lit: new THREE.Vector2(0, 1), unlit: new THREE.Color(0.6, 0.6, 0.6) })
        .map(([name, value]) => [name, { value }])),
    });
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.lines = shape.directions ? this.normalLines() : null;
    this.turned = new THREE.Group();
    this.turned.add(this.mesh, ...(this.lines ? [this.lines] : []));
    this.scene = new THREE.Scene();
    this.scene.add(this.turned);
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 20);
    this.camera.position.z = 10;
    // The rows are the picture's axes: to the right, upwards, towards the viewer.
    const axes = new THREE.Matrix4().set(...shape.axes.flatMap((row) => [...row, 0]), 0, 0, 0, 1);
    this.upright = new THREE.Quaternion().setFromRotationMatrix(axes);
    this.caster = new THREE.Raycaster();
  }

  cornerDirections() {
    const { directions, placeOf } = this.shape;
    if (!directions) return new Float32Array(3 * placeOf.length);
    return Float32Array.from({ length: 3 * placeOf.length }, (_, i) => directions[3 * placeOf[Math.floor(i / 3)] + (i % 3)]);
  }

  // Normals as lines; of many places, every so many.
  normalLines() {
    const { directions, placeOf, positions, places } = this.shape;
    const step = Math.ceil(places / 4000);
    const feet = new Float32Array(3 * places);
    const corners = new Uint32Array(places);
    placeOf.forEach((place, corner) => {
      ++corners[place];
      for (let k = 0; k < 3; ++k) feet[3 * place + k] += positions[3 * corner + k];
    });
    const ends = [];
    for (let place = 0; place < places; place += step) {
      if (!corners[place]) continue;
      const foot = [0, 1, 2].map((k) => feet[3 * place + k] / corners[place]);
      ends.push(...foot, ...foot.map((x, k) => x + 0.04 * directions[3 * place + k]));
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(ends), 3));
    const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial());
    lines.visible = false;
    return lines;
  }

  // What to show: { kind: 'values' (with values, from, to, root, colours), 'normals' or 'plain' }.
  show(shown) {
    const { uniforms } = this.material;
    uniforms.what.value = { values: 0, normals: 1, plain: 2 }[shown.kind];
    if (this.lines) this.lines.visible = shown.kind === 'normals';
    if (shown.kind !== 'values') return;
    const { value, known } = this.mesh.geometry.attributes;
    // As parts of the range of colours: single precision suffices then, whatever the unit.
    const width = shown.to > shown.from ? shown.to - shown.from : 1;
    this.part = (x) => (x - shown.from) / width;
    this.shape.placeOf.forEach((place, corner) => {
      const x = shown.values[place];
      known.array[corner] = Number.isNaN(x) ? 0 : 1;
      value.array[corner] = Number.isNaN(x) ? 0 : this.part(x);
    });
    value.needsUpdate = known.needsUpdate = true;
    uniforms.range.value.set(...(shown.to > shown.from ? [0, 1] : [-0.5, 0.5]));
    uniforms.root.value = Boolean(shown.root);
    if (uniforms.colours.value) uniforms.colours.value.dispose();
    uniforms.colours.value = colourTexture(shown.colours || rampColours, !shown.colours);
    uniforms.levels.value = (shown.colours || rampColours).length;
  }

  // Lights up the places with values in the interval only; null: all.
  light(interval) {
    const { lighting, lit } = this.material.uniforms;
    lighting.value = Boolean(interval);
    if (interval) lit.value.set(this.part(interval[0]) - 1e-6, this.part(interval[1]) + 1e-6);
  }

  // camera: { turn, zoom, shift }, the same for all shapes.
  draw(canvas, camera) {
    const renderer = glRenderer();
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const [width, height] = [Math.max(1, Math.round(canvas.clientWidth * ratio)), Math.max(1, Math.round(canvas.clientHeight * ratio))];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const size = renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) renderer.setSize(width, height, false);
    this.place(camera, width / height);
    renderer.render(this.scene, this.camera);
    const context = canvas.getContext('2d');
    context.clearRect(0, 0, width, height);
    context.drawImage(renderer.domElement, 0, 0);
  }

  place({ turn, zoom, shift }, aspect) {
    this.turned.quaternion.multiplyQuaternions(turn, this.upright);
    const half = 1.04 / zoom;
    const [wide, high] = aspect > 1 ? [half * aspect, half] : [half, half / aspect];
    Object.assign(this.camera, { left: -wide + shift.x, right: wide + shift.x, top: high + shift.y, bottom: -high + shift.y });
    this.camera.updateProjectionMatrix();
    this.scene.updateMatrixWorld();
  }

  // What is at a point of the canvas (from -1 to 1): the place and, where values belong to vertices, the three around
  // it with their shares. Null where there is nothing.
  at(x, y) {
    this.caster.setFromCamera(new THREE.Vector2(x, y), this.camera);
    const [hit] = this.caster.intersectObject(this.mesh);
    if (!hit) return null;
    const corners = [0, 1, 2].map((k) => 3 * hit.faceIndex + k);
    const places = corners.map((corner) => this.shape.placeOf[corner]);
    if (this.shape.site !== 'vertex') return { place: places[0], places: [places[0]], shares: [1] };
    const [a, b, c] = corners.map((corner) => new THREE.Vector3().fromArray(this.shape.positions, 3 * corner));
    const shares = THREE.Triangle.getBarycoord(this.mesh.worldToLocal(hit.point.clone()), a, b, c, new THREE.Vector3()).toArray();
    return { place: places[shares.indexOf(Math.max(...shares))], places, shares };
  }

  dispose() {
    if (this.material.uniforms.colours.value) this.material.uniforms.colours.value.dispose();
    for (const drawn of [this.mesh, ...(this.lines ? [this.lines] : [])]) {
      drawn.geometry.dispose();
      drawn.material.dispose();
    }
  }
}
