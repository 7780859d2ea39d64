// What the strokes of the views mean; what the tool does besides can be hidden here.

/** Swatch with a text, and with `toggle` a box to tick. */
function legendItem(label, draw, toggle) {
  const item = document.createElement('li'), canvas = document.createElement('canvas');
  const density = Math.max(1, window.devicePixelRatio || 1);
  canvas.width = 32 * density;
  canvas.height = 20 * density;
  canvas.setAttribute('aria-hidden', 'true');
  const context = canvas.getContext('2d');
  context.scale(density, density);
  draw(context);
  if (!toggle) {
    item.append(canvas, label);
    return item;
  }
  const name = document.createElement('label'), box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = toggle.shown;
  box.addEventListener('change', () => toggle.show(box.checked));
  name.append(box, canvas, label);
  item.append(name);
  return item;
}

function sampleStroke(name) {
  return (context) => {
    setStroke(context, name);
    context.beginPath();
    context.moveTo(1, 10);
    context.lineTo(31, 10);
    context.stroke();
    context.setLineDash([]);
  };
}

function sampleSwept(context) {
  context.globalAlpha = sweptOpacity;
  context.fillStyle = palette.swept;
  context.fillRect(2, 3, 28, 14);
}

function samplePointing(context) {
  setStroke(context, 'line');
  context.beginPath();
  context.moveTo(1, 15);
  context.lineTo(31, 15);
  context.stroke();
  setStroke(context, 'pointing');
  context.beginPath();
  for (const x of [8, 24]) {
    context.moveTo(x, 15);
    context.lineTo(x, 4);
  }
  context.stroke();
}

const layerSamples = {
  programmed: ['programmed path', sampleStroke('programmed')],
  swept: ['swept by the tool', sampleSwept],
  pointing: ['where the tool points', samplePointing],
};

/** `redraw` is called when a layer of the views was shown or hidden. */
function drawLegend(data, views, selection, redraw) {
  const items = [], layers = [];
  const add = (label, draw) => items.push(legendItem(label, draw));
  if (data.moveKinds.includes('r')) add('rapid', sampleStroke('rapid'));
  if (data.moveKinds.includes('l')) add('line', sampleStroke('line'));
  if (data.moves.arcs.size) add('arc', sampleStroke('arc'));
  if (data.holes.x.length) {
    add(`drilled hole (${data.holes.x.length})`, (context) => {
      context.strokeStyle = palette.hole;
      context.lineWidth = 1.6;
      drawHole(context, 20, 10);
    });
  }
  if (data.moveCount) {
    add('start', (context) => { drawStart(context, 20, 10); });
    add('end', (context) => { drawEnd(context, 22, 10); });
  }
  for (const [name, [label, sample]] of Object.entries(layerSamples)) {
    if (!views.some((view) => view.toolLayers.some((layer) => layer.name === name))) continue;
    const show = (shown) => {
      if (shown) selection.hidden.delete(name); else selection.hidden.add(name);
      redraw();
    };
    layers.push(legendItem(label, sample, {shown: !selection.hidden.has(name), show}));
  }
  document.getElementById('legend').replaceChildren(...items);
  document.getElementById('layers').replaceChildren(...layers);
}
