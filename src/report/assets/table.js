// The table of blocks. Only the rows in sight exist in the page, so that long programs scroll as easily as short ones.

const columns = [
  {key: 'line', title: 'Line', figure: true, text: (row) => String(row.line || '')},
  {key: 'text', title: 'Block', width: 'auto', text: (row) => row.text, sort: (row) => row.text, style: 'text'},
  {key: 'what', title: 'What', width: '152px', text: (row) => row.what, sort: (row) => row.what},
  {key: 'length', title: 'mm', width: '84px', figure: true, text: (row) => row.move < 0 ? '' : row.length.toFixed(3)},
  {key: 'time', title: 's', width: '68px', figure: true, text: (row) => row.time > 0 ? duration(row.time) : ''},
  {key: 'peak', title: 'mm/min', width: '84px', figure: true, text: (row) => row.move < 0 ? '' : row.peak.toFixed(1)},
];

const columnHelp = {length: 'Path length, mm', time: 'Time, s', peak: 'Peak feed, mm/min'};

class BlockTable {
  constructor(data, selection) {
    this.rows = data.rows;
    this.selection = selection;
    this.host = document.getElementById('rows');
    this.body = document.getElementById('body');
    this.count = document.getElementById('blocks-count');
    this.text = document.getElementById('filter-text');
    this.kind = document.getElementById('filter-kind');
    this.order = {key: 'line', descending: false, natural: true};
    this.rowHeight = 27;
    this.addColumns();
    this.listen();
    this.filter();
  }

  addColumns() {
    const head = document.getElementById('columns');
    for (const column of columns) {
      const cell = document.createElement('th');
      cell.scope = 'col';
      cell.style.width = column.key === 'line' ? this.lineWidth() : column.width;
      if (column.figure) cell.className = 'figure';
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = column.title;
      button.title = `Sort by ${columnHelp[column.key] || column.title}`;
      button.addEventListener('click', () => this.sortBy(column.key));
      cell.append(button);
      head.append(cell);
      column.cell = cell;
      column.button = button;
    }
    this.showOrder();
  }

  /** Room for the largest line number. */
  lineWidth() {
    let largest = 0;
    for (const row of this.rows) largest = Math.max(largest, row.line);
    return `${Math.max(56, String(largest).length * 9 + 20)}px`;
  }

  /** First click sorts (figures largest first), second turns round, third restores the order of execution. */
  sortBy(key) {
    const column = columns.find((c) => c.key === key);
    const firstDescending = Boolean(column.figure) && key !== 'line';
    if (this.order.natural || this.order.key !== key) {
      this.order = {key, descending: firstDescending, natural: false};
    } else if (this.order.descending === firstDescending) {
      this.order = {key, descending: !firstDescending, natural: false};
    } else {
      this.order = {key: 'line', descending: false, natural: true};
    }
    this.showOrder();
    this.filter();
  }

  showOrder() {
    for (const column of columns) {
      const sorted = !this.order.natural && this.order.key === column.key;
      column.button.textContent = column.title + (sorted ? (this.order.descending ? ' ▾' : ' ▴') : '');
      if (sorted) column.cell.setAttribute('aria-sort', this.order.descending ? 'descending' : 'ascending');
      else column.cell.removeAttribute('aria-sort');
    }
  }

  listen() {
    this.host.addEventListener('scroll', () => this.render(), {passive: true});
    this.text.addEventListener('input', () => this.filter());
    this.kind.addEventListener('change', () => this.filter());
    new ResizeObserver(() => this.render()).observe(this.host);
    const rowOf = (event) => {
      const element = event.target.closest('tr[data-row]');
      return element ? this.rows[Number(element.dataset.row)] : null;
    };
    this.body.addEventListener('mouseover', (event) => this.selection.point(rowOf(event)));
    this.body.addEventListener('mouseleave', () => this.selection.point(null));
    this.body.addEventListener('click', (event) => {
      if (rowOf(event)) this.selection.choose(rowOf(event), this);
    });
    this.host.addEventListener('keydown', (event) => this.key(event));
  }

  key(event) {
    if (event.target !== this.host) return;
    const page = Math.max(1, Math.floor(this.host.clientHeight / this.rowHeight) - 2);
    const steps = {ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity};
    if (!(event.key in steps) || !this.shown.length) return;
    event.preventDefault();
    const at = this.placeOf(this.selection.chosen);
    const next = at < 0 ? 0 : Math.min(this.shown.length - 1, Math.max(0, at + steps[event.key]));
    this.selection.choose(this.shown[next], this);
    this.reveal(this.shown[next]);
  }

