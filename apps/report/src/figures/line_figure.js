// What figures of lines and marks have in common. A line is { points: [{ left, top }], … } in pixels of the canvas.

// Draws through points { x, y }; not finite ones are gaps. Leaves their pixels in them.
export function drawLine(plot, context, points) {
  context.beginPath();
  let isDown = false;
  for (const point of points) {
    point.left = plot.left(point.x);
    point.top = plot.top(point.y);
    if (!Number.isFinite(point.left) || !Number.isFinite(point.top)) isDown = false;
    else if (isDown) context.lineTo(point.left, point.top);
    else {
      context.moveTo(point.left, point.top);
      isDown = true;
    }
  }
  context.stroke();
}

// Between the axes and nothing beyond.
export function clipTo(plot, context) {
  const { left, top, width, height } = plot.box;
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
}

const outlines = {
  triangle: (context, size) => {
    context.moveTo(0, -1.15 * size);
    context.lineTo(size, 0.75 * size);
    context.lineTo(-size, 0.75 * size);
    context.closePath();
  },
  arrowhead: (context, size) => {
    context.moveTo(0, 1.15 * size);
    context.lineTo(size, -0.75 * size);
    context.lineTo(-size, -0.75 * size);
    context.closePath();
  },
  diamond: (context, size) => {
    context.moveTo(0, 1.15 * size);
    context.lineTo(size, 0);
    context.lineTo(0, -1.15 * size);
    context.lineTo(-size, 0);
    context.closePath();
  },
  square: (context, size) => context.rect(-0.85 * size, -0.85 * size, 1.7 * size, 1.7 * size),
  circle: (context, size) => context.arc(0, 0, size, 0, 2 * Math.PI),
};

// A filled mark with an edge in the colour of the page.
export function drawMark(plot, context, outline, { left, top }, { colour, edge, size = 5 }) {
  context.save();
  context.translate(left, top);
  context.beginPath();
  outlines[outline](context, size * plot.ratio);
  context.fillStyle = colour;
  context.strokeStyle = edge;
  context.lineWidth = 1.5 * plot.ratio;
  context.stroke();
  context.fill();
  context.restore();
}

// Pixels of the page, within the axes, from those of the canvas.
export function onPage(plot, { left, top }) {
  return { left: (left - plot.box.left) / plot.ratio, top: (top - plot.box.top) / plot.ratio };
}

// The nearest of these drawn points, within `reach` pixels of the page; null if there is none.
export function findNearest(plot, points, left, top, reach) {
  let nearest = null;
  let least = reach ** 2;
  for (const point of points) {
    if (!Number.isFinite(point.left) || !Number.isFinite(point.top)) continue;
    const place = onPage(plot, point);
    const distance = (place.left - left) ** 2 + (place.top - top) ** 2;
    if (distance < least) [nearest, least] = [{ point, ...place }, distance];
  }
  return nearest;
}
