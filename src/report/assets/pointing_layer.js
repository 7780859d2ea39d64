// Ticks along the path to where the tool points under normal line control.

const tickLength = 11;   // pixels
const tickSpacing = 24;  // pixels along the path

/** Ticks stand evenly on the picture whatever its zoom, and at both ends of turns at rest. */
class PointingLayer {
  constructor(view) {
    this.name = 'pointing';
    this.above = true;
    this.view = view;
  }

  draw(context) {
    const {view} = this, {axis, move, count, zero, plane} = view.data.pointing;
    this.context = context;
    this.ticks = new Set();
    this.start = view.data.moves.start[axis];
    this.end = view.data.moves.end[axis];
    this.since = tickSpacing;  // way along the path since the last tick
    setStroke(context, 'pointing');
    context.beginPath();
    for (let run = 0, behind = 0; run < move.length; ++run) {
      if (move[run] !== behind) this.since = tickSpacing;
      behind = move[run] + count[run];
      if (!looksAt(view, plane[run])) continue;
      this.zero = zero[run];
      this.mirrored = planeNames[plane[run]][0] === view.v;
      for (let i = move[run]; i < behind; ++i) this.add(i);
    }
    context.stroke();
  }

  add(move) {
    const {arcs} = this.view.data.moves, arc = arcs.size ? arcs.get(move) : undefined;
    const length = this.lengthOf(move, arc);
    if (length < 1e-3) { this.addTurn(move); return; }
    if (length < tickSpacing) {  // one of many short moves, or a short one between corners
      this.since += length;
      if (this.since < tickSpacing) return;
      this.tick(move, 0.5);
      this.since = length / 2;
      return;
    }
    // Even parts of the move with a tick in the middle of each: corners and smooth joints keep their distance.
    const parts = Math.round(length / tickSpacing);
    const [first, last] = arc ? [0, Math.min(parts, 20000)] : this.partsInSight(move, parts);
    for (let part = first; part < last; ++part) this.tick(move, (part + 0.5) / parts);
    this.since = length / parts / 2;
  }

  addTurn(move) {
    const turn = Math.abs(this.end[move] - this.start[move]);
    if (turn < 1e-6 || (turn < 15 && this.since < tickSpacing / 2)) return;
    this.tick(move, 0);
    this.tick(move, 1);
    this.since = 0;
  }

  /** The length of a move on the picture. */
  lengthOf(move, arc) {
    const {view} = this, {moves} = view, {start, end} = moves.path;
    const across = view.scale, up = view.scale * view.stretch;
    if (!arc) {
      return Math.hypot((end[view.h][move] - start[view.h][move]) * across, (end[view.v][move] - start[view.v][move]) * up);
    }
    const parts = Math.min(720, Math.max(2, Math.ceil(Math.abs(arc.sweep) * 180 / Math.PI / 6)));
    let length = 0, last = moves.at(move, 0);
    for (let part = 1; part <= parts; ++part) {
      const next = moves.at(move, part / parts);
      length += Math.hypot((next[0] - last[0]) * across, (next[1] - last[1]) * up);
      last = next;
    }
    return length;
  }

  /** The parts of a straight way that may show ticks: first, and one behind the last. */
  partsInSight(move, parts) {
    const {view} = this, [from, to] = [0, 1].map((fraction) => {
      const [x, y] = view.moves.at(move, fraction);
      return [view.toX(x), view.toY(y)];
    });
    const sizes = [view.picture.width, view.picture.height];
    let first = 0, last = 1;
    for (const i of [0, 1]) {
      const way = to[i] - from[i], low = -tickLength - from[i], high = sizes[i] + tickLength - from[i];
      if (Math.abs(way) < 1e-9) {
        if (low > 0 || high < 0) return [0, 0];
        continue;
      }
      first = Math.max(first, Math.min(low / way, high / way));
      last = Math.min(last, Math.max(low / way, high / way));
    }
    return first < last ? [Math.floor(first * parts), Math.ceil(last * parts)] : [0, 0];
  }

  /** A tick, unless one like it is there: a picture full of them stays quick. */
  tick(move, fraction) {
    const {view, context} = this;
    const [px, py] = view.moves.at(move, fraction);
    const x = view.toX(px), y = view.toY(py);
    if (!(x > -tickLength && x < view.picture.width + tickLength)) return;
    if (!(y > -tickLength && y < view.picture.height + tickLength)) return;
    const [toX, toY] = this.direction(move, fraction);
    const key = [x, y, toX / 2, toY / 2].map(Math.round).join();
    if (this.ticks.has(key)) return;
    this.ticks.add(key);
    context.moveTo(x, y);
    context.lineTo(x + toX, y + toY);
  }

  /** From the axis's angle to the first axis of the plane, as a tick on the picture. */
  direction(move, fraction) {
    const angle = (this.start[move] + fraction * (this.end[move] - this.start[move]) - this.zero) * Math.PI / 180;
    const first = Math.cos(angle), second = Math.sin(angle);
    const x = this.mirrored ? second : first, y = -(this.mirrored ? first : second) * this.view.stretch;
    const length = tickLength / Math.hypot(x, y);
    return [x * length, y * length];
  }
}
