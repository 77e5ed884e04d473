// The page of `shapegauge view`.

import { byId, make, pageData } from '../common/elements.mjs';
import { followTheme } from '../common/theme.mjs';
import { counted } from '../common/words.mjs';
import { ShapeView } from './shape_view.mjs';

const { title, version, missing, warnings, unit, shapes } = pageData('view-data');
followTheme();
byId('title').textContent = title;
byId('facts').textContent = `${counted(shapes.length, 'shape')} \u00b7 lengths in ${unit || 'the units of the files'}`;
if (missing.length) byId('missing').textContent = `Not shown, as they could not be used: ${missing.join(', ')}.`;
byId('warnings').replaceChildren(...warnings.map((words) => make('li', {}, words)));
byId('footer').textContent = `Made by shapegauge ${version}. Everything is in this file. Charts: D3 (BSD licence), ` +
  'shapes: three.js (MIT licence), both in the source of this page.';
const pictures = [...byId('view').querySelectorAll('img')];
new ShapeView(byId('view'), shapes.map((shape, i) => ({ ...shape, picture: pictures[i].src })), { unit });
