// Formulas as KaTeX renders them: render_formulas.js KATEX < [{"tex", "display"}, …] > [{"html"} or {"error"}, …]
// KATEX is its katex.js. `strict`: what LaTeX itself would not take is an error, too.
const katex = require(process.argv[2]);
const formulas = JSON.parse(require("fs").readFileSync(0, "utf8"));

function rendered({tex, display}) {
  try {
    return {html: katex.renderToString(tex, {displayMode: display, strict: "error"})};
  } catch (error) {
    return {error: error.message};
  }
}

process.stdout.write(JSON.stringify(formulas.map(rendered)));
