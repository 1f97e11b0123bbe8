// The record's figure: a mode map, a diagram over one parameter, or curves, and the place that is chosen on it.

const CURVE_COLOURS = { fold: "#222222", flip: "#882255", "neimark-sacker": "#009E73", grazing: "#332288",
                        "two-vertices": "#7A5C00", "stick-slip": "#CC79A7" };
const DASHES = [[], [6, 3], [6, 2, 1, 2]]; // of periods 1, 2, 3; longer ones are dotted

class RecordFigure {
  /** choose({parameter: value}) is called with what a click, a drag or a key chooses. */
  constructor(canvas, data, choose) {
    this.figure = new Figure(canvas);
    this.choose = choose;
    const [first] = data.records;
    this.kind = first.kind;
    this.sweep = first.kind === "map" ? new Sweep(first) : null;
    this.diagram = first.kind === "diagram" ? new Diagram(first) : null;
    this.curves = data.records.filter((record) => record.kind === "curves").map(curvesOf);
    this.axes = this.axesOf();
    this.place = {};
    this.ground = document.createElement("canvas"); // all but the chosen place
    this.stale = true;
    this.listen(canvas);
  }

  /** One or two axes of parameters. */
  axesOf() {
    if (this.sweep) return this.sweep.axes;
    if (this.diagram) return [this.diagram.axis];
    const { axes, limits } = this.curves[0];
    return axes.map((name, i) => new Axis(name, Array.from({ length: 41 }, (_, k) =>
      limits[i][0] + k / 40 * (limits[i][1] - limits[i][0])), false));
  }

  /** What the ordinate is where there is one parameter alone. */
  get ordinate() {
    if (this.sweep) return "⟨S⟩ of each start";
    return SECTION_LABELS[this.diagram.observable] || this.diagram.observable;
  }

  resize() {
    this.figure.fit();
    this.stale = true;
    this.draw();
  }

  setPlace(place) {
    this.place = place;
    this.draw();
  }

  ticksOf(axis) {
    if (!axis) return undefined;
    if (axis.words) return axis.words.map((text, at) => ({ at, text }));
    if (axis.logarithmic) return decadesBetween(axis.edges[0], axis.edges[axis.edges.length - 1]);
    return undefined;
  }

  draw() {
    const { figure } = this;
    if (figure.width === 0) return;
    if (this.stale) {
      this.drawGround();
      [this.ground.width, this.ground.height] = [figure.canvas.width, figure.canvas.height];
      this.ground.getContext("2d").drawImage(figure.canvas, 0, 0);
      this.stale = false;
    } else {
      figure.pen.drawImage(this.ground, 0, 0, figure.width, figure.height);
    }
    const [x, y] = this.axes.map((axis) => axis.along(this.place[axis.name]));
    figure.clipped((pen) => {
      if (y !== undefined) return figure.cross(x, y);
      pen.fillStyle = OWN;
      pen.fillRect(figure.toX(x) - 1, 0, 2, figure.height);
    });
  }

  drawGround() {
    const { figure, axes } = this;
    const ends = (axis) => [axis.edges[0], axis.edges[axis.edges.length - 1]];
    figure.clear();
    if (axes.length === 2) {
      figure.setRange(ends(axes[0]), ends(axes[1]));
      figure.clipped((pen) => this.drawPlane(pen));
    } else {
      const spins = this.diagram ? [...this.diagram.dots.map(([, y]) => y), ...this.diagram.lines.flatMap(({ y }) => y)]
        : this.sweep.sweep.run_mean_S.values.filter((value) => value !== null);
      figure.setRange(ends(axes[0]), rangeOfMost(spins));
      figure.clipped(() => (this.diagram ? this.drawDiagram() : this.drawMeans()));
    }
    figure.axes({ x: labelOf(axes[0].name), y: axes.length === 2 ? labelOf(axes[1].name) : this.ordinate },
                { x: this.ticksOf(axes[0]), y: this.ticksOf(axes[1]) });
  }

