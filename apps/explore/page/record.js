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
    const decimals = Math.min(12, Math.max(0, -Math.floor(Math.log10(step))));
    return Number(value.toFixed(decimals));
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
    return `${where}: ${attractorsInWords(this.attractors(cell))}`;
  }
}

/** "quasi-steady, period 8, ⟨S⟩ = −1.2, of 50 % of the starts; chaotic …". */
function attractorsInWords(attractors) {
  return attractors.map(({ mode, period, spin, share }) =>
    `${mode}${period > 1 ? `, period ${period}` : ""}, ⟨S⟩ = ${shortNumber(spin)}, ` +
    `${Math.round(100 * share)} % of the starts`).join("; ");
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
    this.lines = branches ? this.linesOf(branches, own) : [];
    this.marks = [];
    if (special)
      special.parameter.values.forEach((x, i) => {
        const width = special[own].shape[1] || 1;
        this.marks.push({ x, y: special[own].values[i * width], kind: special.kind.names
          ? special.kind.names[special.kind.values[i]] : special.kind.values[i], period: special.period.values[i] });
      });
  }

  /** One line for each point of each branch's cycles, cut where stability changes. */
  linesOf(branches, own) {
    const width = branches[own].shape[1] || 1, lines = [];
    const { branch, stable, period, parameter } = branches;
    for (let i = 1; i < parameter.values.length; ++i) {
      if (branch.values[i] !== branch.values[i - 1]) continue;
      for (let p = 0; p < Math.min(width, period.values[i]); ++p) {
        const from = branches[own].values[(i - 1) * width + p], to = branches[own].values[i * width + p];
        if (from !== null && to !== null)
          lines.push({ x: [parameter.values[i - 1], parameter.values[i]], y: [from, to],
                       stable: stable.values[i] === 1 && stable.values[i - 1] === 1, period: period.values[i] });
      }
    }
    return lines;
  }

  /** The branch that passes a place within so much of the ordinate: "cycle of period 2, unstable, S = …". */
  branchAt(x, y, within) {
    let found = "", least = within;
    for (const line of this.lines) {
      const [from, to] = line.x;
      if (x < Math.min(from, to) || x > Math.max(from, to)) continue;
      const at = from === to ? line.y[0] : line.y[0] + (x - from) / (to - from) * (line.y[1] - line.y[0]);
      if (!(Math.abs(at - y) <= least)) continue;
      least = Math.abs(at - y);
      found = `cycle of period ${line.period}, ${line.stable ? "stable" : "unstable"}, ` +
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

/** The command that follows the same orbit.
 *   start  {seed, speed, usual}: a random start, `usual` of the program's own speed; or numbers of a start */
function commandOf(scene, start, impacts) {
  const numbers = { alpha: scene.alpha, beta: scene.beta, mu: scene.mu, restitution: scene.restitution };
  const words = [`swirl simulate --sides ${scene.sides === 0 ? "disk" : scene.sides}`];
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
  return `${words.join(" ")} --collisions ${impacts}`;
}
