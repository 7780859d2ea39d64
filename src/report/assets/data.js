'use strict';
// The data of the page, as typed arrays in mm, degrees, seconds and mm/min.

/** Adds up differences and brings them to their unit. */
function restore(differences, unit) {
  const values = new Float64Array(differences.length);
  let sum = 0;
  for (let i = 0; i < differences.length; ++i) {
    sum += differences[i];
    values[i] = sum / unit;
  }
  return values;
}

const isMove = (kind) => kind === 'r' || kind === 'l' || kind === 'c' || kind === 'a';
const isArc = (kind) => kind === 'c' || kind === 'a';

const planeNames = ['XY', 'ZX', 'YZ', '??'];

/** Start positions per axis: where the move before ended, except where the data names another place. */
function startsOf(raw, axes, end) {
  const start = {};
  [...axes].forEach((axis, column) => {
    const values = new Float64Array(end[axis].length);
    values.set(end[axis].subarray(0, Math.max(0, values.length - 1)), Math.min(1, values.length));
    for (const jump of raw.jumps) values[jump[0]] = jump[column + 1] / 1000;
    start[axis] = values;
  });
  return start;
}

/** Arcs by move number; the plane as letters of its first and second axis. */
function arcsOf(raw) {
  const arcs = new Map();
  const move = restore(raw.move, 1), plane = restore(raw.plane, 1);
  const first = restore(raw.first, 1000), second = restore(raw.second, 1000);
  const sweep = restore(raw.sweep, 1000);
  for (let i = 0; i < move.length; ++i) {
    arcs.set(move[i], {plane: planeNames[plane[i]], first: first[i], second: second[i], sweep: sweep[i] * Math.PI / 180});
  }
  return arcs;
}

/** A path: starts and ends of its moves per axis, and its arcs. */
function pathOf(raw, axes) {
  const end = {};
  for (const axis of axes) end[axis] = restore(raw.end[axis], 1000);
  return {start: startsOf(raw, axes, end), end, arcs: arcsOf(raw.arcs), count: end[axes[0]].length};
}

/** Successive moves with something in common: first move, number, plane, and a value by its name. */
function runsOf(raw, name) {
  return {move: restore(raw.move, 1), count: restore(raw.count, 1), plane: restore(raw.plane, 1),
          [name]: restore(raw[name], 1000)};
}

function readData(raw) {
  const data = {
    axes: raw.axes, across: raw.across, shapes: raw.shapes, texts: raw.texts, kinds: raw.actions.kinds, notes: raw.actions.notes,
    start_s: restore(raw.actions.start, 1e4), duration_s: restore(raw.actions.duration, 1e4),
    moves: pathOf(raw.moves, raw.axes), swept: runsOf(raw.swept, 'radius'), programmed: null, pointing: null,
    length: restore(raw.moves.length, 1000), peak: restore(raw.moves.peak, 10),
    holes: {x: restore(raw.holes.x, 1000), y: restore(raw.holes.y, 1000), bottom: restore(raw.holes.bottom, 1000)},
    speed: {time: restore(raw.speed.time, 1e4), feed: restore(raw.speed.feed, 10), line: restore(raw.speed.line, 1)},
    limits: {}, feedLimits: null,
  };
  [...raw.axes].forEach((axis, i) => { data.limits[axis] = raw.limits.all[i].map((v) => v / 1000); });
  if (raw.limits.feed) {
    data.feedLimits = {};
    [...raw.axes].forEach((axis, i) => { data.feedLimits[axis] = raw.limits.feed[i].map((v) => v / 1000); });
  }
  if (raw.programmed) {
    data.programmed = {...pathOf(raw.programmed, 'XYZ'), plane: restore(raw.programmed.plane, 1)};
  }
  if (raw.pointing) data.pointing = {axis: raw.pointing.axis, ...runsOf(raw.pointing, 'zero')};
  numberMoves(data);
  data.rows = rowsOf(raw, data);
  return data;
}

/** Links actions and moves: move number of each action (-1: none), kind of each move. */
function numberMoves(data) {
  data.moveOf = new Int32Array(data.kinds.length).fill(-1);
  let kinds = '', count = 0;
  for (let i = 0; i < data.kinds.length; ++i) {
    if (!isMove(data.kinds[i])) continue;
    data.moveOf[i] = count++;
    kinds += data.kinds[i];
  }
  data.moveKinds = kinds;
  data.moveCount = count;
}

const kindWords = {r: 'rapid', l: 'line', c: 'arc cw', a: 'arc ccw'};

/** What a block does: its moves by kind with their number, and its other functions, each named once. */
function wordsOf(data, first, count) {
  const times = new Map();
  for (let i = first; i < first + count; ++i) {
    const word = kindWords[data.kinds[i]] || data.notes[i] || '';
    if (word) times.set(word, (times.get(word) || 0) + 1);
  }
  return [...times].map(([word, n]) => n > 1 ? `${word} ×${n}` : word).join(', ');
}

/** One entry a block: source line, text, what, first action and their number, first move, totals. */
function rowsOf(raw, data) {
  const line = restore(raw.rows.line, 1), text = restore(raw.rows.text, 1), count = restore(raw.rows.count, 1);
  const rows = [];
  data.rowOfMove = new Int32Array(data.moveCount);
  for (let r = 0, action = 0; r < line.length; action += count[r], ++r) {
    const row = {index: r, line: line[r], text: data.texts[text[r]], what: wordsOf(data, action, count[r]), kinds: '',
                 action, count: count[r], move: -1, moves: 0, length: 0, time: 0, peak: 0, start: data.start_s[action]};
    for (let i = action; i < action + count[r]; ++i) {
      row.kinds += data.kinds[i];
      row.time += data.duration_s[i];
      const move = data.moveOf[i];
      if (move < 0) continue;
      if (row.move < 0) row.move = move;
      row.moves = move - row.move + 1;
      row.length += data.length[move];
      row.peak = Math.max(row.peak, data.peak[move]);
      data.rowOfMove[move] = r;
    }
    rows.push(row);
  }
  return rows;
}

/** The row that is being executed at a time; -1 before the first. */
function rowAtTime(rows, time) {
  let low = 0, high = rows.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle].start <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
}
