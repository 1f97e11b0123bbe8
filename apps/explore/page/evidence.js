// What the page says of an orbit that it follows. Needs nothing of a browser.
//
// It says less than the program: that the section's point recurs after so many impacts, or that it is not settled. Chaos
// is never claimed, since no number of impacts shows it.

const RECURS_WITHIN = 1e-9; // in each coordinate of the section
const LONGEST_PERIOD = 64;
const RC_WITHIN = 1e-6; // of S, as the program's classify
const RC_IMPACTS = 1000;
const KEPT = 4096; // impacts, of which the section shows the last
const MOST_OF_HISTORY = 4000; // points of S(t) and of its mean

const COORDINATES = ["psi", "chi", "vn", "vt", "S"]; // of the section
const COLUMNS = [...COORDINATES, "t", "angle"]; // of an impact that is kept
const TOO_FEW = 300; // impacts: a transient of fewer is usual
const FEWEST_OF_RATE = 32; // impacts: RC of fewer is near 1/n whatever the orbit
const AT = Object.fromEntries(IMPACT.map((name, place) => [name, place]));

function turnBetween(a, b) {
  const turn = Math.abs(a - b) % (2 * Math.PI);
  return Math.min(turn, 2 * Math.PI - turn);
}

class Evidence {
  constructor() {
    this.count = 0; // impacts
    this.rows = new Float64Array(KEPT * COLUMNS.length);
    this.history = []; // [t, S until then, mean of S by time until then]
    this.stride = 1;
    this.first = null; // t and angle at the first impact
    this.mean = NaN;
    this.time = 0;
  }

  /** Rows of SwirlMap.run. */
  add(rows) {
    for (let i = 0; i < rows.length; i += IMPACT.length) {
      const place = (this.count % KEPT) * COLUMNS.length;
      for (let c = 0; c < COLUMNS.length; ++c) this.rows[place + c] = rows[i + AT[COLUMNS[c]]];
      const t = rows[i + AT.t], angle = rows[i + AT.angle];
      if (this.first === null) this.first = { t, angle };
      else if (t > this.first.t) this.mean = (angle - this.first.angle) / (t - this.first.t);
      this.time = t;
      if (this.count % this.stride === 0) this.history.push([t, rows[i + AT.S], this.mean]);
      if (this.history.length > MOST_OF_HISTORY) {
        this.history = this.history.filter((_, k) => k % 2 === 0);
        this.stride *= 2;
      }
      ++this.count;
    }
  }

  kept() {
    return Math.min(this.count, KEPT);
  }

  /** Column c of the impact that is `back` before the last. */
  coordinate(back, c) {
    return this.rows[((this.count - 1 - back) % KEPT) * COLUMNS.length + c];
  }

  /** The mean of S by time over the last so many impacts. */
  meanOfLast(impacts) {
    const [t, angle] = [COLUMNS.indexOf("t"), COLUMNS.indexOf("angle")];
    return (this.coordinate(0, angle) - this.coordinate(impacts, angle)) / (this.coordinate(0, t) - this.coordinate(impacts, t));
  }

  /** Do the impacts `a` and `b` before the last have the same point of the section? */
  recurs(a, b) {
    for (let c = 0; c < COORDINATES.length; ++c) {
      const one = this.coordinate(a, c), other = this.coordinate(b, c);
      const apart = c < 2 ? turnBetween(one, other) : Math.abs(one - other);
      if (!(apart <= RECURS_WITHIN)) return false;
    }
    return true;
  }

  /** {period, impacts}: the smallest period with which so many last impacts recur; null if there is none. */
  period() {
    for (let period = 1; period <= LONGEST_PERIOD; ++period) {
      const impacts = Math.max(3 * period, 32);
      if (this.kept() < impacts + period) return null;
      let back = 0;
      while (back < impacts && this.recurs(back, back + period)) ++back;
      if (back === impacts) return { period, impacts };
    }
    return null;
  }

  /** RC = (1/n²) Σ [|S_i − S_j| ≤ δ] over the last n impacts, diagonal included. */
  recurrenceRate() {
    const n = Math.min(this.kept(), RC_IMPACTS);
    if (n === 0) return { rate: NaN, n };
    const spins = new Float64Array(n);
    for (let i = 0; i < n; ++i) spins[i] = this.coordinate(i, 4);
    spins.sort();
    let pairs = 0;
    for (let i = 0, low = 0; i < n; ++i) {
      while (spins[i] - spins[low] > RC_WITHIN) ++low;
      pairs += 2 * (i - low) + 1;
    }
    return { rate: pairs / (n * n), n };
  }

  /** "RC = 0.125 of the last 1,000 impacts". */
  rateInWords() {
    const { rate, n } = this.recurrenceRate();
    if (n < FEWEST_OF_RATE) return `recurrence rate RC: shown from ${FEWEST_OF_RATE} impacts on`;
    const alone = Math.round(rate * n * n) === n ? ", 1/n: no two have the same S" : "";
    return `recurrence rate RC = ${rate.toPrecision(3)} of the last ${n.toLocaleString("en")} impacts` +
      `${alone || " (S the same to 1e−6)"}`;
  }

  /** {mode, words, period}: mode is steady, quasi-steady, ended or open.
   *   outcome  of the orbit, as SwirlMap says it */
  verdict(outcome) {
    const impacts = `${this.count.toLocaleString("en")} impact${this.count === 1 ? "" : "s"}`;
    const endings = {
      "in-contact": "stays on the wall: no impact for 1000/ω_s",
      "contact-cut-short": "on the wall when it was given up",
      "no-contact": "never meets the wall again",
      resting: "comes to rest",
      diverged: "faster than numbers hold",
      unresolved: "could not be followed further",
    };
    if (outcome !== "completed") return { mode: "ended", words: `${endings[outcome]}, after ${impacts}` };
    const found = this.period();
    if (found === null)
      return { mode: "open", words: this.count < TOO_FEW
        ? `too early to say: ${this.count} of ${TOO_FEW} impacts`
        : `no period up to ${LONGEST_PERIOD} in ${impacts}: chaos, a closed curve in the section (quasi-steady), or not settled yet; ` +
          "swirl classify tells which" };
    const name = found.period === 1 ? "steady" : `quasi-steady, period ${found.period}`;
    return { mode: found.period === 1 ? "steady" : "quasi-steady", period: found.period,
             words: `${name}: the last ${found.impacts} impacts recur to 1e−9` };
  }
}
