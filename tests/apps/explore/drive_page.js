// drive_page.js MAP.html DIAGRAM.html FOLDER GRID.html: clicks, drags, keys and links of the page in chromium, at 1280 and at 400 pixels;
// what it draws, how fast, and that it asks for nothing from outside. Screenshots go to FOLDER.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { open } = require("./browser.js");

const wait = (seconds) => new Promise((done) => setTimeout(done, 1000 * seconds));
const READY = "window.swirlPage !== undefined && document.getElementById('verdict').textContent !== ''";

/** Share of a canvas that is not white. */
const inked = (id) => `(() => { const c = document.getElementById("${id}"), p = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
  let n = 0; for (let i = 0; i < p.length; i += 4) n += p[i] + p[i + 1] + p[i + 2] < 740; return n / (p.length / 4); })()`;
const text = (id) => `document.getElementById("${id}").textContent`;

function nothingFromOutside(page) {
  const asked = page.events.filter(({ method }) => method === "Network.requestWillBeSent").map(({ params }) => params.request.url);
  assert.deepEqual(asked.filter((url) => !/^(file|data):/.test(url)), []);
  const failed = page.events.filter(({ method }) => method === "Runtime.exceptionThrown" || method === "Log.entryAdded");
  assert.deepEqual(failed.map(({ params }) => JSON.stringify(params).slice(0, 300)), []);
}

