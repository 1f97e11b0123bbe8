// The map of the program, as the page calls it. Needs nothing of a browser.

const IMPACT = ["t", "x", "y", "vx", "vy", "angle", "S", "vertex", "psi", "chi", "vn", "vt", "flightTime", "p", "q", "mode"];
const MOST_IMPACTS = 4096; // of one call
const OUTCOMES = ["completed", "no-contact", "in-contact", "contact-cut-short", "resting", "diverged", "unresolved"];
const LAWS = ["poisson", "newton", "stronge"];

/** The bytes of the module from the text of the page. */
function bytesOfBase64(text) {
  const binary = atob(text.replace(/\s/g, ""));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}

/** One orbit of one scene. An orbit that leaves the range of what the module can follow ends as "unresolved". */
class SwirlMap {
  static async from(bytes) {
    const nothing = () => 0;
    const { instance } = await WebAssembly.instantiate(bytes, {
      env: { emscripten_notify_memory_growth: () => {} },
      wasi_snapshot_preview1: {
        proc_exit: () => { throw new Error("the map stopped"); },
        environ_sizes_get: nothing,
        environ_get: nothing,
      },
    });
    instance.exports._initialize();
    return new SwirlMap(instance.exports);
  }

  constructor(module) {
    this.module = module;
    this.broken = false;
  }

  /** Doubles in the module's memory, which may have moved since the call before. */
  numbers(address, count) {
    return new Float64Array(this.module.memory.buffer, address, count);
  }

  /** scene: {sides (0: disk), law, alpha, beta, mu, restitution, inertia_factor}; directions: four numbers a vertex.
   * False if the scene is out of its ranges. */
  setScene(scene, directions) {
    this.scene = scene;
    this.broken = false;
    this.numbers(this.module.swirl_exchange(), directions.length).set(directions);
    return this.module.swirl_scene(scene.sides, LAWS.indexOf(scene.law), scene.alpha, scene.beta, scene.mu,
                                   scene.restitution, scene.inertia_factor) === 1;
  }

  /** start: {x, y, vx, vy, angle, spin}, in the laboratory. False if the body does not lie within the container. */
  start(start) {
    this.broken = false;
    return this.module.swirl_start(this.scene.beta, this.scene.alpha, start.x, start.y, start.vx, start.vy, start.angle,
                                   start.spin) === 1;
  }

  /** Follows so many impacts, at most MOST_IMPACTS: their rows, IMPACT.length numbers each. Fewer: the orbit has ended.
   * The numbers are the module's own memory, valid until the next call. */
  run(impacts) {
    if (this.broken) return new Float64Array(0);
    try {
      const made = this.module.swirl_run(impacts);
      return this.numbers(this.module.swirl_exchange(), made * IMPACT.length);
    } catch (stopped) {
      this.broken = true;
      return new Float64Array(0);
    }
  }

  outcome() {
    return this.broken ? "unresolved" : OUTCOMES[this.module.swirl_outcome()];
  }

  /** The way to the last impact: t, x, y, angle, S, in contact, for each moment; straight lines lead from one to the
   * next. After the orbit's end: what contact there was after its last impact. */
  way() {
    return this.broken ? new Float64Array(0) : this.numbers(this.module.swirl_way(), 6 * this.module.swirl_moments());
  }
}
