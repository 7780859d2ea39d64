// Colours from the style sheet, and how numbers are shown.

const palette = {};

function readPalette() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ['surface', 'edge', 'grid', 'text', 'soft', 'rapid', 'line', 'arc', 'programmed', 'swept',
                      'pointing', 'hole', 'mark', 'area']) {
    palette[name] = style.getPropertyValue('--' + name).trim();
  }
}

/** How each kind of stroke is drawn: told apart by weight and dashes as well as by colour. */
const strokes = {
  rapid: {width: 1, dash: [5, 4]},
  line: {width: 1.3, dash: []},
  arc: {width: 2.4, dash: []},
  programmed: {width: 1.1, dash: [9, 3]},
  pointing: {width: 1.5, dash: []},
};

function setStroke(context, name) {
  context.strokeStyle = palette[name];
  context.lineWidth = strokes[name].width;
  context.setLineDash(strokes[name].dash);
}

const strokeOf = (kind) => kind === 'r' ? 'rapid' : kind === 'l' ? 'line' : 'arc';

const canvasFont = '12px system-ui, -apple-system, "Segoe UI", "DejaVu Sans", Arial, sans-serif';

function clock(seconds) {
  const tenths = Math.round(seconds * 10);
  const two = (n) => String(n).padStart(2, '0');
  return `${Math.floor(tenths / 36000)}:${two(Math.floor(tenths / 600) % 60)}:${two(Math.floor(tenths / 10) % 60)}.${tenths % 10}`;
}

/** Seconds with as many decimals as short blocks need. */
const duration = (seconds) => seconds >= 100 ? seconds.toFixed(1) : seconds.toFixed(3);

/** The smallest of 1, 2, 5 times a power of ten that is at least the value. */
function roundUp125(value) {
  const power = Math.pow(10, Math.floor(Math.log10(value)));
  for (const factor of [1, 2, 5]) if (factor * power >= value * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

/** Ticks that are multiples of a step, with their labels. */
function ticksBetween(low, high, step) {
  const decimals = Math.min(6, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9) && ticks.length < 200; ++i) {
    ticks.push({value: i * step, label: (i === 0 ? 0 : i * step).toFixed(decimals)});
  }
  return ticks;
}
