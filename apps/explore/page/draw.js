// Figures on canvases: axes, dots, lines. What is drawn is handed over; nothing here knows of records or orbits.

const INK = "#222222", PALE = "#6b6b6b", GRID = "#e4e4e4", OWN = "#0072B2";
const FONT = "12px system-ui, sans-serif";

/** Round numbers between two, about `count`. */
function ticksBetween(low, high, count) {
  const rough = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough * 0.999);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push({ at: k * step, text: inWords(Number((k * step).toPrecision(12))) });
  return ticks;
}

/** Powers of ten (of one decade also 2 and 5) between two logarithms. */
function decadesBetween(low, high) {
  const ticks = [], factors = high - low > 5 ? [1] : [1, 2, 5];
  for (let power = Math.floor(low / Math.LN10); power <= high / Math.LN10; ++power)
    for (const factor of factors) {
      const value = factor * 10 ** power;
      if (Math.log(value) >= low && Math.log(value) <= high) ticks.push({ at: Math.log(value), text: shortNumber(value) });
    }
  return ticks;
}

class Figure {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.margin = { left: 66, right: 14, top: 8, bottom: 40 };
    this.fit();
  }

  /** As many pixels as the screen has. True if that changed. */
  fit() {
    const ratio = window.devicePixelRatio || 1, { clientWidth: width, clientHeight: height } = this.canvas;
    const changed = this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio);
    if (changed) [this.canvas.width, this.canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    [this.width, this.height] = [width, height];
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    return changed;
  }

  clear() {
    this.pen.fillStyle = "#ffffff";
    this.pen.fillRect(0, 0, this.width, this.height);
    this.pen.font = FONT;
  }

  /** The margin holds the ordinate's numbers and its label. */
  setRange(x, y) {
    [this.x, this.y] = [x, y];
    const widest = Math.max(0, ...this.ticksUp().map(({ text }) => this.pen.measureText(text).width));
    this.margin.left = Math.max(66, Math.ceil(widest) + 30);
  }

  ticksUp() {
    return ticksBetween(...this.y, (this.height - this.margin.top - this.margin.bottom) / 44);
  }

  /** With equal scales and without axes: a picture of the plane. */
  setSquare(reach) {
    const size = Math.min(this.width, this.height) / 2;
    this.margin = { left: this.width / 2 - size, right: this.width / 2 - size, top: this.height / 2 - size,
                    bottom: this.height / 2 - size };
    this.x = this.y = [-reach, reach];
  }

  toX(value) {
    const { left, right } = this.margin;
    return left + (value - this.x[0]) / (this.x[1] - this.x[0]) * (this.width - left - right);
  }

  toY(value) {
    const { top, bottom } = this.margin;
    return this.height - bottom - (value - this.y[0]) / (this.y[1] - this.y[0]) * (this.height - top - bottom);
  }

  /** Does an event point into the frame? */
  isWithin(event) {
    const box = this.canvas.getBoundingClientRect(), { left, right, top, bottom } = this.margin;
    const x = event.clientX - box.left, y = event.clientY - box.top;
    return x >= left && x <= this.width - right && y >= top && y <= this.height - bottom;
  }

  /** The place that an event points at, held within the figure. */
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect(), { left, right, top, bottom } = this.margin;
    const hold = (value) => Math.min(1, Math.max(0, value));
    const x = hold((event.clientX - box.left - left) / (this.width - left - right));
    const y = hold(1 - (event.clientY - box.top - top) / (this.height - top - bottom));
    return { x: this.x[0] + x * (this.x[1] - this.x[0]), y: this.y[0] + y * (this.y[1] - this.y[0]) };
  }

  clipped(draw) {
    const { left, right, top, bottom } = this.margin, pen = this.pen;
    pen.save();
    pen.beginPath();
    pen.rect(left, top, this.width - left - right, this.height - top - bottom);
    pen.clip();
    draw(pen);
    pen.restore();
  }

  /** The frame, ticks and labels; `ticks` of an axis are worked out where there are none. */
  axes(labels, ticks = {}, grid = false) {
    const { left, right, top, bottom } = this.margin, pen = this.pen;
    const across = this.width - left - right, up = this.height - top - bottom;
    const xs = ticks.x || ticksBetween(...this.x, across / 80), ys = ticks.y || this.ticksUp();
    pen.lineWidth = 1;
    if (grid) {
      pen.strokeStyle = GRID;
      pen.beginPath();
      for (const { at } of ys) pen.rect(left, Math.round(this.toY(at)) + 0.5, across, 0);
      pen.stroke();
    }
    pen.strokeStyle = PALE;
    pen.strokeRect(left + 0.5, top + 0.5, across - 1, up - 1);
    pen.fillStyle = INK;
    pen.textAlign = "center";
    pen.textBaseline = "top";
    for (const { at, text } of xs) {
      pen.fillRect(Math.round(this.toX(at)), this.height - bottom, 1, 4);
      const half = pen.measureText(text).width / 2; // of one at the edge, moved inwards
      pen.fillText(text, Math.min(this.toX(at), this.width - half), this.height - bottom + 6);
    }
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const { at, text } of ys) {
      pen.fillRect(left - 4, Math.round(this.toY(at)), 4, 1);
      pen.fillText(text, left - 7, this.toY(at));
    }
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    pen.fillText(labels.x, left + across / 2, this.height - 6);
    pen.save();
    pen.translate(13, top + up / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(labels.y, 0, 0);
    pen.restore();
  }

  dots(points, colour, size) {
    this.pen.fillStyle = colour;
    for (const [x, y] of points) this.pen.fillRect(this.toX(x) - size / 2, this.toY(y) - size / 2, size, size);
  }

  line(points, colour, width, dash = []) {
    const pen = this.pen;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.setLineDash(dash);
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(this.toX(x), this.toY(y)) : pen.moveTo(this.toX(x), this.toY(y))));
    pen.stroke();
    pen.setLineDash([]);
  }

  circle(x, y, radius, colour, width, fill) {
    const pen = this.pen, across = Math.abs(this.toX(radius) - this.toX(0));
    pen.beginPath();
    pen.arc(this.toX(x), this.toY(y), across, 0, 2 * Math.PI);
    if (fill) {
      pen.fillStyle = fill;
      pen.fill();
    }
    if (!width) return;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  /** The head of an arrow that runs counter-clockwise along a circle. */
  head([x, y], radius, angle, colour) {
    const pen = this.pen, size = 7;
    const [a, b] = [this.toX(x + radius * Math.cos(angle)), this.toY(y + radius * Math.sin(angle))];
    const [along, across] = [[-Math.sin(angle), -Math.cos(angle)], [Math.cos(angle), -Math.sin(angle)]]; // of the screen
    pen.fillStyle = colour;
    pen.beginPath();
    pen.moveTo(a + size * along[0], b + size * along[1]);
    for (const side of [1, -1]) pen.lineTo(a + side * size * across[0] / 2, b + side * size * across[1] / 2);
    pen.fill();
  }

  polygon(points, colour, width, fill) {
    const pen = this.pen;
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(this.toX(x), this.toY(y)) : pen.moveTo(this.toX(x), this.toY(y))));
    pen.closePath();
    pen.fillStyle = fill;
    pen.fill();
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  /** Where the page's own scene is. */
  cross(x, y) {
    const pen = this.pen, [a, b] = [this.toX(x), this.toY(y)];
    for (const [colour, width] of [["#ffffff", 5], ["#000000", 2]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = width;
      pen.beginPath();
      pen.arc(a, b, 7, 0, 2 * Math.PI);
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        pen.moveTo(a + 7 * dx, b + 7 * dy);
        pen.lineTo(a + 13 * dx, b + 13 * dy);
      }
      pen.stroke();
    }
  }
}

const LEAST_SPAN = 2e-3; // of an axis: below it is rounding

/** The range of numbers, with a little room; of none 0 to 1. */
function rangeOf(numbers, share = 0.04) {
  let low = Infinity, high = -Infinity;
  for (const value of numbers)
    if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (low > high) return [0, 1];
  const least = LEAST_SPAN * Math.max(1, Math.abs(low)), more = Math.max(0, least - (high - low)) / 2;
  const room = share * (high - low) + more;
  return [low - room, high + room];
}

/** The range of nearly all numbers: a hundredth at either end may lie outside, where that halves it. */
function rangeOfMost(numbers) {
  const sorted = numbers.filter(Number.isFinite).sort((a, b) => a - b), n = sorted.length;
  if (n < 200) return rangeOf(sorted);
  const whole = rangeOf([sorted[0], sorted[n - 1]]), most = rangeOf([sorted[Math.floor(n / 100)], sorted[Math.ceil(0.99 * n) - 1]]);
  return most[1] - most[0] < 0.5 * (whole[1] - whole[0]) ? most : whole;
}
