// A plane that cuts shapes open: what lies beyond it is not drawn, and the section is filled.

import { choice, make } from '../common/elements.mjs';

const axes = ['x', 'y', 'z'];

// The controls; changed() receives { axis, at }, at from -1 to 1 in units of the radius, or null.
export function sliceTools(slice, changed) {
  const range = make('input', { type: 'range', min: -1, max: 1, step: 0.01, value: slice ? slice.at : 0,
    'aria-label': 'Position of the slice', disabled: !slice, input: () => change() });
  const chosen = choice('Slice', ['none', ...axes], slice ? 1 + axes.indexOf(slice.axis) : 0, () => change());
  const change = () => {
    const axis = axes[chosen.querySelector('select').selectedIndex - 1];
    range.disabled = !axis;
    changed(axis ? { axis, at: Number(range.value) } : null);
  };
  return make('span', { class: 'view-slice' }, chosen, range);
}

// The plane in the coordinates of a shape: kept is where dot(normal, x) <= at. The half towards the viewer is cut off.
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
