// Puts the page together: what is pointed at or chosen in one part is marked in all others.

class Selection {
  constructor() {
    this.pointed = null;
    this.chosen = null;
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
    note.textContent = stretched ? `height drawn ×${Number(toolpath.stretch.toPrecision(3))}` : '';
  };
  return toolpath;
}

function addViews(data, selection) {
  const plan = addView(data, selection, 'X', 'Y', 'Plan', null);
  const views = [plan, addView(data, selection, 'X', 'Z', 'Elevation', plan)];
  const beside = {A: 'X', B: 'Y', C: 'Z'};
  for (const axis of data.axes) {
    const along = beside[axis];
    if (along) views.push(addView(data, selection, along, axis, 'Unrolled', along === 'X' ? plan : null));
  }
  return views;
}

function drawLegend(data) {
  const legend = document.getElementById('legend');
  legend.replaceChildren();
  const add = (label, draw) => {
    const item = document.createElement('li'), canvas = document.createElement('canvas');
    const density = Math.max(1, window.devicePixelRatio || 1);
    canvas.width = 32 * density;
    canvas.height = 20 * density;
    canvas.setAttribute('aria-hidden', 'true');
    const context = canvas.getContext('2d');
    context.scale(density, density);
    draw(context);
    item.append(canvas, label);
    legend.append(item);
  };
  const stroke = (name) => (context) => {
    context.strokeStyle = palette[name];
    context.lineWidth = strokes[name].width;
    context.setLineDash(strokes[name].dash);
    context.beginPath();
    context.moveTo(1, 10);
    context.lineTo(31, 10);
    context.stroke();
  };
  if (data.moveKinds.includes('r')) add('rapid', stroke('rapid'));
  if (data.moveKinds.includes('l')) add('line', stroke('line'));
  if (data.arcs.size) add('arc', stroke('arc'));
  if (data.holes.x.length) {
    add(`drilled hole (${data.holes.x.length})`, (context) => {
      context.strokeStyle = palette.hole;
      context.lineWidth = 1.6;
      drawHole(context, 20, 10);
    });
  }
  if (!data.moveCount) return;
  add('start', (context) => { drawStart(context, 20, 10); });
  add('end', (context) => { drawEnd(context, 22, 10); });
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
  drawLegend(data);

  selection.listeners.push((by) => {
    for (const picture of pictures) picture.redraw(false);
    table.showMarks();
    if (!by) return;
    if (by !== table && selection.chosen) table.reveal(selection.chosen);
    describeChosen(selection.chosen);
  });

  const repaint = () => {
    readPalette();
    drawLegend(data);
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
