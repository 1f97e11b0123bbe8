// The orbit that runs in the page: it is followed by the map, drawn in the dish, and weighed.

const FRAME_BUDGET = 9; // milliseconds of a frame for the map, at the pace "as fast as it goes"
const TRAIL = 90; // moments of the centre's way

class LiveOrbit {
  constructor(map) {
    this.map = map;
    this.ok = false;
  }

  /** scene: with `directions` of its vertices; start: numbers of one in the laboratory. False if they are out of range. */
  begin(scene, start) {
    this.scene = scene;
    this.evidence = new Evidence();
    this.outcome = "completed";
    this.time = 0; // of the picture
    this.trail = [];
    this.ok = this.map.setScene(scene, scene.directions) && this.map.start(start);
    this.way = new Float64Array([0, start.x, start.y, start.angle, start.spin, 0]);
    this.ended = !this.ok;
    return this.ok;
  }

  /** Makes impacts and keeps the way to the last. */
  impacts(count) {
    if (this.ended) return 0;
    const rows = this.map.run(count);
    this.evidence.add(rows);
    const made = rows.length / IMPACT.length;
    const way = this.map.way();
    if (way.length) this.way = Float64Array.from(way);
    if (made < count) {
      this.ended = true;
      this.outcome = this.map.outcome();
    }
    return made;
  }

  get wayEnds() {
    return this.way[this.way.length - 6];
  }

  /** Goes on by a time of the swirl: the body is seen on its way from impact to impact. Impacts of one call are limited,
   * since a body may hop without end. */
  advanceTime(by) {
    const until = this.time + by;
    let made = 0;
    for (let calls = 0; !this.ended && this.wayEnds < until && calls < 500; ++calls) {
      this.keepTrail(this.wayEnds);
      made += this.impacts(1);
    }
    this.time = Math.min(until, this.wayEnds);
    this.keepTrail(this.time);
    return made;
  }

  /** As many impacts as take so many milliseconds. */
  rush(milliseconds) {
    const begin = performance.now();
    let made = 0;
    do made += this.impacts(256);
    while (!this.ended && performance.now() - begin < milliseconds);
    this.showLast();
    return made;
  }

  /** So many impacts at once. */
  ahead(count) {
    for (let made = 0; made < count && !this.ended; made += 256) this.impacts(Math.min(256, count - made));
    this.showLast();
  }

  /** The picture's moment is the last impact; the centre's way there was too long to be drawn. */
  showLast() {
    this.time = this.wayEnds;
    this.trail = [];
    this.keepTrail(this.time);
  }

  keepTrail(time) {
    const { x, y } = this.momentAt(time), last = this.trail[this.trail.length - 1];
    if (!last || time > last[0]) this.trail.push([time, x, y]);
    if (this.trail.length > TRAIL) this.trail.splice(0, this.trail.length - TRAIL);
  }

  /** {x, y, angle, spin, contact} at a time within the way to the last impact. */
  momentAt(time) {
    const { way } = this;
    let i = 0;
    while (i + 12 < way.length && way[i + 6] < time) i += 6;
    const j = Math.min(i + 6, way.length - 6), lasts = way[j] - way[i];
    const share = lasts > 0 ? Math.min(1, Math.max(0, (time - way[i]) / lasts)) : 1;
    const at = (column) => way[i + column] + share * (way[j + column] - way[i + column]);
    return { x: at(1), y: at(2), angle: at(3), spin: way[i + 4], contact: way[i + 5] === 1 };
  }
}

/** A place of the laboratory in the chosen frame at a time. */
function inFrame(frame, beta, time, x, y) {
  if (frame === "container") return [x - beta * Math.cos(time), y - beta * Math.sin(time)];
  if (frame === "laboratory") return [x, y];
  const c = Math.cos(time), s = Math.sin(time);
  return [c * x + s * y, c * y - s * x];
}

