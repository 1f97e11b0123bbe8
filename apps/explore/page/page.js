// The page: its state, what the reader does to it, and the frames in which it is drawn.

const PACES = ["1", "5", "25", "100", "0"];
const SCENE_NUMBERS = { alpha: [0.02, 0.98], beta: [0, 2], mu: [0, 2], restitution: [0, 1] }; // of the sliders
const ALLOWED = { alpha: [1e-3, 0.999], beta: [0, 1e3], mu: [0, 1e3], restitution: [0, 1] };
const CALLED = { alpha: "size", beta: "swirl", mu: "friction", restitution: "restitution" };
const AHEAD = 10000; // impacts

class Page {
  constructor(data, map) {
    this.data = data;
    this.orbit = new LiveOrbit(map);
    this.running = false;
    this.scenes = this.scenesOfRecord();
    this.state = { ...this.scenes, start: 0, pace: "5" };
    this.figure = new RecordFigure(byId("figure"), data, (chosen) => this.change(chosen));
    this.figure.onHover = (place, branch) => this.showCell(place, branch);
    this.panels = { dish: new Figure(byId("dish")), section: new Figure(byId("section")), spin: new Figure(byId("spin")) };
    for (const axis of this.figure.axes) this.state[axis.name] = axis.values[axis.order[axis.order.length >> 1]];
    this.describe();
    this.buildControls();
    this.first = { ...this.state };
    this.readHash();
    this.listen();
    this.begin();
  }

  /** What the first record has of the scene, its numbers where it does not vary them. */
  scenesOfRecord() {
    const [{ scene, settings }] = this.data.records, found = {};
    const usual = { sides: 6, law: "poisson", alpha: 0.5, beta: 0.5, mu: 0.5, restitution: 0.9 };
    for (const name of [...OF_SCENE, ...OF_START]) {
      const value = name in scene ? scene[name] : settings[name];
      if (typeof value === "number" || typeof value === "string") found[name] = value;
    }
    return { ...usual, ...found };
  }

  /** The value of a parameter now: on an axis, of the other parameters of a grid, or of the scene. */
  valueOf(name) {
    const axis = this.axisOf(name);
    return axis ? axis.meaning(this.state[name]) : this.state[name];
  }

  axisOf(name) {
    const all = this.figure.sweep ? this.figure.sweep.all : this.figure.axes;
    return all.find((axis) => axis.name === name && (name in this.state));
  }

  sceneNow() {
    const word = String(this.valueOf("sides")), sides = word === "disk" ? 0 : Number(word);
    const body = this.data.bodies[word];
    const given = Number(this.valueOf("inertia_factor"));
    const uniform = !(given > 0) || given === body.inertia_factor;
    return { sides, law: this.valueOf("law"), alpha: Number(this.valueOf("alpha")), beta: Number(this.valueOf("beta")),
             mu: Number(this.valueOf("mu")), restitution: Number(this.valueOf("restitution")),
             inertia_factor: uniform ? body.inertia_factor : given, uniform, directions: body.directions };
  }

  /** Is the start given by numbers, as in a map of basins? */
  startIsGiven() {
    return OF_START.some((name) => name !== "speed" && name in this.state);
  }

  startNow(scene) {
    const number = (name, otherwise) => (name in this.state ? Number(this.valueOf(name)) : otherwise);
    if (this.startIsGiven())
      return { x: number("x", scene.beta), y: number("y", 0), vx: number("vx", 0), vy: number("vy", 0),
               angle: number("angle", 0), spin: number("spin", 0) };
    const speed = number("speed", this.data.speed), [cosine, sine, angle] = this.data.starts[this.state.start];
    return { x: scene.beta, y: 0, vx: speed * cosine, vy: speed * sine, angle, spin: 0 };
  }

  /** The orbit from its start, by the state. */
  begin() {
    const scene = this.sceneNow();
    const start = this.startNow(scene);
    this.startAsFlags = this.startIsGiven() ? start : {
      seed: this.data.seed + this.state.start, speed: Number(this.valueOf("speed") || this.data.speed),
      usual: Math.abs(Number(this.valueOf("speed") || this.data.speed) - 1 / 7) < 1e-15 };
    this.scene = scene;
    if (!this.orbit.begin(scene, start)) this.orbit.outcome = "completed";
    this.figure.setPlace(this.state);
    this.showCell(null);
    this.showScene();
    [byId("held").textContent, this.notice] = [this.notice || "", ""];
    this.writeHash();
    this.dirty = true;
  }

