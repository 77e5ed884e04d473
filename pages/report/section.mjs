// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of a report share.

import { byId } from '../common/elements.mjs';
import { sentences } from '../common/words.mjs';

// Says under a section's title what it shows.
export function stamp(section, parts, ...hints) {
  byId(section).querySelector('.stamp').textContent = sentences(parts, hints);
}

// The width of a drawing: what there is room for, up to a limit.
export const widthIn = (container, largest) => Math.max(420, Math.min(largest, container.clientWidth || largest));