async function explore(map) {
  const page = await open(pathToFileURL(map), 1280, 1000);
  try {
    await page.until(READY);
    const paint = await page.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime");
    assert.ok(paint <= 1000, `first picture after ${paint} ms`);
    assert.ok(await page.evaluate("document.documentElement.scrollWidth <= innerWidth"));
    await wait(1.5);
    for (const id of ["figure", "dish", "section", "spin"]) assert.ok(await page.evaluate(inked(id)) > 0.001, `${id} is empty`);

    // A click takes a place of the map, and a drag the places on its way.
    await page.click("figure", 0.3, 0.3);
    const clicked = await page.evaluate("({ ...swirlPage.state })");
    await page.click("figure", 0.7, 0.3);
    const other = await page.evaluate("({ ...swirlPage.state })");
    assert.ok(other.alpha > clicked.alpha && Math.abs(other.beta - clicked.beta) < 1e-9, JSON.stringify([clicked, other]));
    const from = await page.at("figure", 0.5, 0.6), to = { x: from.x, y: from.y - 80 };
    await page.mouse("mousePressed", from, 1);
    await page.mouse("mouseMoved", to, 1);
    await page.mouse("mouseReleased", to);
    assert.ok(await page.evaluate("swirlPage.state.beta") > 0.4);

    // A finger that scrolls over the figure takes nothing; one that moves sideways does, and one that taps.
    const finger = (...path) => page.evaluate(`(() => {
      const canvas = document.getElementById("figure"), box = canvas.getBoundingClientRect();
      canvas.setPointerCapture = () => {}; // of a pointer that is none
      ${JSON.stringify(path)}.forEach(([type, x, y]) => canvas.dispatchEvent(new PointerEvent(type,
        { pointerType: "touch", clientX: box.left + x * box.width, clientY: box.top + y * box.height })));
      return swirlPage.state.alpha; })()`);
    const untouched = await page.evaluate("swirlPage.state.alpha");
    assert.equal(await finger(["pointerdown", 0.3, 0.3], ["pointermove", 0.3, 0.32], ["pointermove", 0.35, 0.5], ["pointercancel", 0.35, 0.5]), untouched);
    const dragged = await finger(["pointerdown", 0.3, 0.3], ["pointermove", 0.4, 0.31], ["pointerup", 0.4, 0.31]);
    assert.notEqual(dragged, untouched);
    assert.ok(await finger(["pointerdown", 0.8, 0.3], ["pointerup", 0.8, 0.3]) > dragged);

    // What the record has beneath the mouse, in words.
    await page.mouse("mouseMoved", await page.at("figure", 0.9, 0.5));
    assert.match(await page.evaluate(text("cell")), /^Here: α = 0\.\d+, β = 0\.\d+: .* of (the|\d+) starts?/);

    // Keys: the figure's arrows go to cells, space stops, "." makes one impact.
    await page.evaluate("document.getElementById('figure').focus()");
    const before = await page.evaluate("swirlPage.state.alpha");
    await page.key("ArrowRight");
    assert.ok(await page.evaluate("swirlPage.state.alpha") > before);
    assert.ok(await page.evaluate("swirlPage.figure.axes[0].values.includes(swirlPage.state.alpha)"));
    await page.key(" ", " ");
    assert.equal(await page.evaluate("swirlPage.running"), false);
    const impacts = await page.evaluate("swirlPage.orbit.evidence.count");
    for (let i = 0; i < 4; ++i) await page.key(".", ".");
    assert.ok(await page.evaluate("swirlPage.orbit.evidence.count") >= impacts + 3);

    // The keys stay alive after a click on a button.
    const counted = () => page.evaluate("swirlPage.orbit.evidence.count");
    await page.click("step");
    const made = await counted();
    await page.key("f", "f");
    assert.equal(await counted(), made + 10000);
    await page.key("r", "r");
    assert.equal(await counted(), 0);
    await page.key("?", "?");
    assert.ok(await page.evaluate("document.getElementById('words').open && scrollY > 0"));

    // A number out of range is held, and both the box and a line say so; an emptied box changes nothing.
    const enter = (value) => page.evaluate(`(() => { const box = document.querySelector("#scene input[type=number][data-name=alpha]");
      box.focus(); box.value = "${value}"; box.dispatchEvent(new Event("change")); return box.value; })()`);
    assert.equal(await enter("1.5"), "0.999");
    assert.equal(await page.evaluate(text("held")), "α = 1.5 is held to 0.999: allowed are 0.001 to 0.999");
    assert.equal(await enter(""), "0.999");
    assert.match(await page.evaluate(text("held")), /^α stays 0\.999: no number/);
    assert.equal(await enter("0.4"), "0.4");
    assert.equal(await page.evaluate(text("held")), "");

    // The first scene comes back, and a click takes the middle of a cell.
    await page.click("first");
    assert.ok(await page.evaluate("swirlPage.hashNames().every((name) => swirlPage.state[name] === swirlPage.first[name])"));
    await page.click("figure", 0.41, 0.37);
    assert.ok(await page.evaluate("swirlPage.figure.axes.every((axis) => axis.values.includes(swirlPage.state[axis.name]))"));

    // The address holds the state: a page that is opened with it has the same scene.
    await page.evaluate("document.getElementById('frame').value = 'co-rotating'");
    await page.evaluate("swirlPage.enter('mu', 0.31)");
    const link = await page.evaluate("document.getElementById('link').href");
    assert.match(link, /mu=0\.31/);
    await page.send("Page.navigate", { url: "about:blank" });
    await page.send("Page.navigate", { url: link });
    await page.until(READY);
    assert.equal(await page.evaluate("swirlPage.scene.mu"), 0.31);
    assert.equal(await page.evaluate("document.getElementById('frame').value"), "co-rotating");

    // The record says nothing of a scene that it does not have.
    assert.match(await page.evaluate(text("recorded")), /^the record with μ = 0\.5: /);
    await page.evaluate("swirlPage.change({ alpha: 0.9 })");
    assert.equal(await page.evaluate(text("recorded")), "the record none: α is outside its range");

    // A steady scene settles, and the verdict says what was seen.
    await page.evaluate("swirlPage.change({ alpha: 0.5181818181818182, beta: 0.5444444444444444, mu: 0.5 }); swirlPage.setPace('0'); swirlPage.setRunning(true)");
    await page.until("/recur/.test(document.getElementById('verdict').textContent)", 120);
    assert.match(await page.evaluate(text("verdict")), /^steady: the last 32 impacts recur to 1e−9$/);
    const [, ofCycle] = (await page.evaluate(text("numbers"))).match(/^⟨S⟩ = (\S+) on the cycle, \S+ since the start/);
    const spin = await page.evaluate("swirlPage.orbit.evidence.coordinate(0, 4)"); // of the fixed point: the same at each impact
    assert.ok(Math.abs(Number(ofCycle.replace("−", "-")) - spin) < 1e-3 * Math.abs(spin), `${ofCycle} ${spin}`);
    // A chaotic one does not, and is not called so.
    await page.evaluate("swirlPage.change({ alpha: 0.3, beta: 0.1 })");
    await wait(4);
    assert.match(await page.evaluate(text("verdict")), /^no period up to 64 in [\d,]+ impacts: chaos, a closed curve/);
    const { frames, impacts: rate } = await page.evaluate("swirlPage.speeds");
    console.log(`chaos: first picture ${Math.round(paint)} ms, ${frames.toFixed(1)} frames and ${Math.round(rate)} impacts a second`);
    await page.screenshot(path.join(process.argv[4], "map-1280.png"));
    await named(page);
    nothingFromOutside(page);
    return { frames, rate };
  } finally {
    await page.close();
  }
}

