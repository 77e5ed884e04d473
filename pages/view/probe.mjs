// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured at a point: the ball that touches the surface there, inside or in the gap outside, or the ray
// through the shape.

// Where it is: { from, to } at the ends of the diameter or ray. by: 'ball', 'gap' or 'ray'.
export function measuredLine(point, normal, by, length) {
  const way = by === 'gap' ? length : -length;
  return { from: point, to: point.map((x, k) => x + way * normal[k]) };
}

export class Probe {
  constructor() {
    const material = { transparent: true, depthTest: false };
    this.ball = new THREE.Mesh(new THREE.SphereBufferGeometry(1, 48, 32),
      new THREE.MeshBasicMaterial({ ...material, opacity: 0.45 }));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(6), 3));
    this.line = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial(material));
    this.drawn = [this.ball, this.line];
    for (const one of this.drawn) Object.assign(one, { visible: false, renderOrder: 3, frustumCulled: false });
  }

  hide() {
    for (const one of this.drawn) one.visible = false;
  }

  show({ from, to }, by) {
    this.line.geometry.attributes.position.array.set([...from, ...to]);
    this.line.geometry.attributes.position.needsUpdate = true;
    const ends = [from, to].map((end) => new THREE.Vector3(...end));
    this.ball.position.lerpVectors(...ends, 0.5);
    this.ball.scale.setScalar(Math.max(1e-6, ends[0].distanceTo(ends[1]) / 2));
    this.line.visible = true;
    this.ball.visible = by !== 'ray';
  }

  setColour({ r, g, b }) {
    for (const { material } of this.drawn) material.color.setRGB(r / 255, g / 255, b / 255);
  }
}
