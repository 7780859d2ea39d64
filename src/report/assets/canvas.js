// A picture of two canvases: a base that is drawn when the view changes, and marks above it that change with the
// mouse. Pan and zoom with mouse, wheel, keys and buttons.

class Picture {
  /** `on` receives draw(base), mark(overlay), pan(dx, dy), zoom(factor, x, y), reset(), point(x, y) and pick(x, y). */
  constructor(host, label, on) {
    this.host = host;
    this.on = on;
    this.base = this.addCanvas();
    this.overlay = this.addCanvas();
    this.stage = document.createElement('div');
    this.stage.className = 'stage';
    this.stage.tabIndex = 0;
    this.stage.setAttribute('role', 'img');
    this.stage.setAttribute('aria-label', label);
    host.append(this.stage);
    this.pending = {base: false, overlay: false};
    this.listen();
    new ResizeObserver(() => this.resize()).observe(host);
  }

  addCanvas() {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    this.host.append(canvas);
    return canvas.getContext('2d');
  }

  resize() {
    const box = this.host.getBoundingClientRect();
    if (box.width < 1 || box.height < 1) return;
    this.width = box.width;
    this.height = box.height;
    this.density = Math.min(3, Math.max(1, window.devicePixelRatio || 1));
    for (const context of [this.base, this.overlay]) {
      context.canvas.width = Math.round(box.width * this.density);
      context.canvas.height = Math.round(box.height * this.density);
    }
    this.drawNow();
  }

  /** Draws with the next frame, however often it is asked before. */
  redraw(whole = true) {
    if (!this.width) return;
    const waiting = this.pending.base || this.pending.overlay;
    this.pending.base ||= whole;
    this.pending.overlay = true;
    if (!waiting) requestAnimationFrame(() => this.drawPending());
  }

  drawPending() {
    if (this.pending.base) this.prepare(this.base, (context) => this.on.draw(context));
    if (this.pending.base || this.pending.overlay) this.prepare(this.overlay, (context) => this.on.mark(context));
    this.pending.base = this.pending.overlay = false;
  }

  drawNow() {
    if (!this.width) return;
    this.pending.base = this.pending.overlay = true;
    this.drawPending();
  }

  prepare(context, draw) {
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    context.font = canvasFont;
    context.lineJoin = context.lineCap = 'round';
    draw(context);
  }

  listen() {
    const stage = this.stage;
    let drag = null;
    const place = (event) => {
      const box = stage.getBoundingClientRect();
      return {x: event.clientX - box.left, y: event.clientY - box.top};
    };
    stage.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      drag = {...place(event), moved: false};
      stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener('pointermove', (event) => {
      const at = place(event);
      if (!drag) { this.on.point(at.x, at.y); return; }
      const dx = at.x - drag.x, dy = at.y - drag.y;
      if (!drag.moved && Math.hypot(dx, dy) < 4) return;
      stage.classList.add('dragging');
      this.on.pan(dx, dy);
      drag = {...at, moved: true};
      this.redraw();
    });
    const release = (event) => {
      const at = place(event);
      if (drag && !drag.moved && event.type === 'pointerup') this.on.pick(at.x, at.y);
      drag = null;
      stage.classList.remove('dragging');
    };
    stage.addEventListener('pointerup', release);
    stage.addEventListener('pointercancel', release);
    stage.addEventListener('pointerleave', () => { if (!drag) this.on.point(null, null); });
    stage.addEventListener('dblclick', () => { this.on.reset(); this.redraw(); });
    stage.addEventListener('wheel', (event) => {
      // Without the focus the wheel scrolls the page, as readers expect.
      if (document.activeElement !== stage && !event.ctrlKey) return;
      event.preventDefault();
      const at = place(event);
      this.zoomBy(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)), at.x, at.y);
    }, {passive: false});
    stage.addEventListener('keydown', (event) => this.key(event));
  }

  zoomBy(factor, x = this.width / 2, y = this.height / 2) {
    this.on.zoom(factor, x, y);
    this.redraw();
  }

  key(event) {
    const step = 60;
    const actions = {
      '+': () => this.zoomBy(1.4), '=': () => this.zoomBy(1.4), '-': () => this.zoomBy(1 / 1.4),
      '0': () => this.on.reset(), 'ArrowLeft': () => this.on.pan(step, 0), 'ArrowRight': () => this.on.pan(-step, 0),
      'ArrowUp': () => this.on.pan(0, step), 'ArrowDown': () => this.on.pan(0, -step),
    };
    if (event.ctrlKey || event.metaKey || event.altKey || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
    this.redraw();
  }

  /** Appends the buttons that do what mouse and keys do. */
  addButtons(host, what) {
    const button = (text, label, act) => {
      const element = document.createElement('button');
      element.type = 'button';
      element.textContent = text;
      element.setAttribute('aria-label', `${label}, ${what}`);
      element.title = label;
      element.addEventListener('click', act);
      host.append(element);
    };
    button('+', 'Zoom in', () => this.zoomBy(1.6));
    button('−', 'Zoom out', () => this.zoomBy(1 / 1.6));
    button('Fit', 'Show everything', () => { this.on.reset(); this.redraw(); });
  }
}
