// Puts the page together: what is pointed at or chosen in one part is marked in all others.

class Selection {
  constructor() {
    this.pointed = null;
    this.chosen = null;
    this.hidden = new Set();  // names of layers of the views
    this.listeners = [];
  }
  point(row) {
    if (row === this.pointed) return;
    this.pointed = row;
    for (const listener of this.listeners) listener(null);
  }
  choose(row, by) {
    this.chosen = row;
    for (const listener of this.listeners) listener(by);
  }
}

function addView(data, selection, horizontal, vertical, title, leader) {
  const view = document.createElement('div');
  view.className = 'view';
  const bar = document.createElement('div');
  bar.className = 'bar';
  const heading = document.createElement('h3');
  const note = document.createElement('small');
  heading.append(`${title} ${horizontal}–${vertical} `, note);
  const buttons = document.createElement('div');
  buttons.className = 'buttons';
  bar.append(heading, buttons);
  const picture = document.createElement('div');
  picture.className = 'picture';
  view.append(bar, picture);
  document.getElementById('views').append(view);
  const toolpath = new ToolpathView(picture, data, horizontal, vertical, selection, leader);
  toolpath.picture.addButtons(buttons, title);
  const draw = toolpath.picture.on.draw;
  toolpath.picture.on.draw = (context) => {
    draw(context);
    const stretched = !toolpath.plan && 'XYZ'.includes(vertical) && toolpath.stretch !== 1;
    const notes = stretched ? [`height drawn ×${Number(toolpath.stretch.toPrecision(3))}`] : [];
    if (data.across && [horizontal, vertical].includes(data.across[0]))
      notes.push(`${data.across[1]} across the work is drawn along ${data.across[0]}`);
    note.textContent = notes.join(' · ');
  };
  return toolpath;
}

function addViews(data, selection) {
  const plan = addView(data, selection, 'X', 'Y', 'Plan', null);
  const views = [plan, addView(data, selection, 'X', 'Z', 'Elevation', data.shapes.includes('XZ') ? null : plan)];
  if (data.shapes.includes('YZ')) views.push(addView(data, selection, 'Y', 'Z', 'Side', null));
  const beside = {A: 'X', B: 'Y', C: 'Z'};
  for (const axis of data.axes) {
    const along = beside[axis], [low, high] = data.limits[axis];
    if (along && high > low) views.push(addView(data, selection, along, axis, 'Unrolled', along === 'X' ? plan : null));
  }
  return views;
}

/** The sentence below the table about the block that is chosen. */
function describeChosen(row) {
  const host = document.getElementById('chosen');
  host.replaceChildren();
  if (!row) return;
  const text = document.createElement('b');
  text.textContent = row.text;
  const facts = [row.what];
  if (row.move >= 0) facts.push(`${row.length.toFixed(3)} mm`);
  facts.push(`${duration(row.time)} s from ${clock(row.start)}`);
  if (row.move >= 0) facts.push(`peak ${row.peak.toFixed(1)} mm/min`);
  host.append(`line ${row.line}: `, text, ' · ' + facts.join(' · '));
}

function start() {
  readPalette();
  const data = readData(JSON.parse(document.getElementById('data').textContent));
  const selection = new Selection();
  const views = addViews(data, selection);
  const chart = new SpeedChart(document.getElementById('speed'), data, selection,
                               document.getElementById('speed-readout'));
  chart.picture.addButtons(document.getElementById('speed-buttons'), 'Speed over time');
  const table = new BlockTable(data, selection);
  const pictures = [...views.map((view) => view.picture), chart.picture];
  const legend = () => drawLegend(data, views, selection, () => {
    for (const view of views) view.picture.redraw();
  });
  legend();

  selection.listeners.push((by) => {
    for (const picture of pictures) picture.redraw(false);
    table.showMarks();
    if (!by) return;
    if (by !== table && selection.chosen) table.reveal(selection.chosen);
    describeChosen(selection.chosen);
  });

  const repaint = () => {
    readPalette();
    legend();
    for (const picture of pictures) picture.drawNow();
  };
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
  const rowsOnPaper = 2000;
  window.addEventListener('beforeprint', () => {
    document.documentElement.classList.add('on-paper');
    repaint();
    table.render(true, rowsOnPaper);
  });
  window.addEventListener('afterprint', () => {
    document.documentElement.classList.remove('on-paper');
    repaint();
    table.render(true);
  });
}

start();
