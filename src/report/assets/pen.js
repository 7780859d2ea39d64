// Drawing on a canvas: long strokes, and the marks for holes, start and end.

/** Joins strokes that follow each other and leaves out points closer than a screen shows. */
class Pen {
  /** `closest`: points nearer than this, in pixels, are one. `stroke` strokes the context's path; a pen whose
      strokes may overlap can stroke a long path in `pieces`. */
  constructor(context, {closest = 0.6, stroke = () => context.stroke(), pieces = false} = {}) {
    this.context = context;
    this.closest = closest;
    this.strokePath = stroke;
    this.pieces = pieces;
    this.count = 0;
    this.x = this.y = NaN;
    this.skipped = false;
    context.beginPath();
  }
  moveTo(x, y) {
    const joined = Math.abs(x - this.nextX) < 0.01 && Math.abs(y - this.nextY) < 0.01;
    if (joined) return;
    this.flush();
    if (this.count > 4000) this.stroke();
    this.context.moveTo(x, y);
    this.x = this.nextX = x;
    this.y = this.nextY = y;
  }
  lineTo(x, y) {
    this.nextX = x;
    this.nextY = y;
    this.skipped = Math.abs(x - this.x) < this.closest && Math.abs(y - this.y) < this.closest;
    if (!this.skipped) this.emit();
  }
  emit() {
    this.context.lineTo(this.nextX, this.nextY);
    this.x = this.nextX;
    this.y = this.nextY;
    this.skipped = false;
    ++this.count;
    if (!this.pieces || this.count < 500) return;
    this.stroke();
    this.context.moveTo(this.x, this.y);
  }
  flush() { if (this.skipped) this.emit(); }
  stroke() {
    this.strokePath();
    this.context.beginPath();
    this.count = 0;
  }
  finish() { this.flush(); this.strokePath(); }
}

function distanceToSegment(x, y, x1, y1, x2, y2) {
  const dx = x2 - x1, dy = y2 - y1, square = dx * dx + dy * dy;
  // A move straight through the picture is a point; others near it are easier to mean.
  if (square < 0.25) return Math.hypot(x - x1, y - y1) + 3;
  const t = Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / square));
  return Math.hypot(x - x1 - t * dx, y - y1 - t * dy);
}

function drawHole(context, x, y) {
  context.beginPath();
  context.arc(x, y, 4.5, 0, 2 * Math.PI);
  context.moveTo(x - 7.5, y);
  context.lineTo(x + 7.5, y);
  context.moveTo(x, y - 7.5);
  context.lineTo(x, y + 7.5);
  context.stroke();
}

function drawStart(context, x, y) {
  context.strokeStyle = palette.text;
  context.lineWidth = 1.8;
  context.beginPath();
  context.arc(x, y, 7.5, 0, 2 * Math.PI);
  context.stroke();
}

function drawEnd(context, x, y) {
  context.fillStyle = palette.text;
  context.fillRect(x - 4, y - 4, 8, 8);
}
