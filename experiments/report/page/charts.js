// What the charts share: their width, legends that toggle methods, and files to keep.

// The width of a drawing: what there is room for, up to a limit.
const widthIn = (place, largest) => Math.max(420, Math.min(largest, place.clientWidth || largest));

// A button for each method that hides it in the charts or shows it again.
function drawLegend(place) {
  const legend = make('div', { class: 'legend', role: 'group', 'aria-label': 'Methods shown' });
  report.methods.forEach(({ name }, index) => {
    const toggle = () => {
      const hidden = new Set(state.hidden);
      if (!hidden.delete(index)) hidden.add(index);
      change({ hidden });
      place.querySelectorAll('button')[index].focus();
    };
    legend.append(make('button', { type: 'button', 'aria-pressed': String(!state.hidden.has(index)), click: toggle }, swatch(index), name));
  });
  place.replaceChildren(legend);
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
