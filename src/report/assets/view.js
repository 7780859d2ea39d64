// One view of the toolpath: two axes of the machine on a picture that can be moved and zoomed.

const viewMargin = {left: 46, right: 20, top: 26, bottom: 46};
const pickDistance = 9;  // pixels

class ToolpathView {
  /** `leader` is the view above with the same horizontal axis, whose scale this one shares; null without one. */
  constructor(host, data, horizontal, vertical, selection, leader) {
    this.data = data;
    this.leader = leader;
    this.h = horizontal;
    this.v = vertical;
    this.selection = selection;
    this.pristine = true;
    this.stretch = 1;  // vertical over horizontal scale
    this.plan = vertical === 'Y';
    this.true = this.plan || data.shapes.includes(horizontal + vertical);  // to scale, whatever it takes
    this.moves = new PathOnView(this, data.moves);
    this.toolLayers = toolLayersOf(this);
    host.style.height = `${this.preferredHeight(host.clientWidth || 800)}px`;
    this.picture = new Picture(host, `${horizontal}-${vertical} view of the toolpath`, {
      draw: (context) => this.draw(context),
      mark: (context) => this.mark(context),
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, x, y) => this.zoom(factor, x, y),
      reset: () => { this.pristine = true; this.fit(); },
      point: (x, y) => this.point(x, y),
      pick: (x, y) => this.selection.choose(this.rowAt(x, y), this),
    });
  }

  extent(axis) {
    const [low, high] = this.data.limits[axis];
    return {middle: (low + high) / 2, length: high - low};
  }

  /** Tall enough to use the width, within what fits a screen. */
  preferredHeight(width) {
    const x = this.extent(this.h).length || 1, y = this.extent(this.v).length;
    const margins = viewMargin.top + viewMargin.bottom;
    if (this.true) return Math.min(560, Math.max(240, width * y / x + margins));
    if (!'XYZ'.includes(this.v)) return 280;  // an angle has no scale to keep
    const scale = this.leader && this.leader.fittedScale ? this.leader.fittedScale : width / x;
    return Math.min(380, Math.max(180, y * scale + margins));
  }

  fit() {
    const x = this.extent(this.h), y = this.extent(this.v);
    const width = Math.max(40, this.picture.width - viewMargin.left - viewMargin.right);
    const height = Math.max(40, this.picture.height - viewMargin.top - viewMargin.bottom);
    const tiny = 1e-6;
    const byWidth = x.length > tiny ? width / x.length : Infinity;
    const byHeight = this.true && y.length > tiny ? height / y.length : Infinity;
    this.scale = Math.min(byWidth, byHeight);
    if (!Number.isFinite(this.scale)) this.scale = width / 10;
    if (this.leader && this.leader.fittedScale) this.scale = this.leader.fittedScale;
    this.fittedScale = this.scale;
    this.stretch = this.true || y.length < tiny ? 1 : this.fittingStretch(height / (y.length * this.scale));
    this.centerX = x.middle;
    this.centerY = y.middle;
  }

  /** Heights that are flat or do not fit are drawn larger or smaller by a round factor; angles fill the picture. */
  fittingStretch(filling) {
    if (!'XYZ'.includes(this.v)) return filling;
    if (filling < 1) return 1 / roundUp125(1 / filling);
    return filling > 3 ? roundUp125(filling / 2.5) : 1;
  }

  toX(x) { return this.originX + (x - this.centerX) * this.scale; }
  toY(y) { return this.originY - (y - this.centerY) * this.scale * this.stretch; }
  fromX(px) { return this.centerX + (px - this.originX) / this.scale; }
  fromY(py) { return this.centerY - (py - this.originY) / (this.scale * this.stretch); }

  pan(dx, dy) {
    this.pristine = false;
    this.centerX -= dx / this.scale;
    this.centerY += dy / (this.scale * this.stretch);
  }

  zoom(factor, x, y) {
    this.pristine = false;
    const atX = this.fromX(x), atY = this.fromY(y);
    this.scale = Math.min(1e7, Math.max(1e-4, this.scale * factor));
    this.centerX += atX - this.fromX(x);
    this.centerY += atY - this.fromY(y);
  }

  boxAround(left, top, right, bottom) {
    return {left: this.fromX(left), right: this.fromX(right), top: this.fromY(top), bottom: this.fromY(bottom)};
  }

  draw(context) {
    const {width, height} = this.picture;
    this.originX = viewMargin.left + (width - viewMargin.left - viewMargin.right) / 2;
    this.originY = viewMargin.top + (height - viewMargin.top - viewMargin.bottom) / 2;
    if (this.pristine) this.fit();
    this.drawGrid(context);
    this.drawFeedLimits(context);
    const box = this.boxAround(-10, -10, width + 10, height + 10);
    const shows = (layer) => !this.selection.hidden.has(layer.name);
    const layers = this.toolLayers.filter(shows);
    for (const layer of layers) if (!layer.above) layer.draw(context, box);
    for (const name of ['rapid', 'line', 'arc']) this.drawKind(context, name, box);
    for (const layer of layers) if (layer.above) layer.draw(context, box);
    if (this.plan) this.drawHoles(context, box);
    this.drawEnds(context);
    this.drawLabels(context);
  }

  /** Steps of the grid: the same for both axes unless their scales differ. */
  gridSteps() {
    const x = roundUp125(76 / this.scale);
    return this.stretch === 1 ? [x, x] : [x, roundUp125(38 / (this.scale * this.stretch))];
  }

  drawGrid(context) {
    const {width, height} = this.picture;
    const [stepX, stepY] = this.gridSteps();
    this.ticksX = ticksBetween(this.fromX(0), this.fromX(width), stepX);
    this.ticksY = ticksBetween(this.fromY(height), this.fromY(0), stepY);
    context.strokeStyle = palette.grid;
    context.lineWidth = 1;
    context.beginPath();
    for (const tick of this.ticksX) {
      const x = Math.round(this.toX(tick.value)) + 0.5;
      context.moveTo(x, 0);
      context.lineTo(x, height);
    }
    for (const tick of this.ticksY) {
      const y = Math.round(this.toY(tick.value)) + 0.5;
      context.moveTo(0, y);
      context.lineTo(width, y);
    }
    context.stroke();
  }

  drawFeedLimits(context) {
    const limits = this.data.feedLimits;
    if (!limits) return;
    const [left, right] = limits[this.h].map((x) => this.toX(x));
    const [bottom, top] = limits[this.v].map((y) => this.toY(y));
    context.strokeStyle = palette.soft;
    context.lineWidth = 1;
    context.setLineDash([1, 4]);
    context.strokeRect(left, top, right - left, bottom - top);
    context.setLineDash([]);
  }

  drawKind(context, name, box) {
    const {data} = this;
    setStroke(context, name);
    const pen = new Pen(context);
    for (let move = 0; move < data.moveCount; ++move) {
      if (strokeOf(data.moveKinds[move]) === name && this.moves.touches(move, box)) this.moves.trace(pen, move, 4000);
    }
    pen.finish();
    context.setLineDash([]);
  }

  drawHoles(context, box) {
    const {x, y} = this.data.holes;
    context.strokeStyle = palette.hole;
    context.lineWidth = 1.6;
    for (let i = 0; i < x.length; ++i) {
      if (x[i] < box.left || x[i] > box.right || y[i] < box.bottom || y[i] > box.top) continue;
      drawHole(context, this.toX(x[i]), this.toY(y[i]));
    }
  }

  drawEnds(context) {
    const {data} = this, last = data.moveCount - 1;
    if (last < 0) return;
    drawEnd(context, this.toX(data.moves.end[this.h][last]), this.toY(data.moves.end[this.v][last]));
    drawStart(context, this.toX(data.moves.start[this.h][0]), this.toY(data.moves.start[this.v][0]));
  }

  drawLabels(context) {
    const {width, height} = this.picture;
    context.fillStyle = palette.soft;
    context.strokeStyle = palette.surface;
    context.lineWidth = 4;
    const label = (text, x, y) => { context.strokeText(text, x, y); context.fillText(text, x, y); };
    context.textAlign = 'center';
    for (const tick of this.ticksX) {
      const x = this.toX(tick.value);
      if (x > 44 && x < width - 34) label(tick.label, x, height - 7);
    }
    context.textAlign = 'left';
    for (const tick of this.ticksY) {
      const y = this.toY(tick.value);
      if (y > 26 && y < height - 24) label(tick.label, 6, y + 4);
    }
    context.fillStyle = palette.text;
    context.font = '600 ' + canvasFont;
    label(this.v, 6, 16);
    context.textAlign = 'right';
    label(this.h, width - 8, height - 7);
    context.font = canvasFont;
    if (!this.data.moveCount) {
      context.textAlign = 'center';
      label('nothing moves', width / 2, height / 2);
    }
    if (this.true) this.drawScaleBar(context, label);
  }

  drawScaleBar(context, label) {
    const {width, height} = this.picture;
    const length = roundUp125(60 / this.scale), right = width - 14, left = right - length * this.scale, y = height - 28;
    const bar = () => {
      context.beginPath();
      context.moveTo(left, y - 5);
      context.lineTo(left, y);
      context.lineTo(right, y);
      context.lineTo(right, y - 5);
      context.stroke();
    };
    bar();  // in the surface's colour: a halo over whatever lies below
    context.textAlign = 'center';
    label(`${Number(length.toPrecision(1))} mm`, (left + right) / 2, y - 7);
    context.strokeStyle = palette.text;
    context.lineWidth = 1.5;
    bar();
  }

  /** The blocks that are pointed at or chosen, above everything else. */
  mark(context) {
    if (this.scale === undefined) return;
    const {pointed, chosen} = this.selection;
    if (chosen) this.markRow(context, chosen, 4.5);
    if (pointed && pointed !== chosen) this.markRow(context, pointed, 3);
  }

  markRow(context, row, width) {
    if (row.move < 0) return;
    const last = row.move + Math.min(row.moves, 5000) - 1;
    for (const [color, extra] of [[palette.surface, 3], [palette.mark, 0]]) {
      context.strokeStyle = color;
      context.lineWidth = width + extra;
      const pen = new Pen(context);
      for (let move = row.move; move <= last; ++move) this.moves.trace(pen, move, 4000);
      pen.finish();
    }
    const x = this.toX(this.data.moves.end[this.h][last]), y = this.toY(this.data.moves.end[this.v][last]);
    context.fillStyle = palette.mark;
    context.beginPath();
    context.arc(x, y, width * 0.5 + 2.5, 0, 2 * Math.PI);
    context.fill();
  }

  point(x, y) {
    if (x === null) { this.selection.point(null); return; }
    this.pointAt = [x, y];
    if (this.pointing) return;
    this.pointing = true;
    requestAnimationFrame(() => {
      this.pointing = false;
      this.selection.point(this.rowAt(...this.pointAt));
    });
  }

  /** The row whose move runs nearest to a place on the picture; null when none is near. */
  rowAt(x, y) {
    const {data} = this;
    const box = this.boxAround(x - pickDistance, y - pickDistance, x + pickDistance, y + pickDistance);
    let best = -1, nearest = pickDistance;
    for (let move = 0; move < data.moveCount; ++move) {
      if (!this.moves.touches(move, box)) continue;
      const distance = this.moves.distance(move, x, y);
      if (distance < nearest) { nearest = distance; best = move; }
    }
    return best < 0 ? null : data.rows[data.rowOfMove[best]];
  }
}
