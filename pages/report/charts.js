// What the charts share: their width, legends that toggle methods, and files to keep.

// The width of a drawing: what there is room for, up to a limit.
const widthIn = (place, largest) => Math.max(420, Math.min(largest, place.clientWidth || largest));

// A button for each method that hides it in the charts or shows it again, and lights it up where the pointer or the
// keyboard is; and two for all of them where there are many.
function drawLegend(place) {
  const legend = make('div', { class: 'legend', role: 'group', 'aria-label': 'Methods shown' });
  const add = (attributes, hiddenNext, ...content) => {
    const number = legend.children.length;
    const click = () => {
      change({ hidden: hiddenNext() });
      place.querySelectorAll('button')[number].focus();
    };
    legend.append(make('button', { type: 'button', click, ...attributes }, ...content));
  };
  const all = report.methods.map((_, index) => index);
  for (const index of all) {
    const on = () => light(state.hidden.has(index) ? null : index);
    const off = () => light(null);
    const toggled = () => new Set(all.filter((other) => state.hidden.has(other) !== (other === index)));
    add({ 'aria-pressed': String(!state.hidden.has(index)), pointerenter: on, focus: on, pointerleave: off, blur: off }, toggled, swatch(index), report.methods[index].name);
  }
  if (all.length > methodColours) {
    add({ class: 'quiet' }, () => new Set(), 'Show all');
    add({ class: 'quiet' }, () => new Set(all), 'Hide all');
  }
  place.replaceChildren(legend);
}

// Fades what charts show of all methods but one; null: of none.
function light(method) {
  for (const element of document.querySelectorAll('[data-method]')) {
    element.classList.toggle('faded', method !== null && Number(element.dataset.method) !== method);
  }
}

const keptProperties = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'opacity',
  'font-family', 'font-size', 'font-weight', 'text-anchor', 'display'];

// The drawing as the text of an SVG file that looks the same by itself.
function svgFile(svg) {
  const copy = svg.cloneNode(true);
  const originals = svg.querySelectorAll('*');
  copy.querySelectorAll('*').forEach((element, index) => {
    const style = getComputedStyle(originals[index]);
    element.setAttribute('style', keptProperties.map((name) => `${name}:${style.getPropertyValue(name)}`).join(';'));
  });
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.removeAttribute('tabindex');
  const paper = getComputedStyle(document.body).backgroundColor;
  copy.setAttribute('style', `background:${paper}`);
  return new XMLSerializer().serializeToString(copy);
}

function saveButton(svg, name) {
  const save = () => {
    const address = URL.createObjectURL(new Blob([svgFile(svg)], { type: 'image/svg+xml' }));
    make('a', { href: address, download: `${name}.svg` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  };
  return make('button', { type: 'button', class: 'save', click: save }, 'Download SVG');
}
