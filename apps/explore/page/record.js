// What the page holds of its records: axes, cells, diagrams. Needs nothing of a browser.

const NAMES = {
  alpha: ["α", "α = R_p/R_c  (size of the body)"],
  beta: ["β", "β = r_s/R_c  (radius of the swirl)"],
  mu: ["μ", "μ  (friction)"],
  restitution: ["e", "e  (restitution)"],
  inertia_factor: ["κ", "κ = I/(m R_p²)  (inertia)"],
  sides: ["N", "N  (number of sides)"],
  law: ["law", "impact law"],
  speed: ["V", "V  (speed of the starts, in R_c ω_s)"],
  x: ["x", "x/R_c  (centre at the start)"],
  y: ["y", "y/R_c  (centre at the start)"],
  vx: ["v_x", "v_x/(R_c ω_s)  (velocity at the start)"],
  vy: ["v_y", "v_y/(R_c ω_s)  (velocity at the start)"],
  angle: ["angle", "angle at the start, in radians"],
  spin: ["S", "S at the start"],
};
const SECTION_LABELS = Object.fromEntries(Object.entries({ S: "S = ω_p/ω_s", psi: "ψ", chi: "χ", vn: "v_n/(R_c ω_s)",
  vt: "v_t/(R_c ω_s)" }).map(([name, label]) => [name, `${label}, just after each impact`]));
const OF_SCENE = ["sides", "law", "alpha", "beta", "mu", "restitution", "inertia_factor"];
const OF_START = ["x", "y", "vx", "vy", "angle", "spin", "speed"];
/** What the words of the legend mean, for who points at one; the page's list of words has the same. */
const MEANINGS = {
  steady: "the same impact recurs: a fixed point of the section, S is one value",
  "quasi-steady": "impacts recur after more than one (a cycle of that period), or fill a closed curve",
  chaotic: "no impact recurs, and neighbouring orbits part exponentially (positive exponent)",
  undecided: "not settled within the impacts that the program followed",
  fold: "a cycle and an unstable one meet here, and there is neither beyond",
  flip: "a cycle loses its stability to one of twice the period (multiplier −1)",
  "neimark-sacker": "a cycle loses its stability to a closed curve (a pair of multipliers on the unit circle)",
  grazing: "the cycle touches the wall on its way, and ends here",
  "two-vertices": "two vertices strike at once, and the cycle ends here",
  "stick-slip": "an impact of the cycle changes from sticking to sliding",
};
const WORDS_OF_MODES = ["steady", "quasi-steady", "chaotic", "undecided"];
const MODE_COLOURS = { steady: "#00406B", "quasi-steady": "#F0E442", chaotic: "#D55E00", undecided: "#BDBDBD" };

function symbolOf(name) {
  return (NAMES[name] || [name])[0];
}

function labelOf(name) {
  return (NAMES[name] || [name, name])[1];
}

/** With proper signs, and powers of ten of what is long. */
function inWords(value) {
  const minus = (text) => text.replace("-", "−"), size = Math.abs(value);
  if (value === 0 || (size < 1e5 && size >= 1e-4)) return minus(String(value));
  const [digits, power] = value.toExponential().split("e");
  const raised = [...String(Number(power))].map((letter) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[letter] || "⁻").join("");
  return `${minus(digits)}×10${raised}`;
}

/** To four digits. */
function shortNumber(value) {
  return value === null || !Number.isFinite(value) ? "–" : inWords(Number(value.toPrecision(4)));
}

class Axis {
  constructor(name, values, logarithmic) {
    this.name = name;
    this.words = values.some((value) => typeof value === "string") ? values.map(String) : null;
    this.values = this.words ? values.map((_, i) => i) : values;
    this.logarithmic = logarithmic && !this.words;
    this.whole = name === "sides" && !this.words;
    const places = this.values.map((value) => this.along(value));
    this.order = places.map((_, i) => i).sort((a, b) => places[a] - places[b]);
    const rising = this.order.map((i) => places[i]);
    // Borders of cells: half-way between, and as far beyond the ends.
    const n = rising.length;
    this.edges = [];
    for (let k = 0; k <= n; ++k) {
      if (n === 1) this.edges.push(rising[0] + (k - 0.5));
      else if (k === 0) this.edges.push(1.5 * rising[0] - 0.5 * rising[1]);
      else if (k === n) this.edges.push(1.5 * rising[n - 1] - 0.5 * rising[n - 2]);
      else this.edges.push(0.5 * (rising[k - 1] + rising[k]));
    }
  }

