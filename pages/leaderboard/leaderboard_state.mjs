// SPDX-License-Identifier: GPL-3.0-or-later
// A leaderboard and what its reader chose to see of it.

import { methodColours } from '../common/constants.mjs';
import { ReportState } from '../report/report_state.mjs';

export class LeaderboardState extends ReportState {
  // board: as leaderboard_page.cpp writes it, of which methods, classes and labels are as in a report.
  constructor(board) {
    super(board);
    this.chosen.measure = board.rank_by;
    // As many curves as there are colours to begin with.
    this.chosen.hidden = new Set(this.methodIndices.slice(methodColours));
  }

  get measure() { return this.evaluation.measures[this.chosen.measure]; }

  // By method: average, rank, ranks, letters and, if there is one, interval.
  get standings() { return this.standingsOf(this.chosen.measure); }
  standingsOf(measure) { return this.report[this.chosen.average][measure]; }

  // Letters of the groups over queries and, in capitals, over classes.
  lettersOf(method) {
    const { report, chosen: { measure } } = this;
    return `${report.micro[measure][method].letters} ${report.macro[measure][method].letters}`;
  }

  // Methods by rank, the best first.
  get ranking() {
    const { standings } = this;
    return this.methodIndices.sort((a, b) => standings[a].rank - standings[b].rank || a - b);
  }
}

// Groups of methods that do not differ: first and last position in the ranking. worst: by position the largest rank
// that is possible, which grows where a group begins.
export function groupsOf(worst) {
  const groups = [];
  worst.forEach((rank, position) => {
    if (position === 0 || rank > worst[position - 1]) groups.push({ first: position, last: rank - 1 });
  });
  return groups;
}

// a to z, then aa, ab, ...
export function letterOf(group) {
  const letter = String.fromCharCode(97 + (group % 26));
  return group < 26 ? letter : letterOf(Math.floor(group / 26) - 1) + letter;
}
