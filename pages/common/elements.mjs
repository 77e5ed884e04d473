// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of a page. All text goes into a page as text, never as markup.

export const byId = (id) => document.getElementById(id);

// Makes an element with attributes (functions are listeners) and children (strings are text).
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

// Makes a labelled list of options; chosen() receives the position of the selected one.
export function choice(label, options, selected, chosen) {
  const select = make('select', { change: () => chosen(select.selectedIndex) });
  options.forEach((text, index) => select.append(make('option', { selected: index === selected }, text)));
  return make('label', {}, label, select);
}

// Reads the data that the program wrote into the page.
export const pageData = () => JSON.parse(byId('page-data').textContent);
