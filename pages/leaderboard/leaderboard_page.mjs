// The leaderboard: puts the page together.

import { byId, choice, make, pageData } from '../common/elements.mjs';
import { followTheme } from '../common/theme.mjs';
import { counted } from '../common/words.mjs';
import { showClasses } from '../report/classes.mjs';
import { showCurves } from '../report/curves.mjs';
import { followResizing, followScrolling } from '../report/navigation.mjs';
import { drawChecks } from './checks.mjs';
import { showIntervals } from './intervals.mjs';
import { LeaderboardState } from './leaderboard_state.mjs';
import { showDownloads, showStandings } from './standings.mjs';

function drawHead({ title, facts, methods, refused, classes, version }) {
  byId('title').textContent = title;
  const counts = [counted(methods.length, 'method'), ...(classes.length ? [counted(classes.length, 'class')] : []),
    ...(refused.length ? [`${refused.length} refused`] : [])];
  byId('facts').textContent = [...counts, ...facts.map(([name, value]) => `${name}: ${value}`)].join(' \u00b7 ');
  for (const section of document.querySelectorAll('main section')) {
    byId('contents').append(make('a', { href: `#${section.id}` }, section.querySelector('h2').textContent));
  }
  byId('footer').textContent = `Made by shapegauge ${version}. Charts: D3 (BSD licence), in the source of this page.`;
}

function drawChoices(state) {
  const averages = ['micro', 'macro'];
  byId('choices').append(
    choice('Measure', state.evaluation.measures, state.chosen.measure, (measure) => state.change({ measure })),
    choice('Mean over', ['queries', 'classes'], 0, (index) => state.change({ average: averages[index] })));
}

const state = new LeaderboardState(pageData('leaderboard-data'));
const hidesClasses = state.report.classes.length === 0;
followTheme();
if (hidesClasses) byId('classes').remove();
drawHead(state.report);
drawChoices(state);
showStandings(state);
showDownloads(state.report, 'leaderboard');
const drawIntervals = showIntervals(state);
const drawCurves = showCurves(state);
const drawClasses = hidesClasses ? () => {} : showClasses(state, { choosesMeasure: false });
drawChecks(state.report);
followScrolling();
followResizing(() => {
  drawIntervals();
  drawCurves();
  drawClasses();
});
