// What is looked at, and which image comes next.

import { add, depthOf, eyeOf, farness, forwardOf, hex, length } from "./camera.js";
import { nearestOf, opacityAt, scale, sub, withSize } from "./camera.js";
import { Pace } from "./pace.js";
import { $, EMBEDDED, fullScreen, reasonOf, say } from "./page.js";
import { Frame, tilesOf } from "./player.js";
import { Screen } from "./screen.js";
import { lookAt, turn } from "./turn.js";

/** @import { Camera, Vector } from "../../page/protocol" */
/** @import { Controls } from "./controls.js" */
/** @import { Player } from "./player.js" */
/** @import { Header, Plan } from "./types" */

/** @typedef {{ quality: string, camera: Camera, plan: Plan, time: number, counts: number[] }} Shown */

const REST = 160; // milliseconds without a movement
const OPEN = 2; // plans whose memory is kept
const BLURRED = 8; // a device that has to divide images' sides by more than this does not turn by itself
const number = new Intl.NumberFormat("en");

export class Viewer {
  /** @type {string[]} */
  errors = [];
  /** @type {Frame[]} with memory, the one that was used last is last */
  frames = [];
  /** @type {"moving" | "rest" | null} */
  wanted = null;
  busy = false;
  /** @type {Shown | null} */
  shown = null;
  /** Whether the scene has replaced the poster. */
  revealed = false;
  /** Whether the visitor has touched the page. */
  touched = false;
  turning = false;
  /** Whether counters are shown. */
  counters = false;
  resting = 0;
  /** @type {Controls | null} */
  controls = null;

  /**
   * @param {GPUDevice} device
   * @param {Player} player
   * @param {Header} header
   */
  constructor(device, player, header) {
    this.device = device;
    this.player = player;
    this.header = header;
    this.screen = new Screen(device, $("view"));
    $("stage").style.background = hex(header.background);
    this.pace = new Pace(header.plans);
    this.largest = Math.max(...header.plans.map((plan) => plan.tiles));
    this.side = header.plans[0].side;
    this.up = header.up;
    this.extent = length(sub(header.aabb[1], header.aabb[0])) / 2;
    this.camera = header.home;
    this.center = header.center;
    this.reset();
  }

  /** Learns what images take behind the poster: the first ones that are seen are neither blurred nor late. */
  async start() {
    this.busy = true;
    this.resize();
    try {
      const isSlow = () => this.pace.shrink > this.least && this.pace.shrink <= BLURRED;
      for (let images = 0; images < 24 && isSlow(); images++) {
        const time = await this.image("moving", this.pace.shrink, this.pace.steps[this.pace.coarse]);
        if (!time) break;
        this.pace.learn(time, this.least);
      }
    } catch (error) {
      this.fail(error);
    }
    this.busy = false;
    this.next();
  }