  change(chosen) {
    for (const [name, value] of Object.entries(chosen))
      this.state[name] = name in ALLOWED && !(this.axisOf(name) || {}).words ? this.held(name, value) : value;
    this.begin();
  }

  // What is shown.

  describe() {
    const [first] = this.data.records, { record } = first;
    const kinds = { map: "Modes across parameters", diagram: record.command === "continue" ? "Branches over one parameter"
      : "Attractors over one parameter", curves: "Bifurcation curves" };
    const body = this.scenes.sides === "disk" ? "a disk" : `a polygon of ${this.scenes.sides} sides`;
    document.title = `${kinds[first.kind]} · Swirl`;
    byId("title").textContent = `${kinds[first.kind]}: ${this.axisOf("sides") ? "bodies" : body} in a swirled dish`;
    byId("program").textContent = `swirl ${record.command} ${record.swirl_version}`;
    const files = this.data.records.map((one) => `${one.file} (swirl ${one.record.command} ${one.record.swirl_version})`);
    byId("origin").textContent = `${files.join(", ")}; page made by swirl explore ${this.data.swirl_version}`;
    const names = this.figure.axes.map((axis) => symbolOf(axis.name)).join(" and ");
    byId("figure").setAttribute("aria-label", `${kinds[first.kind]}, over ${names}. Arrows choose the scene.`);
    byId("figure-keys").textContent = (first.kind === "map" ? "A click takes a cell's scene, a drag any."
      : "A click or a drag takes any scene on the figure.") + ` With the figure in focus arrows go ${first.kind === "map"
      ? "from cell to cell" : first.kind === "diagram" ? "to the record's own values" : "in steps"}.`;
    const { sides, law, inertia_factor: kappa, speed } = this.scenes;
    byId("fixed").textContent = [this.axisOf("sides") ? "" : sides === "disk" ? "a disk" : `${sides} sides`,
      this.axisOf("law") ? "" : `law: ${law}`, kappa > 0 ? `κ = ${shortNumber(Number(kappa))}` : "",
      this.startIsGiven() ? "" : `starts at ${shortNumber(Number(speed || this.data.speed))} R_c ω_s`].filter(Boolean).join(", ") +
      ": as in the record. Lengths in R_c, times in 1/ω_s.";
    const listed = new Set();
    const list = (word) => {
      if (!MEANINGS[word] || listed.has(word)) return;
      listed.add(word);
      const [name, meaning] = ["dt", "dd"].map((kind) => document.createElement(kind));
      [name.textContent, meaning.textContent] = [word, MEANINGS[word]];
      byId("word-list").append(name, meaning);
    };
    WORDS_OF_MODES.forEach(list);
    for (const { colour, text, word } of this.figure.legend()) {
      const item = document.createElement("li"), patch = document.createElement("span");
      patch.style.background = colour;
      item.append(patch, text);
      byId("legend").append(item);
      if (!MEANINGS[word]) continue;
      item.title = MEANINGS[word];
      list(word);
    }
  }

  /** Of the place beneath the mouse, or of that nearest to the scene: never of a scene that the record does not have. */
  showCell(place, branch = "") {
    const words = place ? [branch, this.figure.words(place)].filter(Boolean).join("; ") : this.nearestInRecord();
    byId("cell").textContent = words ? `${place ? "Here" : "Nearest in the record"}: ${words}` : "";
    if (!place) byId("recorded").replaceChildren(...(words ? [tag("the record"), ` ${words}`] : []));
  }

  nearestInRecord() {
    const beyond = this.figure.axes.filter((axis) => {
      const place = axis.along(this.state[axis.name]);
      return place < axis.edges[0] || place > axis.edges[axis.edges.length - 1];
    });
    if (beyond.length > 1) return `none: ${beyond.map(({ name }) => symbolOf(name)).join(" and ")} are outside their ranges`;
    if (beyond.length) return `none: ${symbolOf(beyond[0].name)} is outside its range`;
    const words = this.figure.words(this.state);
    const drawn = Object.fromEntries((this.figure.sweep ? this.figure.sweep.others : [])
      .map((axis) => [axis.name, axis.values[this.figure.sweep.at[axis.name]]]));
    const ofRecord = { ...this.scenes, ...drawn }, shown = this.figure.axes.map(({ name }) => name);
    const others = Object.keys(SCENE_NUMBERS).filter((name) => !shown.includes(name) && this.state[name] !== ofRecord[name]);
    if (!words || !others.length) return words;
    return `with ${others.map((name) => `${symbolOf(name)} = ${shortNumber(ofRecord[name])}`).join(", ")}: ${words}`;
  }