/** All that can be reached has a name for a reader of screens. */
async function named(page) {
  const { nodes } = await page.send("Accessibility.getFullAXTree");
  const roles = new Set(["button", "combobox", "slider", "spinbutton", "link", "application", "image"]);
  const reached = nodes.filter(({ role, ignored }) => !ignored && role && roles.has(role.value));
  assert.ok(reached.length > 15, `${reached.length} elements`);
  const nameless = reached.filter(({ name }) => !name || !name.value);
  assert.deepEqual(nameless.map(({ role }) => role.value), []);
}

async function narrow(file, shot) {
  const page = await open(pathToFileURL(file), 400, 800);
  try {
    await page.until(READY);
    await wait(2);
    assert.ok(await page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "wider than a telephone");
    await page.screenshot(path.join(process.argv[4], shot));
    nothingFromOutside(page);
  } finally {
    await page.close();
  }
}

async function diagram(file) {
  const page = await open(pathToFileURL(file), 1280, 1000);
  try {
    await page.until(READY);
    await page.click("figure", 0.5, 0.5);
    assert.ok(Math.abs(await page.evaluate("swirlPage.scene.alpha") - 0.38) < 0.01);
    const branch = await page.evaluate("(() => { const f = swirlPage.figure.figure, l = swirlPage.figure.diagram.lines[0]; " +
      "return { x: f.toX((l.x[0] + l.x[1]) / 2) / f.width, y: f.toY((l.y[0] + l.y[1]) / 2) / f.height }; })()");
    await page.mouse("mouseMoved", await page.at("figure", branch.x, branch.y));
    assert.match(await page.evaluate(text("cell")), /^Here: cycle of period \d+, (un)?stable, α = 0\.3\d+, S = −?\d/);
    await page.evaluate("swirlPage.setPace('100')");
    await wait(3);
    assert.match(await page.evaluate(text("recorded")), /^the record α = 0\.\d+: steady, ⟨S⟩ = −1\.\d+/);
    await page.screenshot(path.join(process.argv[4], "diagram-1280.png"));
    nothingFromOutside(page);
  } finally {
    await page.close();
  }
}

/** Of a grid over three parameters the address, the choice and the figure show the same value of the third. */
async function grid(file) {
  const page = await open(`${pathToFileURL(file)}#mu=0.1`, 1280, 1000);
  const shown = () => page.evaluate("({ mu: swirlPage.state.mu, at: swirlPage.figure.sweep.all[2].values[swirlPage.figure.sweep.at.mu], " +
    "choice: document.querySelector('#others select').selectedOptions[0].text })");
  try {
    await page.until(READY);
    assert.deepEqual(await shown(), { mu: 0.1, at: 0.1, choice: "0.1" });
    for (const mu of [0.5, 0.1]) {
      await page.evaluate(`(() => { const choice = document.querySelector("#others select");
        choice.value = [...choice.options].find(({ text }) => text === "${mu}").value; choice.dispatchEvent(new Event("change")); })()`);
      assert.deepEqual(await shown(), { mu, at: mu, choice: String(mu) });
    }
    await page.click("first");
    const first = await page.evaluate("swirlPage.first.mu");
    assert.deepEqual(await shown(), { mu: first, at: first, choice: String(first) });
    nothingFromOutside(page);
  } finally {
    await page.close();
  }
}

async function main() {
  const { frames, rate } = await explore(process.argv[2]);
  await narrow(process.argv[2], "map-400.png");
  await diagram(process.argv[3]);
  await narrow(process.argv[3], "diagram-400.png");
  await grid(process.argv[5]);
  assert.ok(frames >= 30, `${frames} frames a second`); // 60 on a machine that does nothing else
  assert.ok(rate >= 1e5, `${rate} impacts a second`);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