function drawDish(figure, orbit, frame) {
  const { scene, time } = orbit, { beta } = scene;
  figure.setSquare((frame === "container" ? 1 : 1 + beta) * 1.07);
  figure.clear();
  const centre = inFrame(frame, beta, time, beta * Math.cos(time), beta * Math.sin(time));
  figure.circle(...centre, 1, INK, 2, "#f6f6f6");
  if (frame === "laboratory") {
    figure.circle(0, 0, beta, "#b0b0b0", 1); // the way of the dish's centre, and its sense
    const ahead = 20 / Math.max(1, figure.toX(beta) - figure.toX(0)); // so many pixels
    if (ahead < 2) figure.head([0, 0], beta, time + ahead, "#888888");
  }
  const toSwirl = frame === "co-rotating" ? 0 : time; // ψ = 0
  const outside = (reach, turn) => [centre[0] + reach * Math.cos(toSwirl + turn), centre[1] + reach * Math.sin(toSwirl + turn)];
  figure.polygon([outside(1.01, 0), outside(1.06, 0.03), outside(1.06, -0.03)], "#D55E00", 1, "#D55E00");
  figure.dots([centre], "#888888", 4);
  figure.line(orbit.trail.map(([t, x, y]) => inFrame(frame, beta, t, x, y)), "rgba(0, 114, 178, 0.55)", 1.3);
  const { x, y, angle } = orbit.momentAt(time);
  const turned = angle - (frame === "co-rotating" ? time : 0), [cx, cy] = inFrame(frame, beta, time, x, y);
  const corner = (k) => [cx + scene.alpha * Math.cos(turned + k), cy + scene.alpha * Math.sin(turned + k)];
  if (scene.sides === 0) figure.circle(cx, cy, scene.alpha, INK, 1.5, "#d7e7f2");
  else figure.polygon(Array.from({ length: scene.sides }, (_, k) => corner(2 * Math.PI * k / scene.sides)), INK, 1.5, "#d7e7f2");
  figure.line([[cx, cy], corner(0)], OWN, 1.5);
}

function drawSpin(figure, evidence) {
  figure.clear();
  const history = evidence.history;
  const from = history.length ? history[0][0] : 0, to = history.length > 1 ? history[history.length - 1][0] : from + 1;
  figure.setRange([from, to], rangeOf(history.map(([, spin]) => spin)));
  figure.clipped((pen) => {
    pen.strokeStyle = OWN;
    pen.lineWidth = history.length > 600 ? 0.5 : 1.2;
    pen.beginPath();
    history.forEach(([t, spin], i) => {
      const x = figure.toX(t), y = figure.toY(spin);
      if (i === 0) pen.moveTo(x, y);
      else if (evidence.stride === 1 && history.length < 600) {
        pen.lineTo(x, figure.toY(history[i - 1][1])); // S is constant in flight
        pen.lineTo(x, y);
      } else pen.lineTo(x, y);
    });
    pen.stroke();
    figure.line(history.slice(1).map(([t, , mean]) => [t, mean]), "#ffffff", 4);
    figure.line(history.slice(1).map(([t, , mean]) => [t, mean]), INK, 1.8);
  });
  figure.axes({ x: "ω_s t", y: "S = ω_p/ω_s" }, {}, true);
}

function drawSection(figure, evidence) {
  figure.clear();
  const points = [];
  for (let back = evidence.kept() - 1; back >= 0; --back) points.push([evidence.coordinate(back, 0), evidence.coordinate(back, 4)]);
  figure.setRange([-Math.PI, Math.PI], rangeOf(points.map(([, spin]) => spin), 0.08));
  const few = points.length < 200 || (evidence.period() !== null);
  figure.clipped(() => figure.dots(points, few ? OWN : "rgba(0, 114, 178, 0.6)", few ? 4 : 2));
  figure.axes({ x: "ψ", y: "S" },
              { x: [["−π", -Math.PI], ["−π/2", -Math.PI / 2], ["0", 0], ["π/2", Math.PI / 2], ["π", Math.PI]]
                .map(([text, at]) => ({ at, text })) });
}
