// The page's scripts without a browser: node --test page_logic_test.js
"use strict";

const assert = require("node:assert/strict");
const { createHash } = require("node:crypto");
const fs = require("node:fs");
const path = require("node:path");
const { test } = require("node:test");
const { FOLDER, scripts } = require("./page.js");

const page = scripts();
const { Evidence, Axis, Sweep, Diagram, IMPACT, SwirlMap } = page;

/** Rows of impacts of which psi is 0, one unit of time apart. */
function rows(spins, psi = () => 0) {
  const numbers = new Float64Array(spins.length * IMPACT.length);
  let angle = 0;
  spins.forEach((spin, i) => {
    angle += i ? spins[i - 1] : 0;
    const row = { t: i, angle, S: spin, psi: psi(i) };
    for (const [name, value] of Object.entries(row)) numbers[i * IMPACT.length + IMPACT.indexOf(name)] = value;
  });
  return numbers;
}

function evidenceOf(...given) {
  const evidence = new Evidence();
  evidence.add(rows(...given));
  return evidence;
}

const repeated = (values, n) => Array.from({ length: n }, (_, i) => values[i % values.length]);

test("a cycle has its period, and RC is one over it", () => {
  for (const period of [1, 2, 3, 7, 64]) {
    const evidence = evidenceOf(repeated(Array.from({ length: period }, (_, k) => k / 10 - 1), 1024));
    assert.equal(evidence.period().period, period);
    assert.ok(Math.abs(evidence.recurrenceRate().rate - 1 / period) < 3e-4, `${period}`);
  }
  assert.equal(evidenceOf(repeated(Array.from({ length: 65 }, (_, k) => k), 1024)).period(), null);
});

test("fewer impacts than three periods, a coordinate that moves or a last step that differs settle nothing", () => {
  assert.equal(evidenceOf(repeated([1, 2], 33)).period(), null);
  assert.equal(evidenceOf(repeated([1, 2], 34)).period().period, 2);
  assert.equal(evidenceOf(repeated([1, 2], 500), (i) => 1e-8 * i).period(), null);
  assert.equal(evidenceOf([...repeated([1, 2], 499), 1 + 2e-9]).period(), null);
});

test("angles recur as angles", () => {
  const evidence = evidenceOf(repeated([1], 100), (i) => (i % 2 ? Math.PI : -Math.PI));
  assert.equal(evidence.period().period, 1);
});

test("the verdict claims no more than was seen", () => {
  const chaos = Array.from({ length: 5000 }, (_, i) => Math.sin(i * i));
  assert.deepEqual(evidenceOf(chaos).verdict("completed"), { mode: "open", words: "no period up to 64 in 5,000 impacts: chaos, " +
    "a closed curve in the section (quasi-steady), or not settled yet; swirl classify tells which" });
  assert.match(evidenceOf(repeated([1], 100)).verdict("completed").words, /^steady: the last 32 impacts recur/);
  assert.match(evidenceOf(repeated([1, 2, 3], 100)).verdict("completed").words, /^quasi-steady, period 3/);
  assert.match(evidenceOf(repeated([1], 100)).verdict("in-contact").words, /no impact for 1000/);
});