  /** The scene replaces the poster, and turns. */
  reveal() {
    if (this.revealed) return;
    this.revealed = true;
    $("poster").classList.add("gone");
    this.tell();
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!this.touched && !isStill) this.turn();
  }

  /** Turns slowly until the visitor touches the page. */
  turn() {
    if (this.header.way.length === 0) return;
    this.turning = true;
    turn(this.header, this, (look) => {
      this.turning &&= this.pace.shrink <= BLURRED;
      if (!this.turning) return false;
      Object.assign(this, look(this.camera));
      this.moved();
      return true;
    });
  }

  /**
   * Goes to a part of the way.
   * @param {number} part
   */
  turnTo(part) {
    Object.assign(this, lookAt(this.header, this.camera, part));
  }

  touch() {
    this.touched = true;
    this.turning = false;
  }

  /** Within another page, the wheel scrolls that one until the visitor has clicked on this one. */
  leavesWheel() {
    return EMBEDDED && !document.hasFocus();
  }

  // --- the camera; Controls read and change it

  reset() {
    this.camera = withSize(this.header.home, this.size());
    this.center = this.header.center;
    const pose = this.camera.camera_to_world;
    const along = depthOf(this.camera, this.center);
    // on the camera's axis, so that the first drag does not jump
    if (along > 0) this.center = add(eyeOf(pose), scale(forwardOf(pose), along));
  }

  goToNearest() {
    const { poses } = this.header;
    if (poses.length === 0) return;
    const pose = poses[nearestOf(this.camera, poses, this.extent)];
    const far = length(sub(this.center, eyeOf(this.camera.camera_to_world)));
    this.camera = { ...this.camera, camera_to_world: pose };
    this.center = add(eyeOf(pose), scale(forwardOf(pose), far));
    this.moved();
  }

  size() {
    const box = $("stage").getBoundingClientRect();
    const dense = devicePixelRatio || 1;
    return [box.width, box.height].map((side) => Math.max(16, Math.min(4096, Math.round(side * dense))));
  }

  resize() {
    const [width, height] = this.size();
    Object.assign(this.screen.canvas, { width, height });
    this.camera = withSize(this.camera, [width, height]);
    this.moved();
  }

  moved() {
    this.wanted = "moving";
    this.pace.forgive();
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.rest(), REST);
    this.next();
  }

  rest() {
    this.wanted = "rest";
    this.next();
  }

  click() {}
  focus() {}
  isHelp() {
    return $("help").open;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const move = (/** @type {() => void} */ change) => () => {
      change();
      this.moved();
    };
    /** @type {Record<string, () => void>} */
    const acts = {
      "?": () => $("help").showModal(),
      r: move(() => this.reset()),
      l: move(() => this.controls?.level()),
      f: fullScreen,
      n: () => this.goToNearest(),
      i: () => { this.counters = !this.counters; this.tellStatus(); },
      "[": move(() => this.controls?.zoom(0.94)),
      "]": move(() => this.controls?.zoom(1.06)),
    };
    acts[event.key.length === 1 ? event.key.toLowerCase() : event.key]?.();
  }

  // --- images

  /**
   * The camera in an image whose sides are divided by `shrink`.
   * @param {number} shrink
   */
  shrunk(shrink) {
    const { w, h } = this.camera;
    return withSize(this.camera, [w, h].map((side) => Math.max(16, Math.round(side / shrink))));
  }

  /** The smallest shrink that there are plans for. */
  get least() {
    let least = 1;
    while (tilesOf(this.shrunk(least), this.side) > this.largest) least *= 1.05;
    return least;
  }

  async next() {
    if (this.busy || !this.wanted) return;
    const quality = this.wanted;
    this.wanted = null;
    this.busy = true;
    try {
      if (quality === "moving") {
        const time = await this.image("moving", this.pace.shrink, this.pace.steps[this.pace.coarse]);
        if (time) this.pace.learn(time, this.least);
      } else {
        await this.refine();
      }
    } catch (error) {
      this.fail(error);
    }
    this.busy = false;
    this.next();
  }

  /** All samples first, then all pixels: as soon as the camera moves, that comes first. */
  async refine() {
    const shrink = Math.max(this.least, Math.min(this.pace.shrink, 4));
    const time = await this.image("rest", shrink, this.pace.steps[0]);
    const finer = time ? this.pace.rest(time, shrink, this.least) : shrink;
    if (finer < 0.9 * shrink && !this.wanted) await this.image("rest", finer, this.pace.steps[0]);
    if (this.wanted) return;
    document.documentElement.dataset.quality = "rest";
    this.reveal();
  }

  /**
   * Renders an image and shows it; gives the milliseconds that it took. A plan that was too small leaves the
   * last image, and the next larger one takes its place.
   * @param {string} quality
   * @param {number} shrink
   * @param {number} steps
   */
  async image(quality, shrink, steps) {
    for (;;) {
      const camera = this.shrunk(shrink);
      const plan = this.pace.plan(tilesOf(camera, this.side), steps);
      if (!plan) {
        // fewer pixels need less room
        if (shrink < 16) {
          shrink *= 1.5;
          continue;
        }
        say("This view needs more memory than the page has planned for. Step back a little.");
        return null;
      }
      const begin = performance.now();
      const rendered = await this.render(plan, camera);
      const time = performance.now() - begin;
      if (!rendered) continue;
      say(null);
      this.screen.show(rendered.frame, camera);
      this.shown = { quality, camera, plan, time, counts: rendered.counts };
      document.documentElement.dataset.quality = quality === "moving" ? "moving" : "refining";
      this.tell();
      return time;
    }
  }

  /**
   * Renders with a plan; gives nothing where it was too small.
   * @param {Plan} plan
   * @param {Camera} camera
   */
  async render(plan, camera) {
    const frame = this.frame(plan);
    const { overflow, needed, counts } = await frame.render(camera);
    if (overflow) {
      this.pace.tooSmall(plan);
      return null;
    }
    this.pace.sufficed(plan, needed);
    return { frame, counts };
  }

  /**
   * The plan's memory.
   * @param {Plan} plan
   */
  frame(plan) {
    let frame = this.frames.find((one) => one.plan === plan);
    this.frames = this.frames.filter((one) => one !== frame);
    if (!frame) {
      while (this.frames.length >= OPEN) this.frames.shift()?.close();
      frame = new Frame(this.player, plan);
    }
    this.frames.push(frame);
    return frame;
  }

  /**
   * The pixels of an image, row by row, red, green and blue of each; and what it needed.
   * @param {Camera} camera
   * @param {Plan} plan
   */
  async pixels(camera, plan) {
    const rendered = await this.render(plan, camera);
    if (!rendered) return null;
    const { frame, counts } = rendered;
    const { side } = plan;
    const { device } = this;
    const usage = GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST;
    const staging = device.createBuffer({ size: frame.image.size, usage });
    const encoder = device.createCommandEncoder();
    encoder.copyBufferToBuffer(frame.image, 0, staging, 0, staging.size);
    device.queue.submit([encoder.finish()]);
    await staging.mapAsync(GPUMapMode.READ);
    const values = new Float32Array(staging.getMappedRange());
    const { w, h } = camera;
    const columns = Math.ceil(w / side);
    const pixels = new Float32Array(3 * w * h);
    for (let y = 0; y < h; y++) {
      for (let x = 0; x < w; x++) {
        const tile = Math.floor(y / side) * columns + Math.floor(x / side);
        const at = (y % side) * side + (x % side);
        for (let channel = 0; channel < 3; channel++) {
          pixels[3 * (y * w + x) + channel] = values[(3 * tile + channel) * side * side + at];
        }
      }
    }
    staging.destroy();
    return { pixels, counts };
  }

  tell() {
    // the poster is in front, and the page says that it loads
    if (!this.revealed || !this.shown) return;
    const { quality, camera, plan, time, counts } = this.shown;
    const isEnlarged = $("view").clientWidth > 1.5 * camera.w;
    const name = quality === "moving" ? "moving" : "exact";
    $("quality").dataset.is = name;
    $("quality").textContent = name === "exact" && isEnlarged ? "enlarged" : name;
    const facts = [`${camera.w} × ${camera.h}`, `${time.toFixed(0)} ms`];
    facts.push(`${number.format(counts[0])} Gaussians in view`);
    facts.push(`${number.format(counts[2])} samples${plan.steps > 1 ? `, steps × ${plan.steps}` : ""}`);
    $("numbers").textContent = facts.join(" · ");
    this.tellStatus();
  }

  /** Counters, if they are asked for, and whether the view is far from all photographs: it fades there. */
  tellStatus() {
    if (!this.revealed) return;
    const far = farness(this.camera, this.header.poses, this.header.center);
    const isFarAway = far > 1;
    $("far").hidden = !isFarAway;
    $("view").style.opacity = String(opacityAt(far));
    $("numbers").hidden = !this.counters;
    $("status").hidden = !this.counters && !isFarAway;
  }

  /** @param {unknown} error */
  fail(error) {
    const reason = error instanceof GPUError ? error.message : reasonOf(error);
    this.errors.push(reason);
    $("status").hidden = true;
    say(`The GPU could not render this: ${reason}`);
  }
}
