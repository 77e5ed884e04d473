// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and counts as text.

const plurals = { class: 'classes', query: 'queries' };

export const counted = (count, noun) => `${count} ${count === 1 ? noun : plurals[noun] || `${noun}s`}`;
export const percent = (fraction) => (Number.isNaN(fraction) ? '\u2013' : (100 * fraction).toFixed(2));

// Four significant digits; null is infinity.
export const number = (value, digits = 4) => (value === null ? '\u221e' : String(Number(value.toPrecision(digits))));

export const shortened = (text, length) => (text.length > length ? `${text.slice(0, length - 1)}\u2026` : text);

export const ended = (text) => (text.endsWith('.') ? text : `${text}.`);

// The parts as one sentence and the hints as one each. Names such as mAP keep their small letter.
export function sentences(parts, hints = []) {
  const capital = (text) => (/^[a-z][A-Z]/.test(text) ? text[0] : text.charAt(0).toUpperCase());
  const sentence = (text) => ended(`${capital(text)}${text.slice(1)}`);
  return [parts.join(', '), ...hints].map(sentence).join(' ');
}
