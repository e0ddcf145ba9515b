// The page: what is looked at, and its parts.

import { Blocks } from "./blocks.js";
import { add, depthOf, eyeOf, forwardOf, length, scale, sub, unproject, withSize } from "./camera.js";
import { Cameras } from "./cameras.js";
import { Controls } from "./controls.js";
import { Edit } from "./edit.js";
import { Explain } from "./explain.js";
import { Frames } from "./frames.js";
import { Keyframes } from "./keyframes.js";
import { press } from "./keys.js";
import { Lens } from "./lens.js";
import { Measure } from "./measure.js";
import { Modes } from "./modes.js";
import { Overlay } from "./overlay.js";
import { $, brush, download, tell } from "./page.js";
import { Places } from "./places.js";
import { Status } from "./status.js";
import { Training } from "./training.js";

/** @import { Shown } from "./frames.js" */
/** @import { Camera, FrameAbout, FrameRequest, Mode, Pixel, Scene, Vector } from "./protocol" */

/** @type {Scene} */
const scene = await (await fetch("scene.json")).json();

/** @typedef {typeof view} Viewed */

// Everything that the image depends on.
const view = {
  scene,
  camera: scene.home,
  center: focusOf(scene.home),
  up: scene.up,
  extent: length(sub(scene.aabb[1], scene.aabb[0])) / 2,
  mode: /** @type {Mode} */ ("color"),
  background: /** @type {Vector | null} */ (null),
  // a view of the data set that the camera has not left
  index: /** @type {number | null} */ (null),
  // where the pointer rests, in the mode of depth
  depth: /** @type {number | null} */ (null),
  shown: /** @type {{ about: FrameAbout, blob: Blob, asked: FrameRequest } | null} */ (null),

  moved() {
    if (view.index != null) view.leave();
    explain.close();
    view.changed();
  },
  changed() {
    view.depth = null;
    frames.change();
    overlay.draw();
    status.say();
  },
  draw: () => overlay.draw(),
  fit: () => overlay.fit(),
  /** @param {number} index of a view of the data set */
  goTo(index) {
    const to = scene.views[index];
    if (!to) return;
    view.index = index;
    view.camera = to.camera;
    view.center = focusOf(view.camera);
    $("view").value = String(index);
    explain.close();
    cameras.compare();
    lens.place();
    view.changed();
  },
  reset() {
    view.index = null;
    $("view").value = "";
    view.camera = withSize(scene.home, lens.size);
    view.center = focusOf(scene.home);
    if (view.mode === "error") setMode("color");
    cameras.compare();
    lens.place();
    explain.close();
    view.changed();
  },
  // From a camera of the data set to one of the window's size.
  leave() {
    view.index = null;
    view.camera = withSize(view.camera, lens.size);
    if (view.mode === "error") setMode("color");
    $("view").value = "";
    cameras.compare();
  },
  /** @param {Pixel} pixel */
  click(pixel) {
    if (measure.isOn) measure.click(pixel);
    else explain.ask(pixel.map(Math.floor));
  },
  /**
   * Orbits around what is behind a pixel: its depth is the depth of the Gaussian with the largest alpha.
   * @param {Pixel} pixel
   */
  async focus(pixel) {
    const depth = await explain.depth(pixel.map(Math.floor));
    if (depth) view.center = unproject(view.camera, pixel, depth / scene.placement.scale);
    overlay.ping(view.center);
  },
  /** @param {Pixel} pixel */
  hover: (pixel) => explain.hover(pixel),
  say: () => status.say(),
  isHelp: () => $("help").open,
  /** @param {KeyboardEvent} event */
  key: (event) => press(event, { view, cameras, controls, edit, explain, keyframes, measure, modes, places }),
};

/**
 * What the camera goes around: the place on its axis that is nearest to the middle of the scene.
 * @param {Camera} camera
 */
function focusOf(camera) {
  const eye = eyeOf(camera.camera_to_world);
  const along = depthOf(camera, scene.center);
  const isAhead = along > 0.05 * length(sub(scene.aabb[1], scene.aabb[0]));
  const far = isAhead ? along : length(sub(scene.center, eye)) || 1;
  return add(eye, scale(forwardOf(camera.camera_to_world), far));
}

/** @returns {Shown} */
function request() {
  const { camera, mode, background, index } = view;
  return { camera, mode, background, view: mode === "error" ? index : null };
}

const frames = new Frames(request, show, fail);
const overlay = new Overlay($("overlay"), view);
const controls = new Controls($("overlay"), view);
const explain = new Explain(view, overlay);
const keyframes = new Keyframes(view, overlay);
const edit = scene.purpose === "edit" ? new Edit(view, overlay, frames, controls) : null;
const places = scene.scenes > 1 ? new Places(view, overlay, frames, controls) : null;
const measure = new Measure(view, overlay, explain, edit);
const training = scene.purpose === "train" ? new Training(frames) : null;
const cameras = new Cameras(view);
const lens = new Lens(view, () => frames.change());
const status = new Status(view, cameras.poses, frames, training);
const modes = new Modes(scene, (mode) => {
  setMode(mode);
  view.changed();
});
const blocks = new Blocks(frames);
frames.refines = !training;
frames.idle = () => status.say();
setInterval(() => status.say(), 500);

/** @param {Mode} mode */
function setMode(mode) {
  // an error needs a photograph
  if (mode === "error" && view.index == null) view.goTo(cameras.nearest);
  view.mode = mode;
  modes.show(mode);
}

/** @type {Frames["show"]} */
function show(bitmap, about, blob, asked) {
  const canvas = $("image");
  const { w, h } = asked.camera;
  // a smaller image is drawn larger: the canvas keeps the size of the view
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const context = brush(canvas);
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, 0, 0, w, h);
  bitmap.close();
  view.shown = { about, blob, asked };
  blocks.follow(about);
  document.documentElement.dataset.quality = about.quality;
  document.documentElement.dataset.sequence = String(about.sequence);
  lens.place();
  overlay.draw();
  status.say();
}

/** @param {string | null} message */
function fail(message) {
  // the panel says that the program has ended
  tell(training?.ended ? null : message ?? blocks.lack);
}

$("title").textContent = scene.title;
document.title = `${scene.title} · organza`;
$("save-image").onclick = async () => {
  const { shown } = view;
  const isExact = shown?.about.quality === "exact" && !frames.busy;
  const blob = isExact ? shown.blob : await frames.exact();
  if (blob) download(blob, `${scene.title}.png`);
};
$("reset").onclick = () => view.reset();
$("help-button").onclick = () => $("help").showModal();

view.camera = withSize(scene.home, lens.size);
frames.settle();
lens.place();
document.documentElement.dataset.ready = "";
Object.assign(window, { organza: { view, frames, keyframes, explain, training, edit, measure, places } });
