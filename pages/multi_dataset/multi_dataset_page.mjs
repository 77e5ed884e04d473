// Assembles the page of a multi-dataset experiment.

import { byId, choice, make, pageData } from '../common/elements.mjs';
import { followTheme } from '../common/theme.mjs';
import { counted } from '../common/words.mjs';
import { followResizing, followScrolling } from '../report/navigation.mjs';
import { MultiDatasetState } from './multi_dataset_state.mjs';
import { showCriticalDifference } from './critical_difference.mjs';
import { drawDatasets, showMethods, showWins } from './tables.mjs';

function drawHead({ title, description, methods, datasets, failures, version }) {
  byId('title').textContent = title;
  byId('description').textContent = description;
  byId('facts').textContent = [counted(methods.length, 'method'), counted(datasets.length, 'data set'),
    ...(failures.length ? [`${failures.length} left out`] : [])].join(' \u00b7 ');
  for (const section of document.querySelectorAll('main section')) {
    byId('contents').append(make('a', { href: `#${section.id}` }, section.querySelector('h2').textContent));
  }
  byId('footer').textContent = `Made by shapegauge ${version}. Charts: D3 (BSD licence), in the source of this page.`;
}

function drawChoices(state) {
  const averages = ['micro', 'macro'];
  const { measures } = state.evaluation;
  const parts = [choice('Measure', measures, state.chosen.measure, (measure) => state.change({ measure })),
    choice('Mean over', ['queries', 'classes'], 0, (index) => state.change({ average: averages[index] }))];
  if (state.protocols.length > 1) {
    parts.push(choice('Protocol', state.protocols, 0, (protocol) => state.change({ protocol })));
  }
  byId('choices').append(...parts);
}

const state = new MultiDatasetState(pageData('multi-dataset-data'));
const hasPairs = state.table.pairs.length > 0;
followTheme();
if (!hasPairs) byId('wins').remove();
drawHead(state.report);
drawChoices(state);
showMethods(state);
const drawDifference = showCriticalDifference(state);
if (hasPairs) showWins(state);
drawDatasets(state.report);
followScrolling();
followResizing(drawDifference);
