// What the tests have of the page: its scripts without a browser, and what a page that was written holds.
"use strict";

const fs = require("node:fs");
const path = require("node:path");

const FOLDER = path.join(__dirname, "../../../apps/explore/page");

/** The names that the scripts that need no browser define. */
function scripts() {
  const text = ["map", "evidence", "record", "draw"].map((name) => fs.readFileSync(path.join(FOLDER, `${name}.js`), "utf8"));
  const names = ["SwirlMap", "bytesOfBase64", "IMPACT", "OUTCOMES", "MOST_IMPACTS", "Evidence", "Axis", "Sweep", "Diagram", "curvesOf",
    "attractorsInWords", "commandOf", "shortNumber", "inWords", "ticksBetween", "decadesBetween", "rangeOf", "rangeOfMost"];
  return new Function(`"use strict";${text.join("\n")}\nreturn {${names.join(",")}};`)();
}

/** {data, module}: the JSON of a page and its map. */
function read(file) {
  const text = fs.readFileSync(file, "utf8");
  const within = (id) => text.match(new RegExp(`<script type="[^"]*" id="${id}">([^]*?)</script>`))[1];
  return { data: JSON.parse(within("data")), module: Buffer.from(within("map"), "base64") };
}

module.exports = { FOLDER, read, scripts };