  drawPlane(pen) {
    const { figure, axes, sweep } = this;
    if (sweep && sweep.isGrid) {
      const place = (axis, cell) => axis.order.indexOf(axis.values.indexOf(sweep.coordinate(cell, axis)));
      for (const cell of sweep.shown()) {
        const [i, j] = axes.map((axis) => place(axis, cell));
        const [left, right] = [figure.toX(axes[0].edges[i]), figure.toX(axes[0].edges[i + 1])].map(Math.round);
        const [low, high] = [figure.toY(axes[1].edges[j]), figure.toY(axes[1].edges[j + 1])].map(Math.round);
        pen.fillStyle = MODE_COLOURS[sweep.modeOf(cell)];
        pen.fillRect(left, high, right - left, low - high);
        const other = sweep.otherModeOf(cell);
        if (other) this.drawCorner(pen, [left, right, low, high], MODE_COLOURS[other]);
      }
    } else if (sweep) {
      for (const cell of sweep.shown())
        figure.dots([axes.map((axis) => axis.along(sweep.coordinate(cell, axis)))], MODE_COLOURS[sweep.modeOf(cell)], 6);
    }
    for (const { axes: names, lines } of this.curves)
      for (const { kind, period, first, second } of lines) {
        const points = first.map((value, i) => axes.map((axis) =>
          axis.along(axis.name === names[0] ? value : second[i])));
        const dash = DASHES[period - 1] || [1, 3];
        figure.line(points, "#ffffff", 3.5);
        figure.line(points, CURVE_COLOURS[kind] || PALE, 1.8, dash);
      }
  }

  /** The mode of other starts, in a cell's upper right corner. */
  drawCorner(pen, [left, right, low, high], colour) {
    const size = 0.5 * Math.min(right - left, low - high);
    pen.fillStyle = colour;
    pen.beginPath();
    pen.moveTo(right - size, high);
    pen.lineTo(right, high);
    pen.lineTo(right, high + size);
    pen.fill();
  }

  drawDiagram() {
    const { figure, diagram } = this;
    figure.dots(diagram.dots, "rgba(34, 34, 34, 0.45)", diagram.dots.length > 20000 ? 1 : diagram.dots.length > 2000 ? 1.6 : 3);
    for (const { x, y, stable } of diagram.lines)
      figure.line(x.map((value, i) => [value, y[i]]), OWN, stable ? 1.8 : 1, stable ? [] : [4, 3]);
    for (const { x, y, kind } of diagram.marks) {
      figure.dots([[x, y]], "#ffffff", 9);
      figure.dots([[x, y]], CURVE_COLOURS[kind] || "#D55E00", 7);
    }
  }

  drawMeans() {
    const { figure, axes, sweep } = this;
    for (const cell of sweep.shown())
      for (let r = 0; r < sweep.runs; ++r) {
        const spin = sweep.sweep.run_mean_S.values[cell * sweep.runs + r];
        const mode = sweep.sweep.run_mode.names[sweep.sweep.run_mode.values[cell * sweep.runs + r]];
        if (spin === null) continue;
        const place = [axes[0].along(sweep.coordinate(cell, axes[0])), spin];
        figure.dots([place], "#555555", 7);
        figure.dots([place], MODE_COLOURS[mode], 5);
      }
  }

  /** [{colour, text, word}]: `word` is what MEANINGS explains. */
  legend() {
    const found = [];
    if (this.sweep) {
      const there = new Set(this.sweep.sweep.run_mode.values.map((value) => this.sweep.sweep.run_mode.names[value]));
      for (const [mode, colour] of Object.entries(MODE_COLOURS)) if (there.has(mode)) found.push({ colour, text: mode, word: mode });
      if (this.sweep.isGrid && this.axes.length === 2 && this.sweep.shown().some((cell) => this.sweep.otherModeOf(cell)))
        found.push({ colour: "linear-gradient(to bottom left, #777 50%, #fff 50%)", text: "a corner: other starts differ" });
    }
    for (const kind of new Set(this.curves.flatMap(({ lines }) => lines.map((line) => line.kind))))
      found.push({ colour: CURVE_COLOURS[kind] || PALE, text: `${kind} of cycles`, word: kind });
    if (this.diagram) {
      const { every, dots, lines, marks } = this.diagram;
      if (dots.length) found.push({ colour: "#777777", text: every > 1 ? `impacts, one in ${every}` : "impacts" });
      if (lines.length) found.push({ colour: OWN, text: "cycles: stable thick, unstable dashed" });
      for (const kind of new Set(marks.map((mark) => mark.kind))) found.push({ colour: CURVE_COLOURS[kind] || "#D55E00", text: kind, word: kind });
    }
    return found;
  }

