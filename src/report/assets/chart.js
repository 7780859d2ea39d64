// The speed along the path over time.

const chartMargin = {left: 58, right: 14, top: 22, bottom: 26};

class SpeedChart {
  constructor(host, data, selection, readout) {
    this.data = data;
    this.selection = selection;
    this.readout = readout;
    const last = data.rows.length ? data.rows[data.rows.length - 1] : null;
    const samples = data.speed.time;
    this.total = Math.max(samples.length ? samples[samples.length - 1] : 0, last ? last.start + last.time : 0) || 1;
    this.top = 0;
    for (const feed of data.speed.feed) this.top = Math.max(this.top, feed);
    this.top = (this.top || 1) * 1.06;
    this.reset();
    this.picture = new Picture(host, 'Speed along the path over time', {
      draw: (context) => this.draw(context),
      mark: (context) => this.mark(context),
      pan: (dx) => this.show(this.low - dx / this.scale(), this.high - dx / this.scale()),
      zoom: (factor, x) => this.zoom(factor, x),
      reset: () => this.reset(),
      point: (x) => this.point(x),
      pick: (x) => this.selection.choose(this.rowAt(x), this),
    });
  }

  reset() { this.low = 0; this.high = this.total; }

  plotWidth() { return Math.max(1, this.picture.width - chartMargin.left - chartMargin.right); }
  plotHeight() { return Math.max(1, this.picture.height - chartMargin.top - chartMargin.bottom); }
  scale() { return this.plotWidth() / (this.high - this.low); }
  toX(time) { return chartMargin.left + (time - this.low) * this.scale(); }
  toTime(x) { return this.low + (x - chartMargin.left) / this.scale(); }
  toY(feed) { return chartMargin.top + this.plotHeight() * (1 - feed / this.top); }

  /** Shows a stretch of time, moved to lie within the run. */
  show(low, high) {
    const span = Math.min(this.total, Math.max(1e-3, high - low));
    this.low = Math.min(Math.max(0, low), this.total - span);
    this.high = this.low + span;
  }

  zoom(factor, x) {
    const time = this.toTime(x), span = (this.high - this.low) / factor;
    const share = (time - this.low) / (this.high - this.low);
    this.show(time - share * span, time + (1 - share) * span);
  }

  rowAt(x) {
    const row = rowAtTime(this.data.rows, this.toTime(x));
    return row < 0 ? null : this.data.rows[row];
  }

  draw(context) {
    const {width, height} = this.picture;
    const bottom = height - chartMargin.bottom;
    const feeds = ticksBetween(0, this.top, roundUp125(this.top * 34 / this.plotHeight()));
    const times = ticksBetween(this.low, this.high, roundUp125(80 / this.scale()));
    context.strokeStyle = palette.grid;
    context.lineWidth = 1;
    context.beginPath();
    for (const tick of feeds) {
      const y = Math.round(this.toY(tick.value)) + 0.5;
      context.moveTo(chartMargin.left, y);
      context.lineTo(width - chartMargin.right, y);
    }
    for (const tick of times) {
      const x = Math.round(this.toX(tick.value)) + 0.5;
      context.moveTo(x, chartMargin.top);
      context.lineTo(x, bottom);
    }
    context.stroke();
    context.save();
    context.beginPath();
    context.rect(chartMargin.left, 0, this.plotWidth(), bottom + 1);
    context.clip();
    this.drawSpeed(context, bottom);
    context.restore();
    context.fillStyle = palette.soft;
    context.textAlign = 'right';
    for (const tick of feeds) context.fillText(tick.label, chartMargin.left - 7, this.toY(tick.value) + 4);
    context.textAlign = 'center';
    for (const tick of times) {
      const x = this.toX(tick.value);
      if (x < width - 36) context.fillText(tick.label, x, height - 9);
    }
    context.textAlign = 'left';
    context.fillText('mm/min', 6, 14);
    context.textAlign = 'right';
    context.fillText('s', width - chartMargin.right, height - 9);
  }