  /** Where a value lies along the axis: its logarithm of a logarithmic one. */
  along(value) {
    return this.logarithmic ? Math.log(value) : value;
  }

  /** The value at a place, with no more digits than a point of a screen tells. */
  valueAt(place) {
    if (this.words || this.whole) return this.values[this.cellAt(place)];
    const value = this.logarithmic ? Math.exp(place) : place;
    const step = this.logarithmic ? value / 300 : (this.edges[this.edges.length - 1] - this.edges[0]) / 300;
    const decimals = Math.min(12, Math.max(0, -Math.floor(Math.log10(step)))), unit = 10 ** -decimals;
    const rounded = Number(value.toFixed(decimals)), at = this.along(rounded);
    if (at < this.edges[0]) return Number((rounded + unit).toFixed(decimals)); // the edge itself, rounded outwards
    return at > this.edges[this.edges.length - 1] ? Number((rounded - unit).toFixed(decimals)) : rounded;
  }

  /** The number of the cell, in the record's order. */
  cellAt(place) {
    let k = 0;
    while (k < this.values.length - 1 && place > this.edges[k + 1]) ++k;
    return this.order[k];
  }

  text(value) {
    return this.words ? this.words[value] : shortNumber(value);
  }

  /** What the scene or the start has of a value of this axis. */
  meaning(value) {
    return this.words ? this.words[value] : value;
  }
}

function values(group, name) {
  return group && group[name] ? group[name].values : null;
}

/** The grid of a sweep, or its points: [axes], cells with their verdicts. */
class Sweep {
  constructor(record) {
    const sweep = record.groups.sweep;
    this.sweep = sweep;
    const logs = [].concat(record.settings.grid || []).filter((text) => String(text).endsWith(":log"))
      .map((text) => text.split("=")[0].replace("-", "_"));
    const dimensions = sweep.mean_S.dimensions;
    this.isGrid = !(dimensions.length === 1 && dimensions[0] === "cell");
    const names = this.isGrid ? dimensions : Object.keys(NAMES).filter((name) => sweep[name]);
    this.all = names.map((name) => {
      const column = sweep[name].values;
      const own = this.isGrid ? column : [...new Set(column)].sort((a, b) => (a < b ? -1 : 1));
      return new Axis(name, own, logs.includes(name));
    });
    this.shape = sweep.mean_S.shape;
    this.cells = sweep.mean_S.values.length;
    this.modes = sweep.mode ? sweep.mode.values : sweep.run_mode.names;
    this.runs = sweep.run_mode.values.length / this.cells;
    const varied = this.all.filter((axis) => axis.values.length > 1);
    this.axes = (varied.length ? varied : this.all.slice(0, 1)).slice(0, 2);
    this.others = this.all.filter((axis) => !this.axes.includes(axis));
    this.at = Object.fromEntries(this.others.map((axis) => [axis.name, axis.order[axis.order.length >> 1]]));
  }

  /** The mode with the largest share. */
  modeOf(cell) {
    const share = this.sweep.share.values, count = this.modes.length;
    let best = 0;
    for (let m = 1; m < count; ++m) if (share[cell * count + m] > share[cell * count + best]) best = m;
    return this.modes[best];
  }

  /** The mode with the next largest share; none where all starts came to one. */
  otherModeOf(cell) {
    const first = this.modeOf(cell), share = this.sweep.share.values, count = this.modes.length;
    let best = null, most = 0;
    this.modes.forEach((mode, m) => {
      if (mode !== first && share[cell * count + m] > most) [best, most] = [mode, share[cell * count + m]];
    });
    return best;
  }