  /** What the record says at a place. */
  words(place) {
    if (this.diagram) return this.diagram.words(place[this.axes[0].name]);
    if (!this.sweep) return "";
    const along = Object.fromEntries(this.axes.map((axis) => [axis.name, axis.along(place[axis.name])]));
    return this.sweep.words(this.sweep.cellAt(along));
  }

  /** Of a diagram the cycle beneath the mouse, in words. */
  branchAt(event) {
    if (!this.diagram) return "";
    const { x, y } = this.figure.placeOf(event), [low, high] = this.figure.y, [left, right] = this.figure.x;
    return this.diagram.markAt(x, y, 0.01 * (right - left), 0.015 * (high - low)) || this.diagram.branchAt(x, y, 0.015 * (high - low));
  }

  /** The middle of the cell that an event points at; of a record that is no grid the place itself. */
  cellAt(event) {
    if (!this.sweep || !this.sweep.isGrid) return this.valuesAt(event);
    const { x, y } = this.figure.placeOf(event);
    return Object.fromEntries(this.axes.map((axis, i) => [axis.name, axis.values[axis.cellAt(i === 0 ? x : y)]]));
  }

  valuesAt(event) {
    const { x, y } = this.figure.placeOf(event);
    return Object.fromEntries(this.axes.map((axis, i) => [axis.name, axis.valueAt(i === 0 ? x : y)]));
  }

  /** A click takes a cell of a grid, a drag the places on its way. A finger that scrolls takes nothing: what it points at is
   * taken as it is lifted, or as it moves sideways. */
  listen(canvas) {
    let from = null, dragging = false; // of the press
    const moved = (event) => [Math.abs(event.clientX - from.clientX), Math.abs(event.clientY - from.clientY)];
    const isDrag = (event) => {
      const [across, along] = moved(event);
      return event.pointerType === "touch" ? across > 8 && across > along : Math.hypot(across, along) > 4;
    };
    const scrolls = (event) => event.pointerType === "touch" && moved(event)[1] > 8;
    canvas.addEventListener("pointerdown", (event) => {
      if (!this.figure.isWithin(event)) return;
      [from, dragging] = [event, false];
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType !== "touch") this.choose(this.cellAt(event));
    });
    canvas.addEventListener("pointermove", (event) => {
      if (from && !dragging) dragging = isDrag(event);
      if (from && !dragging && scrolls(event)) from = null;
      if (dragging) this.choose(this.valuesAt(event));
      else if (!from) this.onHover(this.valuesAt(event), this.branchAt(event));
    });
    canvas.addEventListener("pointerup", (event) => {
      if (from && !dragging && event.pointerType === "touch") this.choose(this.cellAt(event));
      [from, dragging] = [null, false];
    });
    canvas.addEventListener("pointercancel", () => { [from, dragging] = [null, false]; });
    canvas.addEventListener("pointerleave", () => this.onHover(null));
    canvas.addEventListener("keydown", (event) => {
      const moves = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1] };
      const move = moves[event.key];
      if (!move || !this.axes[move[0]]) return;
      event.preventDefault();
      this.choose(this.neighbour(...move));
    });
  }

  /** The middle of the next cell along an axis; of a sampled record a fortieth of its range. */
  neighbour(number, by) {
    const axis = this.axes[number], here = axis.along(this.place[axis.name]);
    const rising = axis.order.map((i) => axis.along(axis.values[i]));
    const beyond = by > 0 ? rising.filter((value) => value > here + 1e-12) : rising.filter((value) => value < here - 1e-12);
    const next = beyond.length ? (by > 0 ? beyond[0] : beyond[beyond.length - 1]) : here;
    const value = axis.values[axis.order[rising.indexOf(next)]];
    return { ...this.place, [axis.name]: beyond.length ? value : this.place[axis.name] };
  }

  onHover() {}
}
