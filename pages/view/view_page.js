// A page of shapes.

const shown = JSON.parse(byId('view-data').textContent);
followTheme();
byId('title').textContent = shown.title;
byId('facts').textContent = `${counted(shown.shapes.length, 'shape')} \u00b7 lengths in the units of the files`;
byId('missing').textContent = shown.missing.length ? `Not shown, as they could not be used: ${shown.missing.join(', ')}.` : '';
byId('footer').textContent = `Made by shapegauge ${shown.version}. Everything is in this file. Charts: D3 (BSD licence), shapes: three.js (MIT licence), both in the source of this page.`;
byId('view').querySelectorAll('img').forEach((image, i) => { shown.shapes[i].picture = image.src; });
const view = new ShapeView(byId('view'), shown.shapes);
