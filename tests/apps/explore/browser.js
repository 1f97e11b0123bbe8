// Debian's chromium, driven through the pipe of its DevTools protocol: nothing but node is wanted.
"use strict";

const { spawn } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const CHROMIUM = "/usr/bin/chromium";

/** A page of a file, of the width and height given. Close it by `close()`. */
async function open(url, width, height) {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "swirl-chromium-"));
  const browser = spawn(CHROMIUM, ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
    "--no-first-run", "--remote-debugging-pipe", `--user-data-dir=${profile}`, `--window-size=${width},${height}`, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [, , , to, from] = browser.stdio;
  const waiting = new Map(), events = [];
  let number = 0, text = "";
  from.on("data", (chunk) => {
    text += chunk;
    for (let end = text.indexOf("\0"); end >= 0; end = text.indexOf("\0")) {
      const message = JSON.parse(text.slice(0, end));
      text = text.slice(end + 1);
      if (message.id === undefined) events.push(message);
      else if (message.error) waiting.get(message.id).no(new Error(message.error.message));
      else waiting.get(message.id).yes(message.result);
    }
  });
  browser.on("exit", () => { for (const { no } of waiting.values()) no(new Error("chromium has ended")); });
  const call = (method, params = {}, sessionId = undefined) => new Promise((yes, no) => {
    waiting.set(++number, { yes, no });
    to.write(JSON.stringify({ id: number, method, params, sessionId }) + "\0");
  });
  const { targetInfos } = await call("Target.getTargets");
  const { targetId } = targetInfos.find(({ type }) => type === "page");
  const { sessionId } = await call("Target.attachToTarget", { targetId, flatten: true });
  const send = (method, params) => call(method, params, sessionId);
  for (const domain of ["Page", "Runtime", "Network", "Log"]) await send(`${domain}.enable`);
  await send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 600 });

  const page = {
    events,
    send,
    async evaluate(expression) {
      const { result, exceptionDetails } = await send("Runtime.evaluate",
        { expression, awaitPromise: true, returnByValue: true });
      if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
      return result.value;
    },
    async until(expression, seconds = 60) {
      for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
        if (await page.evaluate(expression)) return;
        await new Promise((done) => setTimeout(done, 100));
      }
      throw new Error(`not within ${seconds} s: ${expression}`);
    },
    async screenshot(file) {
      const { cssContentSize: size } = await send("Page.getLayoutMetrics");
      const { data } = await send("Page.captureScreenshot", { captureBeyondViewport: true,
        clip: { x: 0, y: 0, width: size.width, height: size.height, scale: 1 } });
      fs.writeFileSync(file, Buffer.from(data, "base64"));
    },
    /** The middle of an element, or a share of its size from its upper left. */
    async at(id, across = 0.5, down = 0.5) {
      return page.evaluate(`(() => { const e = document.getElementById(${JSON.stringify(id)}); e.scrollIntoView({ block: "center" });
        const b = e.getBoundingClientRect(); return { x: b.left + ${across} * b.width, y: b.top + ${down} * b.height }; })()`);
    },
    async mouse(type, place, buttons = 0) {
      await send("Input.dispatchMouseEvent", { type, ...place, button: type === "mouseMoved" && !buttons ? "none" : "left",
                                               buttons, clickCount: 1 });
    },
    async click(id, across, down) {
      const place = await page.at(id, across, down);
      await page.mouse("mouseMoved", place);
      await page.mouse("mousePressed", place, 1);
      await page.mouse("mouseReleased", place);
    },
    async key(key, text = undefined) {
      const named = { ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9 };
      await send("Input.dispatchKeyEvent", { type: "keyDown", key, code: key, text, windowsVirtualKeyCode: named[key] });
      await send("Input.dispatchKeyEvent", { type: "keyUp", key, code: key });
    },
    async close() {
      const gone = new Promise((done) => browser.on("exit", done));
      await call("Browser.close").catch(() => {});
      const late = setTimeout(() => browser.kill("SIGKILL"), 5000);
      await gone;
      clearTimeout(late);
      fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
  await send("Page.navigate", { url });
  return page;
}

module.exports = { CHROMIUM, open };
