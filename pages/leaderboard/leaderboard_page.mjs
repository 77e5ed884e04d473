// SPDX-License-Identifier: GPL-3.0-or-later
// The leaderboard: puts the page together.

import { byId, pageData } from '../common/elements.mjs';
import { drawFrame, followResizing } from '../common/frame.mjs';
import { counted } from '../common/words.mjs';
import { showChoices } from '../report/choices.mjs';
import { showClasses } from '../report/classes.mjs';
import { showCurves } from '../report/curves.mjs';
import { drawChecks } from './checks.mjs';
import { showIntervals } from './intervals.mjs';
import { LeaderboardState } from './leaderboard_state.mjs';
import { showDownloads, showStandings } from './standings.mjs';

function factsOf({ facts, methods, refused, classes }) {
  return [counted(methods.length, 'method'), ...(classes.length ? [counted(classes.length, 'class')] : []),
    ...(refused.length ? [`${refused.length} refused`] : []), ...facts.map(([name, value]) => `${name}: ${value}`)];
}

const state = new LeaderboardState(pageData());
const hidesClasses = state.report.classes.length === 0;
if (hidesClasses) byId('classes').remove();
drawFrame(state.report, factsOf(state.report));
showChoices(state, ['measure', 'average']);
showStandings(state);
showDownloads(state.report, 'leaderboard');
const drawIntervals = showIntervals(state);
const drawCurves = showCurves(state);
const drawClasses = hidesClasses ? () => {} : showClasses(state);
drawChecks(state.report);
followResizing(() => {
  drawIntervals();
  drawCurves();
  drawClasses();
});
