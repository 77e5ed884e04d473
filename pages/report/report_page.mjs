// SPDX-License-Identifier: GPL-3.0-or-later
// The report: puts the page together.

import { byId, pageData } from '../common/elements.mjs';
import { drawFrame, followResizing } from '../common/frame.mjs';
import { linked } from '../common/link.mjs';
import { counted } from '../common/words.mjs';
import { showChanges } from './changes.mjs';
import { showChoices } from './choices.mjs';
import { showClasses } from './classes.mjs';
import { showMap } from './collection_map.mjs';
import { showConfusions } from './confusions.mjs';
import { showCurves } from './curves.mjs';
import { showGallery } from './gallery.mjs';
import { showHeatMap } from './heat_map.mjs';
import { drawNotes } from './notes.mjs';
import { showQueries } from './queries.mjs';
import { ReportState } from './report_state.mjs';
import { ShapeDialog } from './shape_dialog.mjs';
import { showSummary } from './summary.mjs';
import { textTable } from './sortable_table.mjs';

function drawTests({ pairs, words }) {
  byId('tests').querySelector('.stamp').textContent = words;
  textTable(byId('tests-table'), pairs);
}

const state = new ReportState(pageData());
const dialog = new ShapeDialog(state);
state.openShape = (model) => dialog.open(model);

const { ids, classes, methods, facts, tests } = state.report;
const shown = { tests: tests.pairs.rows.length > 0, map: methods[0].map, changes: methods.length > 1 };
for (const [section, there] of Object.entries(shown)) if (!there) byId(section).remove();
drawFrame(state.report, [counted(ids.length, 'model'), counted(classes.length, 'class'),
  counted(methods.length, 'method'), ...facts.map(([name, value]) => `${name}: ${value}`)]);
showChoices(state, ['method', 'measure', 'protocol', 'average']);
showSummary(state);
if (shown.tests) drawTests(tests);
const drawCurves = showCurves(state);
const drawClasses = showClasses(state);
showHeatMap(state);
const drawMap = shown.map ? showMap(state) : () => {};
showConfusions(state);
showQueries(state);
if (shown.changes) showChanges(state);
showGallery(state);
drawNotes(state.report);
if (ids.includes(linked('query'))) state.openShape(ids.indexOf(linked('query')));
followResizing(() => {
  drawCurves();
  drawClasses();
  drawMap();
  dialog.redraw();
});
