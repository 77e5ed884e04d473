// The report: puts the page together.

import { pageData } from '../common/elements.mjs';
import { followTheme } from '../common/theme.mjs';
import { showClasses } from './classes.mjs';
import { showConfusions } from './confusions.mjs';
import { showCurves } from './curves.mjs';
import { showGallery } from './gallery.mjs';
import { showHeatMap } from './heat_map.mjs';
import { drawHead, followResizing, followScrolling, showChoices } from './navigation.mjs';
import { drawNotes } from './notes.mjs';
import { showQueries } from './queries.mjs';
import { ReportState } from './report_state.mjs';
import { ShapeDialog } from './shape_dialog.mjs';
import { showSummary } from './summary.mjs';

const state = new ReportState(pageData('report-data'));
const dialog = new ShapeDialog(state);
state.openShape = (model) => dialog.open(model);

followTheme();
drawHead(state.report);
showChoices(state);
showSummary(state);
const drawCurves = showCurves(state);
const drawClasses = showClasses(state);
showHeatMap(state);
showConfusions(state);
showQueries(state);
showGallery(state);
drawNotes(state.report);
followScrolling();
followResizing(() => {
  drawCurves();
  drawClasses();
  dialog.redraw();
});
