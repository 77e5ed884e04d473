// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `shapegauge view`.

import { byId, make, pageData } from '../common/elements.mjs';
import { drawFrame } from '../common/frame.mjs';
import { counted } from '../common/words.mjs';
import { ShapeView } from './shape_view.mjs';

const page = pageData();
const { missing, warnings, unit, shapes } = page;
drawFrame(page, [counted(shapes.length, 'shape'), `lengths in ${unit || 'the units of the files'}`]);
if (missing.length) byId('missing').textContent = `Not shown, as they could not be used: ${missing.join(', ')}.`;
byId('warnings').replaceChildren(...warnings.map((words) => make('li', {}, words)));
new ShapeView(byId('view'), shapes, { unit });
