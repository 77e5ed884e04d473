// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of three numbers.

export const vectorAt = (array, begin) => [array[begin], array[begin + 1], array[begin + 2]];
export const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const scaled = (a, factor) => [factor * a[0], factor * a[1], factor * a[2]];

// Of unit length; zero stays zero.
export function unit(a) {
  const length = Math.sqrt(dot(a, a));
  return length > 0 ? scaled(a, 1 / length) : [0, 0, 0];
}
