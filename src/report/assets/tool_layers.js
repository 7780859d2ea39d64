// What tool radius compensation and normal line control do, in the views that look at their plane.

const sweptOpacity = 0.3;

const looksAt = (view, plane) => [view.h + view.v, view.v + view.h].includes(planeNames[plane]);

/** The layers with something to show in a view, from below: name, draw(context, box) and whether above the moves. */
function toolLayersOf(view) {
  const {swept, programmed, pointing} = view.data;
  const seen = (planes) => planes.some((plane) => looksAt(view, plane));
  const layers = [];
  if (seen(swept.plane)) layers.push(new SweptLayer(view));
  if (programmed && seen(programmed.plane)) layers.push(new ProgrammedLayer(view));
  if (pointing && seen(pointing.plane)) layers.push(new PointingLayer(view));
  return layers;
}

/** A band as wide as the tool along its path: drawn opaque on a sheet of its own, so that it is one even surface
    however often it overlaps. */
class SweptLayer {
  constructor(view) {
    this.name = 'swept';
    this.view = view;
    this.sheet = document.createElement('canvas').getContext('2d');
  }

  draw(context, box) {
    const {view, sheet} = this, {canvas} = context;
    if (sheet.canvas.width !== canvas.width) sheet.canvas.width = canvas.width;
    if (sheet.canvas.height !== canvas.height) sheet.canvas.height = canvas.height;
    sheet.setTransform(1, 0, 0, 1, 0, 0);
    sheet.clearRect(0, 0, canvas.width, canvas.height);
    sheet.setTransform(context.getTransform());
    sheet.lineJoin = sheet.lineCap = 'round';
    sheet.strokeStyle = palette.swept;
    this.drawRuns(box);
    context.globalAlpha = sweptOpacity;
    context.drawImage(sheet.canvas, 0, 0, view.picture.width, view.picture.height);
    context.globalAlpha = 1;
  }

  drawRuns(box) {
    const {view} = this, {move, count, radius, plane} = view.data.swept;
    let pen = null, last = NaN;
    for (let run = 0; run < move.length; ++run) {
      if (!looksAt(view, plane[run])) continue;
      if (radius[run] !== last) {
        if (pen) pen.finish();
        last = radius[run];
        pen = this.pen(last);
      }
      const reach = {left: box.left - last, right: box.right + last, bottom: box.bottom - last, top: box.top + last};
      for (let i = move[run]; i < move[run] + count[run]; ++i) {
        if (view.moves.touches(i, reach)) view.moves.trace(pen, i, 4000);
      }
    }
    if (pen) pen.finish();
  }

  pen(radius) {
    const {view, sheet} = this, width = 2 * radius * view.scale;
    return new Pen(sheet, {
      // A hundredth of the width off the middle of a wide band is not seen.
      closest: Math.max(0.6, 0.01 * width),
      pieces: true,
      stroke: () => {  // as high as wide in mm, though the view may be stretched
        sheet.save();
        sheet.scale(1, view.stretch);
        sheet.lineWidth = width;
        sheet.stroke();
        sheet.restore();
      },
    });
  }
}

/** The programmed path of the moves that compensation leads beside it. */
class ProgrammedLayer {
  constructor(view) {
    this.name = 'programmed';
    this.path = new PathOnView(view, view.data.programmed);
    this.view = view;
  }

  draw(context, box) {
    const {path, view} = this, {plane, count} = path.path;
    setStroke(context, 'programmed');
    const pen = new Pen(context);
    for (let move = 0; move < count; ++move) {
      if (looksAt(view, plane[move]) && path.touches(move, box)) path.trace(pen, move, 4000);
    }
    pen.finish();
    context.setLineDash([]);
  }
}
