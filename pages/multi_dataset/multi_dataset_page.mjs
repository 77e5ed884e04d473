// SPDX-License-Identifier: GPL-3.0-or-later
// Assembles the page of a multi-dataset experiment.

import { byId, pageData } from '../common/elements.mjs';
import { drawFrame, followResizing } from '../common/frame.mjs';
import { counted } from '../common/words.mjs';
import { showChoices } from '../report/choices.mjs';
import { MultiDatasetState } from './multi_dataset_state.mjs';
import { showCriticalDifference } from './critical_difference.mjs';
import { drawDatasets, showMethods, showWins } from './tables.mjs';

const state = new MultiDatasetState(pageData());
const hasPairs = state.table.pairs.length > 0;
if (!hasPairs) byId('wins').remove();
const { methods, datasets, failures } = state.report;
drawFrame(state.report, [counted(methods.length, 'method'), counted(datasets.length, 'data set'),
  ...(failures.length ? [`${failures.length} left out`] : [])]);
showChoices(state, ['measure', 'protocol', 'average']);
showMethods(state);
const drawDifference = showCriticalDifference(state);
if (hasPairs) showWins(state);
drawDatasets(state.report);
followResizing(drawDifference);
