// SPDX-License-Identifier: GPL-3.0-or-later
// Files that a page gives to its reader.

import { make } from './elements.mjs';

export function saveFile(name, type, content) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  make('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
