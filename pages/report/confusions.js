// Nearest neighbours class by class: which classes are taken for which.

const mostClassesInGrid = 120;

function drawConfusions() {
  const { confusion, name } = method();
  stamp('confusions', [name, 'number of queries of the class of a row whose nearest neighbour is of the class of a column']);
  const totals = confusion.map((row) => row.reduce((sum, [, count]) => sum + count, 0));
  const place = byId('confusions-chart');
  if (report.classes.length > mostClassesInGrid) place.replaceChildren(make('p', {}, `The grid is left out for more than ${mostClassesInGrid} classes.`));
  else drawGrid(place, confusion, totals, name);
  const wrong = confusion.flatMap((row, label) => row.filter(([other]) => other !== label)
    .map(([other, count]) => ({ label, other, count, part: count / totals[label] })));
  wrong.sort((a, b) => b.count - a.count || a.label - b.label || a.other - b.other);
  const columns = [{ title: 'Class', text: (row) => report.classes[row.label] }, { title: 'Taken for', text: (row) => report.classes[row.other] },
    { title: 'Queries', numeric: true, value: (row) => row.count, text: (row) => String(row.count) },
    { title: 'Percent of class', numeric: true, value: (row) => row.part, text: (row) => percent(row.part) }];
  if (wrong.length === 0) byId('confusions-table').replaceChildren(make('p', {}, 'Every query\u2019s nearest neighbour is of its own class.'));
  else sortableTable(byId('confusions-table'), { caption: wrong.length > 15 ? `The 15 most frequent of ${wrong.length} confusions` : counted(wrong.length, 'confusion'), columns, rows: wrong.slice(0, 15) });
}

function drawGrid(place, confusion, totals, name) {
  const count = report.classes.length;
  const cell = Math.max(9, Math.min(26, Math.floor(560 / count)));
  const space = 8 + 6.4 * Math.min(18, Math.max(...report.classes.map((text) => text.length)));
  const labelled = cell >= 11;
  const margin = labelled ? space : 10;
  const { svg, area } = drawing(place, {
    width: margin + count * cell + margin / 2, height: margin + count * cell + 4, left: margin, right: margin / 2, top: margin, bottom: 4, label: `Confusion matrix of ${name}`,
  });
  confusion.forEach((row, label) => {
    area.append('rect').attr('x', 0).attr('y', label * cell).attr('width', count * cell).attr('height', cell - 1).style('fill', 'var(--raised)');
    for (const [other, queries] of row) {
      const part = queries / totals[label];
      area.append('rect').attr('x', other * cell).attr('y', label * cell).attr('width', cell - 1).attr('height', cell - 1)
        .style('fill', `rgba(var(--accent-channels), ${0.15 + 0.85 * part})`)
        .on('pointermove', () => tooltip.show(d3.event.clientX, d3.event.clientY, tipHead(`${report.classes[label]} \u2192 ${report.classes[other]}`),
          make('div', {}, `${queries} of ${totals[label]} queries, ${percent(part)} %`)))
        .on('pointerleave', tooltip.hide);
      if (cell >= 16) {
        area.append('text').attr('x', (other + 0.5) * cell).attr('y', (label + 0.5) * cell).attr('dy', '0.35em').attr('text-anchor', 'middle')
          .style('pointer-events', 'none').style('font-size', '11px').style('fill', part > 0.75 ? 'var(--paper)' : null).text(queries);
      }
    }
    if (!labelled) return;
    area.append('text').attr('x', -6).attr('y', (label + 0.5) * cell).attr('dy', '0.35em').attr('text-anchor', 'end').style('font-size', '11px').text(shortened(report.classes[label], 18));
    area.append('text').attr('transform', `translate(${(label + 0.5) * cell},-6) rotate(-60)`).attr('dy', '0.35em').style('font-size', '11px').text(shortened(report.classes[label], 18));
  });
  place.append(saveButton(svg.node(), 'confusions'));
}