  /** Applies the filter and the order, and says what is left. */
  filter() {
    const wanted = this.text.value.trim().toLowerCase(), kinds = this.kind.value;
    const line = /^\d+$/.test(wanted) ? Number(wanted) : -1;
    const matches = (row) => {
      if (kinds && ![...kinds].some((kind) => row.kinds.includes(kind))) return false;
      return !wanted || row.line === line || row.text.toLowerCase().includes(wanted) ||
          row.what.toLowerCase().includes(wanted);
    };
    this.shown = wanted || kinds ? this.rows.filter(matches) : this.rows.slice();
    this.sort();
    this.places = null;
    let time = 0, length = 0;
    for (const row of this.shown) { time += row.time; length += row.length; }
    const number = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ' ');
    const share = this.shown.length === this.rows.length ? number(this.rows.length) :
        `${number(this.shown.length)} of ${number(this.rows.length)}`;
    this.count.textContent = `${share} · ${clock(time)} · ${length.toFixed(1)} mm`;
    this.host.firstElementChild.setAttribute('aria-rowcount', String(this.shown.length + 1));
    this.render(true);
  }

  sort() {
    if (this.order.natural) return;
    const column = columns.find((c) => c.key === this.order.key), sign = this.order.descending ? -1 : 1;
    const value = column.sort || ((row) => row[column.key]);
    const compare = (a, b) => a < b ? -sign : a > b ? sign : 0;
    this.shown.sort((a, b) => compare(value(a), value(b)) || a.index - b.index);
  }

  placeOf(row) {
    if (!row) return -1;
    if (!this.places) {
      this.places = new Int32Array(this.rows.length).fill(-1);
      this.shown.forEach((shown, i) => { this.places[shown.index] = i; });
    }
    return this.places[row.index];
  }

  /** Scrolls a row into sight. */
  reveal(row) {
    const place = this.placeOf(row);
    if (place < 0) return;
    const head = this.host.querySelector('thead').offsetHeight;
    const top = place * this.rowHeight, seen = this.host.clientHeight - head;
    if (top < this.host.scrollTop) this.host.scrollTop = Math.max(0, top - this.rowHeight * 2);
    else if (top + this.rowHeight > this.host.scrollTop + seen) this.host.scrollTop = top - seen + this.rowHeight * 3;
    this.render();
  }

  /** Makes the rows in sight and a few more; `all` up to a number for the printer. */
  render(force = false, all = 0) {
    const spare = 12, visible = Math.ceil(this.host.clientHeight / this.rowHeight);
    const first = all ? 0 : Math.max(0, Math.min(Math.floor(this.host.scrollTop / this.rowHeight) - spare,
                                                 this.shown.length - visible - spare));
    const last = Math.min(this.shown.length, all || first + visible + 2 * spare);
    if (!force && first === this.first && last === this.last) return;
    this.first = first;
    this.last = last;
    const gap = (rows) => {
      const row = document.createElement('tr'), cell = document.createElement('td');
      row.className = 'gap';
      row.setAttribute('aria-hidden', 'true');
      cell.colSpan = columns.length;
      cell.style.height = `${rows * this.rowHeight}px`;
      row.append(cell);
      return row;
    };
    const elements = [];
    if (first > 0) elements.push(gap(first));
    for (let i = first; i < last; ++i) elements.push(this.element(this.shown[i], i));
    if (last < this.shown.length && !all) elements.push(gap(this.shown.length - last));
    if (!this.shown.length) elements.push(this.emptyRow());
    this.body.replaceChildren(...elements);
    this.showMarks();
    this.measure();
  }

  emptyRow() {
    const row = document.createElement('tr'), cell = document.createElement('td');
    row.className = 'gap';
    cell.className = 'empty';
    cell.colSpan = columns.length;
    cell.textContent = this.rows.length ? 'No block matches.' : 'No block was executed.';
    row.append(cell);
    return row;
  }

  /** The height a row really has, which depends on the fonts. */
  measure() {
    const row = this.body.querySelector('tr[data-row]');
    const height = row ? row.getBoundingClientRect().height : 0;
    if (height > 0 && Math.abs(height - this.rowHeight) > 0.01) {
      this.rowHeight = height;
      this.render(true);
    }
  }

  element(row, place) {
    const element = document.createElement('tr');
    element.dataset.row = String(row.index);
    element.setAttribute('aria-rowindex', String(place + 2));
    if (row.kinds.includes('x')) element.className = 'alarm';
    else if (row.kinds.includes('w')) element.className = 'warning';
    for (const column of columns) {
      const cell = document.createElement('td');
      cell.textContent = column.text(row);
      if (column.figure) cell.className = 'figure';
      else if (column.style) cell.className = column.style;
      cell.title = cell.textContent;
      element.append(cell);
    }
    return element;
  }

  showMarks() {
    const {chosen, pointed} = this.selection;
    for (const element of this.body.children) {
      const row = this.rows[Number(element.dataset.row)];
      element.classList.toggle('chosen', Boolean(row) && row === chosen);
      element.classList.toggle('pointed', Boolean(row) && row === pointed);
      if (row && row === chosen) element.setAttribute('aria-current', 'true');
      else element.removeAttribute('aria-current');
    }
  }
}