  /** A parameter's value in a cell, as along its axis. */
  coordinate(cell, axis) {
    if (!this.isGrid) {
      const own = this.sweep[axis.name].values[cell];
      return axis.words ? axis.words.indexOf(String(own)) : own;
    }
    let rest = cell;
    for (let d = this.all.length - 1; d >= 0; --d) {
      const place = rest % this.shape[d];
      if (this.all[d] === axis) return axis.values[place];
      rest = Math.floor(rest / this.shape[d]);
    }
    return NaN;
  }

  /** The cell of a place {axis name: place along it}: of points the nearest. */
  cellAt(place) {
    if (this.isGrid)
      return this.all.reduce((cell, axis, d) => cell * this.shape[d] +
        (axis.name in place ? axis.cellAt(place[axis.name]) : this.at[axis.name]), 0);
    let best = 0, least = Infinity;
    for (let cell = 0; cell < this.cells; ++cell) {
      let apart = 0;
      for (const axis of this.axes) {
        const span = axis.edges[axis.edges.length - 1] - axis.edges[0];
        apart += ((axis.along(this.coordinate(cell, axis)) - place[axis.name]) / span) ** 2;
      }
      if (apart < least) [best, least] = [cell, apart];
    }
    return best;
  }

  /** Cells that are drawn: of a grid those at the chosen values of the other parameters. */
  shown() {
    const cells = [];
    for (let cell = 0; cell < this.cells; ++cell)
      if (!this.isGrid || this.others.every((axis) => this.coordinate(cell, axis) === axis.values[this.at[axis.name]]))
        cells.push(cell);
    return cells;
  }

  /** What the runs of a cell came to: [{mode, period, spin, share}], the largest first. */
  attractors(cell) {
    const found = new Map();
    for (let r = cell * this.runs; r < (cell + 1) * this.runs; ++r) {
      const mode = this.sweep.run_mode.names[this.sweep.run_mode.values[r]];
      const period = this.sweep.run_period.values[r], spin = this.sweep.run_mean_S.values[r];
      const key = mode === "chaotic" || mode === "undecided" ? mode
        : `${mode} ${period} ${spin === null ? "" : spin.toPrecision(3)}`;
      const entry = found.get(key) || { mode, period, sum: 0, count: 0, means: 0 };
      if (spin !== null) [entry.sum, entry.means] = [entry.sum + spin, entry.means + 1];
      ++entry.count;
      found.set(key, entry);
    }
    return [...found.values()].sort((a, b) => b.count - a.count).map(({ mode, period, sum, count, means }) =>
      ({ mode, period, spin: means ? sum / means : null, share: count / this.runs }));
  }

  wasRun(cell) {
    return !this.sweep.visited || this.sweep.visited.values[cell] === 1;
  }

  words(cell) {
    const where = this.all.filter((axis) => axis.values.length > 1)
      .map((axis) => `${symbolOf(axis.name)} = ${axis.text(this.coordinate(cell, axis))}`).join(", ");
    if (!this.wasRun(cell)) return `${where}: not run; ${this.modeOf(cell)} as its neighbour`;
    return `${where}: ${attractorsInWords(this.attractors(cell), this.runs)}`;
  }
}

/** "quasi-steady, period 8, ⟨S⟩ = −1.2, 50 % of the starts; chaotic …".
 *   starts  how many there were, where that is known: of few their number says more than a share */
function attractorsInWords(attractors, starts = Infinity) {
  const ofStarts = (share) => (starts < 20 ? `${Math.round(share * starts)} of ${starts} start${starts === 1 ? "" : "s"}`
    : `${Math.round(100 * share)} % of the starts`);
  return attractors.map(({ mode, period, spin, share }) =>
    `${mode}${period > 1 ? `, period ${period}` : ""}, ${meanInWords(mode, spin)}, ${ofStarts(share)}`).join("; ");
}

/** Of chaos a finite run tells ⟨S⟩ to some hundredths. */
function meanInWords(mode, spin) {
  return mode === "chaotic" && spin !== null ? `⟨S⟩ about ${inWords(Number(spin.toFixed(2)))}` : `⟨S⟩ = ${shortNumber(spin)}`;
}

const LOSES_STABILITY = ["fold", "flip", "neimark-sacker"];
const ALIKE = 0.5; // of a step of a branch: a special point lies on the branch between its two cycles