  drawSpeed(context, bottom) {
    const points = this.visiblePoints();
    if (!points.length) {
      context.fillStyle = palette.text;
      context.textAlign = 'center';
      context.fillText('no motion', this.picture.width / 2, this.picture.height / 2);
      return;
    }
    context.beginPath();
    context.moveTo(points[0], bottom);
    for (let i = 0; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
    context.lineTo(points[points.length - 2], bottom);
    context.fillStyle = palette.area;
    context.fill();
    context.beginPath();
    for (let i = 0; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
    context.strokeStyle = palette.line;
    context.lineWidth = 1.4;
    context.stroke();
  }

  /** x and y of the visible samples; where many share a pixel, first, least, largest and last of them. */
  visiblePoints() {
    const {time, feed} = this.data.speed;
    let first = firstAfter(time, this.low) - 1;
    const last = Math.min(time.length - 1, firstAfter(time, this.high));
    first = Math.max(0, first);
    const points = [];
    if (last - first < 3 * this.plotWidth()) {
      for (let i = first; i <= last; ++i) points.push(this.toX(time[i]), this.toY(feed[i]));
      return points;
    }
    for (let i = first; i <= last;) {
      const x = Math.floor(this.toX(time[i]));
      let least = feed[i], largest = feed[i];
      const entry = feed[i];
      for (; i <= last && Math.floor(this.toX(time[i])) === x; ++i) {
        least = Math.min(least, feed[i]);
        largest = Math.max(largest, feed[i]);
      }
      for (const value of [entry, least, largest, feed[i - 1]]) points.push(x, this.toY(value));
    }
    return points;
  }

  mark(context) {
    const {chosen, pointed} = this.selection;
    if (chosen) this.markRow(context, chosen, 0.3);
    if (pointed && pointed !== chosen) this.markRow(context, pointed, 0.16);
    if (this.cursor !== undefined && this.cursor !== null) this.drawCursor(context);
  }

  markRow(context, row, opacity) {
    const left = Math.max(chartMargin.left, this.toX(row.start));
    const right = Math.min(this.picture.width - chartMargin.right, this.toX(row.start + row.time));
    if (right < left) return;
    context.fillStyle = palette.mark;
    context.globalAlpha = opacity;
    context.fillRect(left, chartMargin.top, Math.max(1.5, right - left), this.plotHeight());
    context.globalAlpha = 1;
    context.fillRect(left, this.picture.height - chartMargin.bottom - 2, Math.max(3, right - left), 4);
  }

  drawCursor(context) {
    const x = this.toX(this.cursor);
    context.strokeStyle = palette.soft;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, chartMargin.top);
    context.lineTo(x, this.picture.height - chartMargin.bottom);
    context.stroke();
    context.fillStyle = palette.mark;
    context.beginPath();
    context.arc(x, this.toY(this.feedAt(this.cursor)), 4, 0, 2 * Math.PI);
    context.fill();
  }

  feedAt(t) {
    const {time, feed} = this.data.speed;
    if (!time.length) return 0;
    const after = firstAfter(time, t);
    if (after === 0 || after === time.length) return feed[Math.min(after, time.length - 1)];
    const share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return feed[after - 1] + share * (feed[after] - feed[after - 1]);
  }

  point(x) {
    const inside = x !== null && x >= chartMargin.left && x <= this.picture.width - chartMargin.right;
    this.cursor = inside ? this.toTime(x) : null;
    const row = inside ? this.rowAt(x) : null;
    const feed = inside ? this.feedAt(this.cursor) : 0;
    this.readout.textContent = !inside ? '' :
        `${this.cursor.toFixed(3)} s · ${feed.toFixed(1)} mm/min` + (row ? ` · line ${row.line}` : '');
    this.selection.point(row);
    this.picture.redraw(false);
  }
}

/** Index of the first sample later than a time; the number of samples when there is none. */
function firstAfter(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1; else high = middle;
  }
  return low;
}
