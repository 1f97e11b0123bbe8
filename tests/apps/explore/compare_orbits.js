// compare_orbits.js PAGE.html: reads lines "SCENE.csv {scene} {start}" from standard input, follows each orbit by the page's
// map and compares it with the rows that the program wrote (swirl show --csv). One line of JSON for each: impacts, how many
// rows of each column differ in any bit, the largest difference in ulp of the column's largest magnitude, the time of the first row in which the map itself differs (null: in none), impacts a second.
"use strict";

const fs = require("node:fs");
const { read, scripts } = require("./page.js");

const { SwirlMap, IMPACT, MOST_IMPACTS } = scripts();
const COLUMNS = { t: "t", x: "x", y: "y", vx: "vx", vy: "vy", angle: "angle", S: "spin", vertex: "vertex", psi: "psi", chi: "chi",
                  vn: "vn", vt: "vt", flightTime: "flight_time", p: "impulse_normal", q: "impulse_tangential" };

// What the map itself works out.
const OF_THE_MAP = ["t", "S", "vertex", "vn", "vt", "flightTime", "p", "q"];

function rowsOf(file) {
  const [names, ...lines] = fs.readFileSync(file, "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  const places = names.split(",");
  return { places, rows: lines.map((line) => line.split(",")) };
}

function compare(map, { places, rows }, scene, start) {
  if (!map.setScene(scene, scene.directions) || !map.start(start)) throw new Error("the scene or its start is refused");
  const differ = {}, most = {}, size = {};
  let made = 0, seconds = 0, first = Infinity;
  while (made < rows.length) {
    const begin = performance.now();
    const found = Float64Array.from(map.run(Math.min(MOST_IMPACTS, rows.length - made)));
    seconds += (performance.now() - begin) / 1000;
    if (!found.length) break;
    for (let i = 0; i < found.length; i += IMPACT.length, ++made)
      for (const [own, theirs] of Object.entries(COLUMNS)) {
        const place = places.indexOf(theirs);
        if (place < 0) continue; // a disk has no chi and no vertex
        const expected = Number(rows[made][place]), value = found[i + IMPACT.indexOf(own)];
        size[own] = Math.max(size[own] || 0, Math.abs(expected));
        if (Object.is(expected, value)) continue;
        differ[own] = (differ[own] || 0) + 1;
        if (OF_THE_MAP.includes(own)) first = Math.min(first, Number(rows[made][places.indexOf("t")]));
        most[own] = Math.max(most[own] || 0, Math.abs(expected - value));
      }
  }
  const ulps = Object.fromEntries(Object.entries(most).map(([name, value]) => [name, value / (size[name] * Number.EPSILON)]));
  const more = map.run(1).length / IMPACT.length;
  return { impacts: made, expected: rows.length, goesOn: more > 0, outcome: map.outcome(), differ, ulps, first,
           impactsASecond: Math.round(made / seconds) };
}

async function main() {
  const { data, module } = read(process.argv[2]);
  const map = await SwirlMap.from(module);
  for (const line of fs.readFileSync(0, "utf8").split("\n").filter(Boolean)) {
    const { csv, scene, seed } = JSON.parse(line);
    const body = data.bodies[scene.sides === 0 ? "disk" : scene.sides];
    const [cosine, sine, angle] = data.starts[seed - data.seed];
    const start = { x: scene.beta, y: 0, vx: data.speed * cosine, vy: data.speed * sine, angle, spin: 0 };
    const whole = { ...scene, inertia_factor: body.inertia_factor, directions: body.directions };
    console.log(JSON.stringify(compare(map, rowsOf(csv), whole, start)));
  }
}

main();