/** The ordinate at x of the straight line between two points; of the second where both lie above one another. */
function heightAt(from, to, x) {
  return from[0] === to[0] ? to[1] : from[1] + (x - from[0]) / (to[0] - from[0]) * (to[1] - from[1]);
}

/** A diagram over one parameter: {axis, dots: [x, S, mode or null], lines, marks}. */
class Diagram {
  constructor(record) {
    const { samples, columns, branches, special, shares } = record.groups;
    const name = String(record.settings.along).replace("-", "_");
    this.observable = record.settings.observable || "S";
    const own = this.observable === "S" ? "S" : "value";
    const all = [values(columns, "parameter"), values(branches, "parameter")].find((column) => column && column.length);
    this.axis = new Axis(name, [...new Set(all || [0])].sort((a, b) => a - b), false);
    this.shares = shares;
    this.columns = columns;
    this.every = samples && samples.every ? samples.every : 1;
    this.dots = [];
    if (samples) {
      const at = values(samples, "column"), spins = values(samples, own);
      for (let i = 0; i < at.length; ++i) this.dots.push([columns.parameter.values[at[i]], spins[i]]);
    }
    this.marks = [];
    if (special)
      special.parameter.values.forEach((x, i) => {
        const width = special[own].shape[1] || 1;
        const heights = special[own].values.slice(i * width, (i + 1) * width).filter((y) => y !== null); // of the cycle's points
        this.marks.push({ x, y: heights[0], heights, kind: special.kind.names
          ? special.kind.names[special.kind.values[i]] : special.kind.values[i], period: special.period.values[i] });
      });
    this.lines = branches ? this.linesOf(branches, own) : [];
  }

  /** {x, y, stable, period}: for each point of each branch's cycles a line as far as it is as stable. Where stability
   * changes between two cycles of the record, both lines end at the special point between them; where the record has none
   * there, `stable` of the piece is null. */
  linesOf(branches, own) {
    const width = branches[own].shape[1] || 1, lines = [];
    const { branch, stable, period, parameter } = branches;
    const spin = (i, p) => branches[own].values[i * width + p];
    for (let p = 0; p < width; ++p) {
      let line = null;
      const add = (from, to, isStable, cycle) => {
        if (!line || line.stable !== isStable || line.period !== cycle) {
          line = { x: [from[0]], y: [from[1]], stable: isStable, period: cycle };
          lines.push(line);
        }
        line.x.push(to[0]);
        line.y.push(to[1]);
      };
      for (let i = 1; i < parameter.values.length; ++i) {
        const cycle = period.values[i], [from, to] = [i - 1, i].map((k) => [parameter.values[k], spin(k, p)]);
        if (branch.values[i] !== branch.values[i - 1] || p >= cycle || from[1] === null || to[1] === null) {
          line = null;
          continue;
        }
        const [before, after] = [i - 1, i].map((k) => stable.values[k] === 1);
        const there = before === after ? null : this.changeBetween(from, to, cycle);
        if (there) {
          add(from, there, before, cycle);
          add(there, to, after, cycle);
        } else add(from, to, before === after ? before : null, cycle);
      }
    }
    return lines;
  }

  /** Where on the piece between two points of a branch the cycle's stability changes; null if the record has no such point. */
  changeBetween(from, to, period) {
    const near = ALIKE * (Math.abs(to[1] - from[1]) + LEAST_SPAN * Math.max(1, Math.abs(to[1])));
    const found = this.marks.find(({ x, heights, kind, period: its }) => LOSES_STABILITY.includes(kind) && its === period &&
      (x - from[0]) * (x - to[0]) <= 0 && heights.some((height) => Math.abs(height - heightAt(from, to, x)) <= near));
    return found ? [found.x, heightAt(from, to, found.x)] : null;
  }

  /** The special point nearest to a place: "two-vertices, period 2, α = …, S = …". */
  markAt(x, y, withinX, withinY) {
    let found = "", least = 1;
    for (const mark of this.marks)
      for (const height of mark.heights) {
        const apart = Math.hypot((mark.x - x) / withinX, (height - y) / withinY);
        if (!(apart <= least)) continue;
        least = apart;
        found = `${mark.kind} of a cycle of period ${mark.period}, ${symbolOf(this.axis.name)} = ${inWords(Number(mark.x.toPrecision(8)))}, ` +
          `${this.observable} = ${shortNumber(height)}`;
      }
    return found;
  }

