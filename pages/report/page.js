// Puts the page together.

function drawHead() {
  byId('title').textContent = report.title;
  byId('description').textContent = report.description;
  const facts = [counted(report.ids.length, 'model'), counted(report.classes.length, 'class'), counted(report.methods.length, 'method'),
    ...report.facts.map(([name, value]) => `${name}: ${value}`)];
  byId('facts').textContent = facts.join(' \u00b7 ');
  for (const section of document.querySelectorAll('main section')) {
    byId('contents').append(make('a', { href: `#${section.id}` }, section.querySelector('h2').textContent));
  }
  byId('footer').textContent = `Made by shapegauge ${report.version}. Everything is in this file. Charts: D3 (BSD licence)${report.views ? ', shapes: three.js (MIT licence)' : ''}, in the source of this page.`;
}

function drawChoices() {
  const choices = byId('choices');
  const names = report.methods.map(({ name }) => name);
  const parts = [];
  if (names.length > 1) parts.push(choice('Method', names, state.method, (index) => change({ method: index })));
  const protocols = report.methods[0].evaluations.map(({ protocol }) => protocol);
  if (protocols.length > 1) parts.push(choice('Protocol', protocols, state.protocol, (index) => change({ protocol: index })));
  parts.push(choice('Mean over', ['queries', 'classes'], state.average === 'micro' ? 0 : 1, (index) => change({ average: index === 0 ? 'micro' : 'macro' })));
  const focused = [...choices.querySelectorAll('select')].indexOf(document.activeElement);
  choices.replaceChildren(...parts);
  if (focused >= 0) choices.querySelectorAll('select')[focused].focus();
}

function drawNotes() {
  const place = byId('notes-text');
  const { left_out: leftOut } = report.methods[0].evaluations[0];
  const notes = [];
  if (leftOut > 0) notes.push(`${counted(leftOut, 'model')} of classes that are too small: never a query, but in the lists of others.`);
  notes.push(...report.warnings);
  place.append(notes.length ? make('ul', { class: 'notes' }, ...notes.map((note) => make('li', {}, note))) : make('p', {}, 'No warnings.'));
  if (report.failures.length) {
    place.append(make('h3', {}, 'Models left out'), make('p', {}, 'These could not be used; all figures are without them.'));
    const table = make('div', { class: 'wide' });
    sortableTable(table, { caption: counted(report.failures.length, 'model'), columns: [{ title: 'Model', text: ([id]) => id }, { title: 'Reason', text: ([, reason]) => reason }], rows: report.failures });
    place.append(table);
  }
  const described = report.methods.filter(({ description }) => description);
  if (described.length === 0) return;
  place.append(make('h3', {}, 'Methods'), make('ul', { class: 'notes' }, ...described.map(({ name, description }) => make('li', {}, make('b', {}, name), `: ${description}`))));
}

// Charts are as wide as the window lets them be.
function followResizing() {
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    drawCurves();
    drawClasses();
    redrawShape();
  });
}

// Marks the section under way in the contents.
function followScrolling() {
  const links = new Map([...byId('contents').children].map((link) => [link.hash.slice(1), link]));
  const observer = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      for (const link of links.values()) link.removeAttribute('aria-current');
      links.get(target.id).setAttribute('aria-current', 'true');
    }
  }, { rootMargin: '-15% 0px -75% 0px' });
  document.querySelectorAll('main section').forEach((section) => observer.observe(section));
}

followTheme();
drawHead();
show(['method', 'protocol', 'average'], drawChoices);
show(['protocol', 'average', 'method'], drawSummary);
show(['protocol', 'average', 'hidden'], drawCurves);
show(['protocol', 'hidden', 'measure', 'method'], drawClasses);
show(['method'], drawHeatMap);
show(['method'], drawConfusions);
show(['method', 'protocol'], drawQueries);
show([], drawGallery);
show(['method', 'protocol'], redrawShape);
drawNotes();
followScrolling();
followResizing();
