// SPDX-License-Identifier: GPL-3.0-or-later
// A plane that cuts shapes open: what lies beyond it is not drawn, and the section is filled.

import { choice, make } from '../common/elements.mjs';

const axes = ['x', 'y', 'z'];

// The controls; changed() receives { axis, at }, at from -1 to 1 in units of the radius, or null.
export function sliceTools(changed) {
  let axis;
  const range = make('input', {
    type: 'range', min: -1, max: 1, step: 0.01, value: 0, 'aria-label': 'Position of the slice', disabled: true,
  });
  const change = () => {
    range.disabled = !axis;
    changed(axis ? { axis, at: Number(range.value) } : null);
  };
  range.addEventListener('input', change);
  return make('span', { class: 'view-slice' }, choice('Slice', ['none', ...axes], 0, (index) => {
    axis = axes[index - 1];
    change();
  }), range);
}

// The plane in the coordinates of a shape; dot(normal, x) <= at is retained. The half towards the viewer is cut off.
export function planeOf({ axis, at }, towardsViewer) {
  const k = axes.indexOf(axis);
  const side = towardsViewer[k] < 0 ? -1 : 1;
  return { normal: axes.map((_, i) => (i === k ? side : 0)), at: side * at };
}

// Draws the section: the parity of the surfaces behind a pixel says whether the plane is inside there.
export class Section {
  constructor(geometry, uniforms, shaders) {
    const invert = THREE.InvertStencilOp;
    const parity = new THREE.ShaderMaterial({ ...shaders, uniforms, side: THREE.DoubleSide, colorWrite: false,
      depthWrite: false, depthTest: false, stencilWrite: true, stencilFail: invert, stencilZFail: invert,
      stencilZPass: invert });
    this.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, stencilWrite: true,
      stencilFunc: THREE.NotEqualStencilFunc, stencilRef: 0 });
    this.plane = new THREE.Mesh(new THREE.PlaneBufferGeometry(4, 4), this.material);
    this.drawn = [new THREE.Mesh(geometry, parity), this.plane];
    this.drawn.forEach((one, i) => { one.renderOrder = i + 1; });
    this.show(null);
  }

  show(plane) {
    for (const one of this.drawn) one.visible = plane !== null;
    if (!plane) return;
    const normal = new THREE.Vector3(...plane.normal);
    this.plane.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal);
    this.plane.position.copy(normal.multiplyScalar(plane.at));
  }
}
