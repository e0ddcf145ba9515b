// The page: what is looked at, and which image comes next.

import { add, cross, eyeOf, farness, forwardOf, hex, length, nearestOf, opacityAt, poseOf, scale, sub, withSize } from "./camera.js";
import { Controls } from "./controls.js";
import { Pace } from "./pace.js";
import { Frame, Player, tilesOf, unpack } from "./player.js";
import { Screen } from "./screen.js";

const REST = 160; // milliseconds without a movement
const OPEN = 2; // plans whose memory is kept
const TURN = 80; // seconds of a slow turn
const LEAVE = 6; // seconds until it has left the first view
const BLURRED = 8; // a device that has to divide images' sides by more than this does not turn by itself
const $ = (id) => document.getElementById(id);
const number = new Intl.NumberFormat("en");

function say(message) {
  $("message").hidden = !message;
  $("message").textContent = message ?? "";
}

// Whether another page shows this one.
const EMBEDDED = new URLSearchParams(location.search).has("embed");

function fullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.();
}

// Ends the page with a reason.
class Missing extends Error {}

async function openDevice() {
  if (!navigator.gpu) {
    if (!isSecureContext) throw new Missing("This is a picture. To turn the scene, open the page over https: browsers offer WebGPU only there.");
    throw new Missing("This is a picture. To turn the scene, open it in a browser with WebGPU: a current Chrome, Edge, Safari or Firefox.");
  }
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) throw new Missing("This is a picture. To turn the scene, this browser needs a GPU, and WebGPU found none: try another browser.");
  return adapter.requestDevice();
}

class Viewer {
  constructor(device, player, header) {
    Object.assign(this, { device, player, header, errors: [] });
    this.screen = new Screen(device, $("view"));
    $("stage").style.background = hex(header.background);
    this.pace = new Pace(header.plans);
    this.frames = []; // with memory, the one that was used last is last
    this.largest = Math.max(...header.plans.map((plan) => plan.tiles));
    this.side = header.plans[0].side;
    this.up = header.up;
    this.extent = length(sub(header.aabb[1], header.aabb[0])) / 2;
    this.wanted = null; // "moving" or "rest"
    this.busy = false;
    this.shown = null;
    this.touched = this.turning = false;
    this.reset();
  }