  showScene() {
    for (const input of document.querySelectorAll("#scene input"))
      if (input !== document.activeElement || input.type === "range") input.value = Number(Number(this.valueOf(input.dataset.name)).toPrecision(6));
    byId("start").value = String(this.state.start);
    byId("pace").value = this.state.pace;
  }

  showEvidence() {
    const { evidence, outcome, ok } = this.orbit;
    if (!ok) {
      byId("verdict").textContent = "no such start: the body does not lie within the container";
      for (const name of ["numbers", "rate", "command", "judge"]) byId(name).textContent = "";
      return;
    }
    const { words, period } = evidence.verdict(outcome);
    byId("verdict").textContent = words;
    byId("numbers").textContent = Number.isFinite(evidence.mean)
      ? (period ? `⟨S⟩ = ${shortNumber(evidence.meanOfLast(period))} on the cycle, ` : "⟨S⟩ = ") +
        `${shortNumber(evidence.mean)} since the start (ω_s t = ${shortNumber(evidence.time)})`
      : "⟨S⟩: from the second impact on";
    byId("rate").textContent = evidence.rateInWords();
    showWords(byId("command"), commandOf(this.scene, this.startAsFlags, Math.max(1, evidence.count)));
    showWords(byId("judge"), commandOf(this.scene, this.startAsFlags));
  }

  // What the reader does.

  buildControls() {
    const field = byId("scene");
    for (const [name, [low, high]] of Object.entries(SCENE_NUMBERS)) {
      const label = document.createElement("label"), axis = this.axisOf(name);
      const top = Math.max(high, axis ? axis.values[axis.order[axis.order.length - 1]] : Number(this.state[name]));
      label.append(`${symbolOf(name)} ${CALLED[name]}`);
      label.title = labelOf(name);
      for (const type of ["range", "number"]) {
        const input = Object.assign(document.createElement("input"), { type, min: low, max: top, step: 0.001 });
        if (type === "number") Object.assign(input, { min: 0, max: ALLOWED[name][1] });
        input.dataset.name = name;
        input.setAttribute("aria-label", `${labelOf(name)}${type === "range" ? ", slider" : ""}`);
        input.addEventListener(type === "range" ? "input" : "change", () => this.enter(name, input.value === "" ? NaN : Number(input.value)));
        label.append(input);
      }
      field.append(label);
    }
    this.data.starts.forEach((_, i) => byId("start").append(new Option(`seed ${this.data.seed + i}`, String(i))));
    byId("start").disabled = this.startIsGiven();
    if (this.figure.sweep) this.buildOthers(this.figure.sweep);
  }

  /** Of a grid over more than two parameters: the values at which it is seen. */
  buildOthers(sweep) {
    if (!sweep.isGrid) return;
    for (const axis of sweep.others) {
      this.state[axis.name] = axis.values[sweep.at[axis.name]];
      if (axis.values.length < 2) continue;
      const label = document.createElement("label"), choice = document.createElement("select");
      axis.order.forEach((place) => choice.append(new Option(axis.text(axis.values[place]), String(place))));
      choice.value = String(sweep.at[axis.name]);
      choice.dataset.name = axis.name;
      choice.addEventListener("change", () => this.setOther(axis, Number(choice.value)));
      label.append(`${symbolOf(axis.name)} `, choice, " ");
      byId("others").append(label);
    }
  }

  setOther(axis, place) {
    this.state[axis.name] = axis.values[place];
    this.showOthers();
    this.begin();
  }

  /** The figure and the choices show the values that the state has of the other parameters, where the grid has them. */
  showOthers() {
    const { sweep } = this.figure;
    if (!sweep || !sweep.isGrid) return;
    for (const axis of sweep.others) {
      const place = axis.values.indexOf(this.state[axis.name]);
      if (place >= 0) sweep.at[axis.name] = place;
    }
    for (const choice of document.querySelectorAll("#others select")) choice.value = String(sweep.at[choice.dataset.name]);
    this.figure.stale = true;
  }

