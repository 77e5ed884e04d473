// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs: a head with a title and buttons, the last of which closes, and a body.

import { make } from './elements.mjs';

export const dialogButton = (text, click, attributes = {}) =>
  make('button', { type: 'button', click, ...attributes }, text);

export function fillDialog(dialog, title, buttons, ...body) {
  dialog.replaceChildren(
    make('div', { class: 'dialog-head' }, make('h2', { id: `${dialog.id}-title` }, ...title), ...buttons,
      dialogButton('Close', () => dialog.close(), { class: 'close' })),
    make('div', { class: 'dialog-body' }, ...body));
}