  // Learns what images take behind the poster, so that the first ones that are seen are neither blurred nor late.
  async start() {
    this.busy = true;
    this.resize();
    try {
      for (let images = 0; images < 24 && this.pace.shrink > this.least && this.pace.shrink <= BLURRED; images++) {
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

  // The scene replaces the poster, and turns.
  reveal() {
    if (this.revealed) return;
    this.revealed = true;
    $("poster").classList.add("gone");
    this.tell();
    if (!this.touched && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.turn();
  }

  // --- the slow turn, until the visitor touches the page

  turn() {
    if (this.header.way.length === 0) return;
    this.turning = true;
    let last = performance.now(), seconds = 0;
    const first = [eyeOf(this.camera.camera_to_world), this.center];
    const step = (now) => {
      this.turning &&= this.pace.shrink <= BLURRED;
      if (!this.turning) return;
      seconds += Math.max(0, Math.min(0.1, (now - last) / 1000));
      last = now;
      const left = Math.min(1, seconds / LEAVE);
      this.turnTo((seconds / TURN) % 1, first, left * left * (3 - 2 * left));
      this.moved();
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  // A place on the way; on the way from the first eye and center to it, `left` is below 1.
  turnTo(part, first, left = 1) {
    const { way, center: middle, up } = this.header, at = part * way.length, index = Math.floor(at);
    const mix = (from, to, part) => add(from, scale(sub(to, from), part));
    const there = mix(way[index % way.length], way[(index + 1) % way.length], at - index);
    const [eye, center] = left < 1 ? [mix(first[0], there, left), mix(first[1], middle, left)] : [there, middle];
    const back = sub(eye, center);
    this.center = center;
    this.camera = { ...this.camera, camera_to_world: poseOf(cross(up, back), back, eye) };
  }

  touch() {
    this.touched = true;
    this.turning = false;
  }

  // Within another page, the wheel scrolls that one until the visitor has clicked on this one.
  leavesWheel() {
    return EMBEDDED && !document.hasFocus();
  }

  // --- the camera; Controls read and change it

  reset() {
    this.camera = withSize(this.header.home, this.size());
    this.center = this.header.center;
    const eye = eyeOf(this.camera.camera_to_world), forward = forwardOf(this.camera.camera_to_world);
    const along = sub(this.center, eye).reduce((sum, x, at) => sum + x * forward[at], 0);
    // on the camera's axis, so that the first drag does not jump
    if (along > 0) this.center = add(eye, scale(forward, along));
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
    const box = $("stage").getBoundingClientRect(), dense = devicePixelRatio || 1;
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

  key(event) {
    const act = {
      "?": () => $("help").showModal(),
      r: () => { this.reset(); this.moved(); },
      l: () => { this.controls.level(); this.moved(); },
      f: fullScreen,
      n: () => this.goToNearest(),
      i: () => { this.counters = !this.counters; this.tellStatus(); },
      "[": () => { this.controls.zoom(0.94); this.moved(); },
      "]": () => { this.controls.zoom(1.06); this.moved(); },
    }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    act?.();
  }

  // --- images

  // The camera in an image whose sides are divided by `shrink`.
  shrunk(shrink) {
    return withSize(this.camera, [this.camera.w, this.camera.h].map((side) => Math.max(16, Math.round(side / shrink))));
  }

  // The smallest shrink that there are plans for.
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
        // all samples first, then all pixels: as soon as the camera moves, that comes first
        const shrink = Math.max(this.least, Math.min(this.pace.shrink, 4));
        const time = await this.image("rest", shrink, this.pace.steps[0]);
        const finer = time && this.pace.rest(time, shrink, this.least);
        if (finer < 0.9 * shrink && !this.wanted) await this.image("rest", finer, this.pace.steps[0]);
        if (!this.wanted) {
          document.documentElement.dataset.quality = "rest";
          this.reveal();
        }
      }
    } catch (error) {
      this.fail(error);
    }
    this.busy = false;
    this.next();
  }

  // Renders an image and shows it; gives the milliseconds that it took. A plan that was too small leaves the last image, and the next
  // larger one takes its place.
  async image(quality, shrink, steps) {
    for (;;) {
      const camera = this.shrunk(shrink), plan = this.pace.plan(tilesOf(camera, this.side), steps);
      if (!plan) {
        // fewer pixels need less room
        if (shrink < 16) { shrink *= 1.5; continue; }
        say("This view needs more memory than the page has planned for. Step back a little.");
        return null;
      }
      const begin = performance.now(), rendered = await this.render(plan, camera);
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

  // Renders with a plan; gives nothing where it was too small.
  async render(plan, camera) {
    const frame = this.frame(plan), { overflow, needed, counts } = await frame.render(camera);
    if (overflow) {
      this.pace.tooSmall(plan);
      return null;
    }
    this.pace.sufficed(plan, needed);
    return { frame, counts };
  }

  // The plan's memory.
  frame(plan) {
    let frame = this.frames.find((one) => one.plan === plan);
    this.frames = this.frames.filter((one) => one !== frame);
    if (!frame) {
      while (this.frames.length >= OPEN) this.frames.shift().close();
      frame = new Frame(this.player, plan);
    }
    this.frames.push(frame);
    return frame;
  }

  // The pixels of an image, row by row, red, green and blue of each; and what it needed.
  async pixels(camera, plan) {
    const rendered = await this.render(plan, camera);
    if (!rendered) return null;
    const { frame, counts } = rendered, { side } = plan, { device } = this;
    const staging = device.createBuffer({ size: frame.image.size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    const encoder = device.createCommandEncoder();
    encoder.copyBufferToBuffer(frame.image, 0, staging, 0, staging.size);
    device.queue.submit([encoder.finish()]);
    await staging.mapAsync(GPUMapMode.READ);
    const values = new Float32Array(staging.getMappedRange()), { w, h } = camera, columns = Math.ceil(w / side);
    const pixels = new Float32Array(3 * w * h);
    for (let y = 0; y < h; y++) {
      for (let x = 0; x < w; x++) {
        const tile = Math.floor(y / side) * columns + Math.floor(x / side), at = (y % side) * side + (x % side);
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
    if (!this.revealed) return;
    const { quality, camera, plan, time, counts } = this.shown;
    const isEnlarged = $("view").clientWidth > 1.5 * camera.w;
    $("quality").dataset.is = quality === "moving" ? "moving" : "exact";
    $("quality").textContent = quality !== "moving" && isEnlarged ? "enlarged" : $("quality").dataset.is;
    const facts = [`${camera.w} × ${camera.h}`, `${time.toFixed(0)} ms`, `${number.format(counts[0])} Gaussians in view`];
    facts.push(`${number.format(counts[2])} samples${plan.steps > 1 ? `, steps × ${plan.steps}` : ""}`);
    $("numbers").textContent = facts.join(" · ");
    this.tellStatus();
  }

  // Counters, if they are asked for, and whether the view is far from what photographs show: it fades there.
  tellStatus() {
    if (!this.revealed) return;
    const far = farness(this.camera, this.header.poses, this.header.center);
    const isFarAway = far > 1;
    $("far").hidden = !isFarAway;
    $("view").style.opacity = opacityAt(far);
    $("numbers").hidden = !this.counters;
    $("status").hidden = !this.counters && !isFarAway;
  }

  fail(error) {
    this.errors.push(error.message);
    $("status").hidden = true;
    say(`The GPU could not render this: ${error.message}`);
  }
}

if (EMBEDDED) document.documentElement.classList.add("embed");
$("full-button").hidden = !document.fullscreenEnabled;
$("full-button").onclick = fullScreen;
try {
  if (typeof ORGANZA_SCENE === "undefined") throw new Missing("This is a picture. To turn the scene, the page needs scene.js beside it: copy the whole folder.");
  const device = await openDevice();
  const content = await unpack(ORGANZA_SCENE);
  const viewer = new Viewer(device, await Player.open(device, content), content.header);
  device.addEventListener("uncapturederror", ({ error }) => viewer.fail(error));
  device.lost.then(({ reason, message }) => reason !== "destroyed" && say(`The GPU was lost (${message}). Load the page again.`));
  viewer.controls = new Controls($("view"), viewer);
  $("help").querySelector("h2").textContent = content.header.title;
  $("help").querySelector("p").textContent = `${number.format(content.header.gaussians)} Gaussians, rendered on this device by organza ${content.header.version}`;
  $("help-button").onclick = () => $("help").showModal();
  for (const event of ["pointerdown", "keydown", "wheel"]) {
    addEventListener(event, () => (event === "wheel" && viewer.leavesWheel()) || viewer.touch(), { passive: true });
  }
  viewer.start();
  new ResizeObserver(() => viewer.resize()).observe($("stage"));
  window.organza = viewer;
} catch (error) {
  $("status").hidden = $("help-button").hidden = true;
  $("message").classList.toggle("plain", error instanceof Missing);
  say(error instanceof Missing ? error.message : `The page could not start: ${error.message}`);
}
document.documentElement.dataset.ready = "";