  /** A number of the scene, held within its range; what is none leaves the scene as it is. */
  enter(name, value) {
    this.change({ [name]: Number.isFinite(value) ? value : this.state[name] });
    if (this.state[name] === value) return;
    if (!Number.isFinite(value)) byId("held").textContent = `${symbolOf(name)} stays ${shortNumber(this.state[name])}: no number was entered`;
    for (const input of document.querySelectorAll(`#scene input[data-name="${name}"]`)) input.value = this.state[name];
  }

  /** Within what is allowed; where it was not, the page says so. */
  held(name, value) {
    const [low, high] = ALLOWED[name], inside = Math.min(high, Math.max(low, value));
    if (inside !== value)
      this.notice = [this.notice, `${symbolOf(name)} = ${shortNumber(value)} is held to ${inside}: allowed are ${low} to ${high}`]
        .filter(Boolean).join("; ");
    return inside;
  }

  setRunning(running) {
    this.running = running;
    byId("play").textContent = running ? "Stop" : "Run";
    byId("play").setAttribute("aria-pressed", String(running));
    byId("evidence").setAttribute("aria-live", running ? "off" : "polite"); // while it runs it changes ten times a second
    this.dirty = true;
  }

  oneImpact() {
    this.setRunning(false);
    if (this.orbit.ended) return;
    if (this.orbit.time < this.orbit.wayEnds) this.orbit.time = this.orbit.wayEnds;
    else {
      this.orbit.impacts(1);
      this.orbit.time = this.orbit.wayEnds;
    }
    this.orbit.keepTrail(this.orbit.time);
    this.dirty = true;
  }

  goAhead() {
    this.orbit.ahead(AHEAD);
    this.dirty = true;
  }

  listen() {
    byId("play").addEventListener("click", () => this.setRunning(!this.running));
    byId("step").addEventListener("click", () => this.oneImpact());
    byId("ahead").addEventListener("click", () => this.goAhead());
    byId("restart").addEventListener("click", () => this.begin());
    byId("first").addEventListener("click", () => this.toFirst());
    byId("pace").addEventListener("change", (event) => this.setPace(event.target.value));
    byId("start").addEventListener("change", (event) => this.change({ start: Number(event.target.value) }));
    byId("frame").addEventListener("change", () => { this.writeHash(); this.dirty = true; });
    byId("copy").addEventListener("click", () => copy(byId("copy"), byId("command").textContent));
    byId("copy-judge").addEventListener("click", () => copy(byId("copy-judge"), byId("judge").textContent));
    byId("copy-link").addEventListener("click", () => copy(byId("copy-link"), byId("link").href));
    window.addEventListener("resize", () => this.resize());
    window.addEventListener("hashchange", () => {
      if (location.hash === this.written) return;
      this.readHash();
      this.begin();
    });
    document.addEventListener("keydown", (event) => this.onKey(event));
  }

