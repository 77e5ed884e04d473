// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as the program packs them (pages/packed_numbers.h): little-endian integers in base64.

import { noLevel, topLevel } from './constants.mjs';

export const bytesOf = (text) => Uint8Array.from(atob(text), (character) => character.charCodeAt(0));

export function shortsOf(text) {
  const bytes = bytesOf(text);
  return Uint16Array.from({ length: bytes.length / 2 }, (_, i) => bytes[2 * i] + 256 * bytes[2 * i + 1]);
}

// Values between low and high, `missing` where there is none.
export function valuesBetween(text, low, high, missing) {
  const value = (level) => (level === noLevel ? missing : low + ((high - low) * level) / topLevel);
  return Float64Array.from(shortsOf(text), value);
}

// Numbers from 0 to scale; Infinity where there is none.
export const scaledNumbers = ({ scale, values }) => valuesBetween(values, 0, scale, Infinity);