  /** The branch that passes a place within so much of the ordinate: "cycle of period 2, unstable, S = …". */
  branchAt(x, y, within) {
    let found = "", least = within;
    for (const line of this.lines)
      for (let k = 1; k < line.x.length; ++k) {
        const [from, to] = [k - 1, k].map((end) => [line.x[end], line.y[end]]);
        if (x < Math.min(from[0], to[0]) || x > Math.max(from[0], to[0])) continue;
        const at = heightAt(from, to, x);
        if (!(Math.abs(at - y) <= least)) continue;
        least = Math.abs(at - y);
        const stability = line.stable === null ? "its stability changes near here" : line.stable ? "stable" : "unstable";
        found = `cycle of period ${line.period}, ${stability}, ` +
          `${symbolOf(this.axis.name)} = ${shortNumber(x)}, ${this.observable} = ${shortNumber(at)}`;
      }
    return found;
  }

  /** What orbits came to at the nearest value; nothing of a record of branches alone. */
  words(place) {
    if (!this.shares || !this.columns) return "";
    const column = this.axis.cellAt(this.axis.along(place)), x = this.axis.values[column];
    const where = `${symbolOf(this.axis.name)} = ${this.axis.text(x)}`;
    const { mode, period, mean_S, share } = this.shares, rows = [];
    this.shares.column.values.forEach((of, i) => {
      if (this.columns.parameter.values[of] !== x) return;
      rows.push({ mode: mode.names ? mode.names[mode.values[i]] : mode.values[i], period: period.values[i],
                  spin: mean_S.values[i], share: share.values[i] });
    });
    return rows.length ? `${where}: ${attractorsInWords(rows)}` : where;
  }
}

/** Curves in the plane of two parameters: {axes: names, lines: [{kind, period, first, second}]}. */
function curvesOf(record) {
  const { curves, curve_ends: ends } = record.groups;
  const kindOf = (i) => (ends.kind.names ? ends.kind.names[ends.kind.values[i]] : ends.kind.values[i]);
  const lines = ends.period.values.map((period, i) => ({ kind: kindOf(i), period, first: [], second: [] }));
  curves.curve.values.forEach((number, i) => {
    lines[number].first.push(curves.first.values[i]);
    lines[number].second.push(curves.second.values[i]);
  });
  const { first, second } = record.settings;
  return { axes: [first, second].map((name) => String(name).replace("-", "_")), lines,
           limits: [[record.settings.first_low, record.settings.first_high],
                    [record.settings.second_low, record.settings.second_high]] };
}

const ROWS = 1000; // that a command prints, of a longer orbit

/** The command that follows the same orbit; of no number of impacts the one that judges it.
 *   start  {seed, speed, usual}: a random start, `usual` of the program's own speed; or numbers of a start */
function commandOf(scene, start, impacts = null) {
  const numbers = { alpha: scene.alpha, beta: scene.beta, mu: scene.mu, restitution: scene.restitution };
  const words = [`swirl ${impacts === null ? "classify" : "simulate"} --sides ${scene.sides === 0 ? "disk" : scene.sides}`];
  for (const [name, value] of Object.entries(numbers)) words.push(`--${name} ${value}`);
  if (scene.law !== "poisson") words.push(`--law ${scene.law}`);
  if (!scene.uniform) words.push(`--inertia-factor ${scene.inertia_factor}`);
  if (start.seed !== undefined) {
    words.push(`--seed ${start.seed}`);
    if (!start.usual) words.push(`--speed ${start.speed}`);
  } else {
    for (const name of ["x", "y", "vx", "vy", "angle", "spin"])
      if (name in start) words.push(`--${name}=${start[name]}`);
  }
  if (impacts !== null) words.push(`--collisions ${impacts}`);
  if (impacts > 10 * ROWS) words.push(`--every ${Math.ceil(impacts / ROWS)}`);
  return words.join(" ");
}