  onKey(event) {
    const { tagName, type } = event.target;
    if (event.ctrlKey || event.metaKey || event.altKey || tagName === "SELECT" || (tagName === "INPUT" && type !== "range")) return;
    if (event.key === " " && /^(BUTTON|A|SUMMARY)$/.test(tagName)) return; // its own
    const next = (by) => this.setPace(PACES[Math.min(PACES.length - 1, Math.max(0, PACES.indexOf(this.state.pace) + by))]);
    const actions = {
      " ": () => this.setRunning(!this.running), ".": () => this.oneImpact(), f: () => this.goAhead(), r: () => this.begin(),
      "?": () => this.showWordList(),
      n: () => !this.startIsGiven() && this.change({ start: (this.state.start + 1) % this.data.starts.length }),
      "+": () => next(1), "-": () => next(-1),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }

  showWordList() {
    byId("words").open = true;
    byId("words").scrollIntoView({ block: "center" });
    byId("words").querySelector("summary").focus();
  }

  /** As the page was opened without an address. */
  toFirst() {
    Object.assign(this.state, this.first);
    byId("frame").value = "laboratory";
    this.showOthers();
    this.begin();
  }

  setPace(pace) {
    this.state.pace = pace;
    this.showScene();
    this.writeHash();
  }

  // The address holds the state.

  hashNames() {
    return [...new Set([...Object.keys(SCENE_NUMBERS), ...Object.keys(this.state)])].filter((name) => name in this.state);
  }

  writeHash() {
    this.written = "#" + this.hashNames().map((name) => `${name}=${encodeURIComponent(this.state[name])}`).join("&") +
      `&frame=${byId("frame").value}`;
    byId("link").href = this.written;
    try {
      history.replaceState(null, "", this.written);
    } catch (refused) {
      // A page from a file may not be allowed to: its link still holds the state.
    }
  }

  readHash() {
    const given = new URLSearchParams(location.hash.slice(1));
    const refuse = (name, text) => {
      this.notice = [this.notice, `${symbolOf(name)} = ${text} of the address is not taken`].filter(Boolean).join("; ");
    };
    for (const [name, text] of given) {
      if (name === "frame" && [...byId("frame").options].some((option) => option.value === text)) byId("frame").value = text;
      if (!(name in this.state) || (name === "sides" && !this.axisOf(name))) continue;
      const value = Number(text), axis = this.axisOf(name);
      const taken = name === "pace" ? PACES.includes(text)
        : name === "start" ? Number.isInteger(value) && this.data.starts[value] !== undefined
        : axis && axis.words ? axis.words[value] !== undefined
        : name === "sides" && axis ? axis.values.includes(value)
        : typeof this.state[name] !== "number" ? text === String(this.state[name]) : Number.isFinite(value) && text.trim() !== "";
      if (!taken) refuse(name, text);
      else this.state[name] = typeof this.state[name] === "number" ? value : text;
    }
    for (const name of Object.keys(ALLOWED))
      if (!(this.axisOf(name) || {}).words) this.state[name] = this.held(name, Number(this.state[name]));
    this.showOthers();
  }

  // Frames.

  resize() {
    this.figure.resize();
    for (const panel of Object.values(this.panels)) panel.fit();
    this.dirty = true;
  }

  /** One frame: the orbit goes on, and what changed is drawn.
   *   seconds  since the frame before */
  frame(seconds) {
    let made = 0;
    if (this.running && !this.orbit.ended) {
      const pace = Number(this.state.pace);
      made = pace === 0 ? this.orbit.rush(FRAME_BUDGET) : this.orbit.advanceTime(pace * Math.min(seconds, 0.1));
      this.dirty = true;
    }
    this.impacts = (this.impacts || 0) + made;
    this.frames = (this.frames || 0) + 1;
    this.count(seconds);
    if (!this.dirty) return;
    drawDish(this.panels.dish, this.orbit, byId("frame").value);
    const now = performance.now();
    if (this.running && now - this.drawn < 100) return; // what grows slowly is drawn ten times a second
    [this.drawn, this.dirty] = [now, false];
    drawSection(this.panels.section, this.orbit.evidence);
    drawSpin(this.panels.spin, this.orbit.evidence);
    this.showEvidence();
  }

  /** Frames and impacts a second, measured. */
  count(seconds) {
    this.seconds = (this.seconds || 0) + seconds;
    if (this.seconds < 1) return;
    this.speeds = { frames: this.frames / this.seconds, impacts: this.impacts / this.seconds };
    byId("speeds").textContent = this.running
      ? `${Math.round(this.speeds.frames)} frames and ${Math.round(this.speeds.impacts).toLocaleString("en")} impacts a second` : "";
    this.frames = this.impacts = this.seconds = 0;
  }
}

function byId(name) {
  return document.getElementById(name);
}

function tag(text) {
  const mark = document.createElement("span");
  mark.className = "tag program";
  mark.textContent = text;
  return mark;
}

/** A command, broken between flags alone. */
function showWords(element, text) {
  if (element.textContent === text) return;
  element.replaceChildren(...text.split(/(?= --)/).flatMap((words) => {
    const piece = document.createElement("span");
    piece.textContent = words.trimStart();
    return words.startsWith(" ") ? [" ", piece] : [piece];
  }));
}

/** To the clipboard, by what works in a page from a file, too, where the newer interface is closed; the button says whether. */
function copy(button, text) {
  const field = Object.assign(document.createElement("textarea"), { value: text });
  button.after(field);
  field.select();
  const done = document.execCommand("copy");
  field.remove();
  button.focus();
  button.textContent = done ? "Copied" : "The browser refused";
  setTimeout(() => { button.textContent = "Copy"; }, 2000);
}

async function open() {
  const data = JSON.parse(byId("data").textContent);
  const page = new Page(data, await SwirlMap.from(bytesOfBase64(byId("map").textContent)));
  window.swirlPage = page; // for tests
  page.resize();
  let before = performance.now();
  const next = (now) => {
    page.frame(Math.max(0, now - before) / 1000);
    before = now;
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) page.setRunning(true);
}

open().catch((error) => { byId("verdict").textContent = `The map could not be started: ${error.message}`; });
