// A path of moves on a view: where its moves run on the picture.

class PathOnView {
  constructor(view, path) {
    this.view = view;
    this.path = path;
    this.h = view.h;
    this.v = view.v;
  }

  /** Position on the view after a fraction of a move. */
  at(move, fraction) {
    const {start, end} = this.path;
    const straight = (axis) => start[axis][move] + fraction * (end[axis][move] - start[axis][move]);
    const arc = this.path.arcs.get(move);
    if (!arc || fraction <= 0 || fraction >= 1 || arc.plane === '??') return [straight(this.h), straight(this.v)];
    const [p, q] = arc.plane;
    const dp = start[p][move] - arc.first, dq = start[q][move] - arc.second;
    const radius = Math.hypot(dp, dq) * (1 - fraction) +
        Math.hypot(end[p][move] - arc.first, end[q][move] - arc.second) * fraction;
    const angle = Math.atan2(dq, dp) + fraction * arc.sweep;
    const turned = (axis) => axis === p ? arc.first + radius * Math.cos(angle) :
        axis === q ? arc.second + radius * Math.sin(angle) : straight(axis);
    return [turned(this.h), turned(this.v)];
  }

  radius(move, arc) {
    const [p, q] = arc.plane === '??' ? 'XY' : arc.plane;
    return Math.hypot(this.path.start[p][move] - arc.first, this.path.start[q][move] - arc.second);
  }

  /** Chords of a move that stay within a quarter of a pixel of it. */
  chords(move, most) {
    const arc = this.path.arcs.get(move);
    if (!arc) return 1;
    const pixels = Math.max(1, this.radius(move, arc) * this.view.scale * Math.max(1, this.view.stretch));
    return Math.min(most, Math.max(4, Math.ceil(Math.abs(arc.sweep) / Math.sqrt(2 / pixels))));
  }

  /** Whether a move may come into the rectangle, given in machine coordinates. */
  touches(move, box) {
    return this.spans(move, this.h, box.left, box.right) && this.spans(move, this.v, box.bottom, box.top);
  }

  spans(move, axis, low, high) {
    const {start, end, arcs} = this.path, from = start[axis][move], to = end[axis][move];
    if ((from >= low || to >= low) && (from <= high || to <= high)) return true;
    const arc = arcs.size ? arcs.get(move) : undefined, part = arc ? arc.plane.indexOf(axis) : -1;
    if (part < 0) return false;
    const center = part === 0 ? arc.first : arc.second, radius = this.radius(move, arc) * 1.01;
    return Math.max(from, to, center + radius) >= low && Math.min(from, to, center - radius) <= high;
  }

  /** Strokes a move with a pen. */
  trace(pen, move, mostChords) {
    const {view} = this, {start, end} = this.path;
    pen.moveTo(view.toX(start[this.h][move]), view.toY(start[this.v][move]));
    const chords = this.chords(move, mostChords);
    for (let i = 1; i < chords; ++i) {
      const [x, y] = this.at(move, i / chords);
      pen.lineTo(view.toX(x), view.toY(y));
    }
    pen.lineTo(view.toX(end[this.h][move]), view.toY(end[this.v][move]));
  }

  /** Pixels from a place on the picture to a move. */
  distance(move, x, y) {
    const {view} = this;
    const chords = this.chords(move, 200);
    let nearest = Infinity, [fromX, fromY] = this.at(move, 0).map((v, i) => i ? view.toY(v) : view.toX(v));
    for (let i = 1; i <= chords; ++i) {
      const [mx, my] = this.at(move, i / chords);
      const toX = view.toX(mx), toY = view.toY(my);
      nearest = Math.min(nearest, distanceToSegment(x, y, fromX, fromY, toX, toY));
      fromX = toX;
      fromY = toY;
    }
    return nearest;
  }
}