test("of few impacts it says that they are few", () => {
  assert.equal(evidenceOf([1, 2, 4]).verdict("completed").words, "too early to say: 3 of 300 impacts");
  assert.equal(evidenceOf([1, 2, 4]).rateInWords(), "recurrence rate RC: shown from 32 impacts on");
  const apart = Array.from({ length: 2000 }, (_, i) => i);
  assert.equal(evidenceOf(apart).rateInWords(), "recurrence rate RC = 0.00100 of the last 1,000 impacts, 1/n: no two have the same S");
  assert.match(evidenceOf(repeated([1, 2], 2000)).rateInWords(), /^recurrence rate RC = 0\.500 of the last 1,000 impacts \(S the same/);
});

test("the mean of a cycle is not that of the way to it", () => {
  const evidence = evidenceOf([...Array.from({ length: 100 }, () => 9), ...repeated([1, 2, 6], 301)]);
  assert.equal(evidence.verdict("completed").period, 3);
  assert.equal(evidence.meanOfLast(3), 3);
  assert.ok(evidence.mean > 4);
});

test("the mean of S is that over time, and history keeps its length", () => {
  const evidence = evidenceOf(repeated([1, 3], 20001));
  assert.equal(evidence.mean, 2);
  assert.ok(evidence.history.length <= 4001 && evidence.history.length > 1000);
  assert.equal(evidence.history[0][0], 0);
});

test("other starts, chaos and special points are said of the record", () => {
  const sweep = Object.assign(Object.create(Sweep.prototype), { modes: ["steady", "chaotic"], sweep: { share: { values: [1, 0, 0.4, 0.6] } } });
  assert.deepEqual([0, 1].map((cell) => [sweep.modeOf(cell), sweep.otherModeOf(cell)]), [["steady", null], ["chaotic", "steady"]]);
  assert.equal(page.attractorsInWords([{ mode: "chaotic", period: 0, spin: -0.03103, share: 1 }]), "chaotic, ⟨S⟩ about −0.03, 100 % of the starts");
  const diagram = Object.assign(Object.create(Diagram.prototype), { axis: { name: "alpha" }, observable: "S",
    marks: [{ x: 0.512271, y: -0.8832, heights: [-0.8832, 0.1], kind: "two-vertices", period: 2 }] });
  assert.equal(diagram.markAt(0.512, 0.1, 0.01, 0.05), "two-vertices of a cycle of period 2, α = 0.512271, S = 0.1");
  assert.equal(diagram.markAt(0.53, 0.1, 0.01, 0.05), "");
});

test("axes: cells, borders, logarithms, words", () => {
  const axis = new Axis("alpha", [0.2, 0.4, 0.6], false);
  assert.deepEqual(axis.edges.map((edge) => Number(edge.toFixed(12))), [0.1, 0.3, 0.5, 0.7]);
  assert.equal(axis.cellAt(0.31), 1);
  assert.equal(axis.valueAt(0.31234567), 0.312);
  const odd = new Axis("beta", [0.1, 1.2 - 1.1 / 19, 1.2], false); // its edges have more digits than a place that is chosen
  for (const place of odd.edges) assert.equal(odd.along(odd.valueAt(place)) >= odd.edges[0] && odd.valueAt(place) <= odd.edges[3], true);
  const falling = new Axis("mu", [0.8, 0.4, 0.1], false);
  assert.deepEqual([0, 0.3, 0.9].map((place) => falling.cellAt(place)), [2, 1, 0]);
  const decades = new Axis("mu", [0.01, 0.1, 1], true);
  assert.equal(decades.cellAt(Math.log(0.2)), 1);
  const laws = new Axis("law", ["poisson", "newton"], false);
  assert.equal(laws.meaning(laws.valueAt(0.9)), "newton");
});

/** A sweep over 2 × 3 cells with two runs each; the middle of the second row has two attractors. */
function sweep() {
  const column = (dimensions, shape, values, names) => ({ dimensions, shape, values, names });
  const grid = ["alpha", "beta"], modes = ["steady", "quasi-steady", "chaotic", "undecided"];
  const run_mode = [0, 0, 0, 0, 2, 2, 1, 1, 1, 2, 2, 2];
  return new Sweep({ settings: { grid: ["alpha=0.2:0.4:2", "beta=0.1:0.3:3"] }, groups: { sweep: {
    alpha: column(["alpha"], [2], [0.2, 0.4]), beta: column(["beta"], [3], [0.1, 0.2, 0.3]), mode: column(["mode"], [4], modes),
    mean_S: column(grid, [2, 3], [0, 0, 0, 0, 0, 0]),
    share: column([...grid, "mode"], [2, 3, 4], [1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0, 0, 1, 0]),
    run_mode: column([...grid, "run"], [2, 3, 2], run_mode, modes),
    run_period: column([...grid, "run"], [2, 3, 2], [1, 1, 1, 1, 0, 0, 8, 8, 8, 0, 0, 0]),
    run_mean_S: column([...grid, "run"], [2, 3, 2], [-1, -1, -1, -1, 0.1, 0.2, -1, -1, -1.25, 0.05, null, 0.1]) } } });
}

test("a sweep's cells, their modes and attractors with shares", () => {
  const map = sweep();
  assert.deepEqual(map.axes.map(({ name }) => name), ["alpha", "beta"]);
  assert.equal(map.cellAt({ alpha: 0.39, beta: 0.12 }), 3);
  assert.equal(map.coordinate(5, map.all[1]), 0.3);
  assert.deepEqual([0, 2, 3].map((cell) => map.modeOf(cell)), ["steady", "chaotic", "quasi-steady"]);
  assert.deepEqual(map.attractors(4).map(({ mode, period, share }) => [mode, period, share]),
                   [["quasi-steady", 8, 0.5], ["chaotic", 0, 0.5]]);
  assert.equal(map.words(3), "α = 0.4, β = 0.1: quasi-steady, period 8, ⟨S⟩ = −1, 2 of 2 starts");
  assert.equal(map.attractors(5)[0].spin, 0.1); // of the run that has a mean
});

test("a diagram's lines are cut where branches end and where stability changes", () => {
  const column = (values, shape = [values.length]) => ({ values, shape });
  const diagram = new Diagram({ settings: { along: "alpha", observable: "S" }, groups: { branches: {
    parameter: column([1, 2, 3, 1, 2]), branch: column([0, 0, 0, 1, 1]), stable: column([1, 1, 0, 0, 0]),
    period: column([1, 1, 1, 2, 2]), S: column([5, null, 6, null, 7, null, 1, 2, 3, 4], [5, 2]) } } });
  assert.deepEqual(diagram.lines.map(({ x, y, stable }) => [...x, ...y, stable]),
                   [[1, 2, 5, 6, true], [2, 3, 6, 7, null], [1, 2, 1, 3, false], [1, 2, 2, 4, false]]);
  assert.equal(diagram.branchAt(1.5, 5.52, 0.1), "cycle of period 1, stable, α = 1.5, S = 5.5");
  assert.equal(diagram.branchAt(1.5, 2.05, 0.1), "cycle of period 2, unstable, α = 1.5, S = 2");
  assert.equal(diagram.branchAt(2.5, 6.5, 0.1), "cycle of period 1, its stability changes near here, α = 2.5, S = 6.5");
  assert.equal(diagram.branchAt(1.5, 4.2, 0.1), "");
});

test("a branch is one line as far as it is as stable, and its lines meet at the special point", () => {
  const column = (values, shape = [values.length]) => ({ values, shape });
  const diagram = new Diagram({ settings: { along: "alpha", observable: "S" }, groups: {
    branches: { parameter: column([1, 2, 3, 4, 5]), branch: column([0, 0, 0, 0, 0]), stable: column([1, 1, 1, 0, 0]),
                period: column([1, 1, 1, 1, 1]), S: column([0, 2, 4, 6, 8], [5, 1]) },
    special: { parameter: column([3.25, 3.3, 3.4, 3.5]), kind: column(["flip", "stick-slip", "fold", "fold"]), period: column([2, 1, 1, 1]),
               S: column([4.5, 4.6, 40, 5], [4, 1]) } } }); // of another period, of no stability, of another branch, and its own
  assert.deepEqual(diagram.lines.map(({ x, y, stable }) => [x, y, stable]),
                   [[[1, 2, 3, 3.5], [0, 2, 4, 5], true], [[3.5, 4, 5], [5, 6, 8], false]]);
  assert.match(diagram.branchAt(3.4, 4.8, 0.01), /, stable, /);
  assert.match(diagram.branchAt(3.6, 5.2, 0.01), /, unstable, /);
});

test("ticks are round, and numbers have their signs", () => {
  assert.deepEqual(page.ticksBetween(-0.31, 0.52, 5).map(({ text }) => text), ["−0.2", "0", "0.2", "0.4"]);
  assert.equal(page.shortNumber(-1.23456), "−1.235");
  assert.equal(page.shortNumber(1518000), "1.518×10⁶");
  assert.equal(page.shortNumber(null), "–");
  assert.deepEqual(page.rangeOf([2, 2]).map((value) => value.toFixed(3)), ["1.998", "2.002"]);
});

test("the command has what is not the program's own choice", () => {
  const scene = { sides: 0, law: "newton", alpha: 0.4, beta: 0.5, mu: 0.5, restitution: 0.9, inertia_factor: 0.5, uniform: true };
  assert.equal(page.commandOf(scene, { seed: 3, usual: true }, 7), "swirl simulate --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 " +
    "--restitution 0.9 --law newton --seed 3 --collisions 7");
  assert.match(page.commandOf({ ...scene, law: "poisson", uniform: false }, { x: 0.1, vx: -0.5 }, 1),
               /--inertia-factor 0\.5 --x=0\.1 --vx=-0\.5 --collisions 1$/);
  assert.match(page.commandOf(scene, { seed: 3, usual: true }), /^swirl classify .* --seed 3$/);
  assert.match(page.commandOf(scene, { seed: 3, usual: true }, 4352512), / --collisions 4352512 --every 4353$/);
});

const shipped = page.bytesOfBase64(fs.readFileSync(path.join(FOLDER, "swirl_map.wasm.base64"), "ascii"));

test("the artefact has its checksum", () => {
  const [sum] = fs.readFileSync(path.join(FOLDER, "swirl_map.sha256"), "ascii").split(" ");
  assert.equal(createHash("sha256").update(shipped).digest("hex"), sum);
});

test("a disk without friction keeps its spin, and its energy at e = 1", async () => {
  const map = await SwirlMap.from(shipped);
  const scene = { sides: 0, law: "poisson", alpha: 0.4, beta: 0.5, mu: 0, restitution: 1, inertia_factor: 0.5 };
  assert.ok(map.setScene(scene, []));
  assert.ok(map.start({ x: 0.5, y: 0, vx: 0.3, vy: 0.2, angle: 0, spin: 0.7 }));
  const found = map.run(1000), n = IMPACT.length, at = (name) => IMPACT.indexOf(name);
  assert.equal(found.length, 1000 * n);
  // J = E − L of the swirling frame, with the wall's part: conserved (map/README.md, "Energy in the swirling frame").
  const energies = [];
  for (let i = 0; i < found.length; i += n) {
    const [t, x, y, vx, vy, spin] = ["t", "x", "y", "vx", "vy", "S"].map((name) => found[i + at(name)]);
    assert.equal(spin, 0.7);
    assert.ok(Math.abs(Math.hypot(x - 0.5 * Math.cos(t), y - 0.5 * Math.sin(t)) - 0.6) < 1e-12);
    energies.push((vx * vx + vy * vy) / 2 - (x * vy - y * vx));
  }
  for (const energy of energies) assert.ok(Math.abs(energy - energies[0]) < 1e-11);
});

test("what is out of range is refused, and an orbit that ends says how", async () => {
  const map = await SwirlMap.from(shipped);
  const scene = { sides: 0, law: "poisson", alpha: 0.4, beta: 0, mu: 0.5, restitution: 0.9, inertia_factor: 0.5 };
  for (const wrong of [{ alpha: 0 }, { alpha: 1 }, { beta: -1 }, { restitution: 1.1 }, { mu: NaN }, { law: "none" }, { sides: 2 }])
    assert.equal(map.setScene({ ...scene, ...wrong }, []), false, JSON.stringify(wrong));
  assert.ok(map.setScene(scene, []));
  assert.equal(map.start({ x: 0.61, y: 0, vx: 0, vy: 0, angle: 0, spin: 0 }), false);
  assert.equal(map.start({ x: NaN, y: 0, vx: 0, vy: 0, angle: 0, spin: 0 }), false);
  assert.ok(map.start({ x: 0, y: 0, vx: 0, vy: 0, angle: 0, spin: 0 }));
  assert.equal(map.run(5).length, 0);
  assert.equal(map.outcome(), "no-contact");
});
