// SPDX-License-Identifier: GPL-3.0-or-later
// The shaders of shapes: colours by value, by normal or none, with the light of the program's own pictures.

import { belowColour, plainColour, shading, unknownColour } from '../common/constants.mjs';

const glsl = (value) => (Number.isInteger(value) ? value.toFixed(1) : String(value));
const vector = (parts) => `vec3(${parts.map(glsl).join(', ')})`;
const channels = (colour) => vector([1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255));

export const channelNumbers = { values: 0, normals: 1, plain: 2 };

export const vertexShader = `
  attribute float value;
  attribute float known;
  attribute vec3 direction;
  varying float vValue;
  varying float vKnown;
  varying vec3 vDirection;
  varying vec3 vNormal;
  varying vec3 vPosition;
  void main() {
    vPosition = position;
    vValue = value;
    vKnown = known;
    vDirection = direction;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

// What lies beyond the plane is cut off: dot(cut.xyz, position) > cut.w.
const cutting = `
  uniform vec4 cut;
  varying vec3 vPosition;
  void cutOff() {
    if (dot(cut.xyz, vPosition) > cut.w) discard;
  }`;

export const parityShader = `
  ${cutting}
  void main() {
    cutOff();
    gl_FragColor = vec4(1.0);
  }`;

export const fragmentShader = `
  ${cutting}
  uniform sampler2D colours;
  uniform float levels;
  uniform vec2 range;
  uniform bool root;
  uniform int what;
  uniform bool marking;
  uniform float below;
  uniform bool lighting;
  uniform vec2 lit;
  uniform vec3 unlit;
  varying float vValue;
  varying float vKnown;
  varying vec3 vDirection;
  varying vec3 vNormal;
  void main() {
    cutOff();
    vec3 colour = ${channels(unknownColour)};
    if (what == ${channelNumbers.values} && vKnown > 0.99) {
      float fraction = clamp((vValue - range.x) / (range.y - range.x), 0.0, 1.0);
      if (root) fraction = sqrt(fraction);
      colour = texture2D(colours, vec2((fraction * (levels - 1.0) + 0.5) / levels, 0.5)).rgb;
      if (marking && vValue < below) colour = ${channels(belowColour)};
    } else if (what == ${channelNumbers.normals} && dot(vDirection, vDirection) > 0.01) {
      colour = 0.5 + 0.5 * normalize(vDirection);
    } else if (what == ${channelNumbers.plain}) {
      colour = ${channels(plainColour)};
    }
    if (lighting && (vKnown < 0.99 || vValue < lit.x || vValue > lit.y)) colour = mix(colour, unlit, 0.9);
    vec3 light = normalize(${vector(shading.light)});
    vec3 normal = normalize(vNormal);
    if (normal.z < 0.0) normal = -normal;
    float wrapped = (dot(normal, light) + ${glsl(shading.wrap)}) / ${glsl(1 + shading.wrap)};
    float shade = ${glsl(shading.ambient)} + ${glsl(shading.wrapped)} * max(0.0, wrapped);
    gl_FragColor = vec4(colour * (shade + ${glsl(shading.frontal)} * normal.z), 1.0);
  }`;
