// The page: what is looked at, and what the panel says.

import { add, angleOf, eyeOf, farness, forwardOf, hex, length, nearestOf, opacityAt, scale, sub, unproject, withAngle, withSize } from "./camera.js";
import { Controls } from "./controls.js";
import { Edit } from "./edit.js";
import { Explain } from "./explain.js";
import { Frames, post } from "./frames.js";
import { Keyframes } from "./keyframes.js";
import { Measure } from "./measure.js";
import { Overlay } from "./overlay.js";
import { $, download } from "./page.js";
import { Places } from "./places.js";
import { Training } from "./training.js";

const MODES = {
  color: ["Color", ""], visibility: ["Visibility", "mean T of a pixel's Gaussians"], weight: ["Weight", "S, the sum of the weights"],
  depth: ["Depth", "in world units"], normal: ["Normals", "shortest axes, in world space"],
  gaussians: ["Gaussians", "number in a pixel"], error: ["Error", "difference from the photograph"],
};
const HOVER = 150; // milliseconds that the pointer rests
const SIZES = [[640, 480], [960, 720], [1280, 720], [1920, 1080]];

const scene = await (await fetch("scene.json")).json();
const poses = scene.views.map(({ camera }) => camera.camera_to_world);
let hovering = 0;
const number = new Intl.NumberFormat("en");

// Everything that the image depends on.
const view = {
  scene,
  camera: scene.home,
  center: focusOf(scene.home),
  up: scene.up,
  extent: length(sub(scene.aabb[1], scene.aabb[0])) / 2,
  mode: "color",
  background: null,
  // a view of the data set that the camera has not left
  index: null,
  bitmap: null,

  moved() {
    if (view.index != null) view.leave();
    explain.close();
    view.changed();
  },
  changed() {
    view.depth = null;
    frames.change();
    overlay.draw();
    say();
  },
  // From a camera of the data set to one of the window's size.
  leave() {
    view.index = null;
    view.camera = withSize(view.camera, size());
    if (view.mode === "error") setMode("color", true);
    $("view").value = "";
    compare();
  },
  click: (pixel) => (measure.isOn ? measure.click(pixel) : explain.ask(pixel.map(Math.floor))),
  // Orbit around what is behind a pixel: its depth is the depth of the Gaussian with the largest alpha.
  async focus(pixel) {
    const depth = await explain.depth(pixel.map(Math.floor));
    if (depth) view.center = unproject(view.camera, pixel, depth / scene.placement.scale);
    overlay.ping(view.center);
  },
  // In the mode of depth, the depth where the pointer rests.
  hover(pixel) {
    clearTimeout(hovering);
    view.depth = null;
    if (view.mode !== "depth") return;
    hovering = setTimeout(async () => {
      view.depth = await explain.meanDepth(pixel.map(Math.floor));
      say();
    }, HOVER);
  },
  isHelp: () => $("help").open,
  key,
};

// The place on the camera's axis that is nearest to the middle of the scene.
function focusOf(camera) {
  const eye = eyeOf(camera.camera_to_world), forward = forwardOf(camera.camera_to_world);
  const along = sub(scene.center, eye).reduce((sum, x, i) => sum + x * forward[i], 0);
  const far = along > 0.05 * length(sub(scene.aabb[1], scene.aabb[0])) ? along : length(sub(scene.center, eye)) || 1;
  return add(eye, scale(forward, far));
}

function request() {
  const { camera, mode, background, index } = view;
  return { camera, mode, background, view: mode === "error" ? index : null };
}

const frames = new Frames(request, show, fail);
const overlay = new Overlay($("overlay"), view);
const controls = new Controls($("overlay"), view);
const explain = new Explain(view, overlay);
const keyframes = new Keyframes(view, overlay, frames);
const edit = scene.purpose === "edit" ? new Edit(view, overlay, frames, controls) : null;
const places = scene.scenes > 1 ? new Places(view, overlay, frames, controls) : null;
const measure = new Measure(view, overlay, explain, edit);
const training = scene.purpose === "train" ? new Training(frames) : null;
frames.refines = !training;
frames.idle = say;

function show(bitmap, about, blob, asked) {
  const canvas = $("image"), { w, h } = asked.camera;
  // a smaller image is drawn larger: the canvas keeps the size of the view
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const context = canvas.getContext("2d");
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, 0, 0, w, h);
  bitmap.close();
  view.shown = { about, blob, asked };
  document.documentElement.dataset.quality = about.quality;
  document.documentElement.dataset.sequence = about.sequence;
  place();
  overlay.draw();
  say();
}

function fail(message) {
  // the panel says that the program has ended
  const said = training?.state?.ended ? null : message;
  $("message").hidden = !said;
  $("message").textContent = said ?? "";
}

// What is shown, how fast, and on what.
function say() {
  const about = view.shown?.about;
  if (!about) return;
  const [w, h] = about.size, rate = frames.rate;
  const isBusy = frames.wanted || frames.busy;
  // a scene that is trained changes before it could be refined
  const name = training?.state?.ended ? "ended" : about.quality === "moving" ? "moving" : !frames.refines ? "live" : isBusy || about.quality === "still" ? "refining" : "exact";
  $("quality").textContent = name;
  $("quality").dataset.is = $("quality").textContent;
  const far = farness(view.camera, poses, scene.center);
  $("far").hidden = far <= 1;
  $("frame").style.background = hex(view.background ?? scene.background);
  $("image").style.opacity = view.mode === "color" ? opacityAt(far) : 1;
  // the page draws a small image larger than it is
  const larger = $("image").clientWidth / w;
  const facts = [`${w} × ${h}${larger > 1.5 ? `, enlarged ${larger.toFixed(1)} times` : ""}`, `${about.milliseconds.toFixed(0)} ms`];
  if (view.depth) facts.unshift(`depth ${view.depth.toPrecision(4)}`);
  if (rate) facts.unshift(`${rate.toFixed(rate < 10 ? 1 : 0)} images/s`);
  facts.push(`${number.format(about.pairs)} Gaussians in view`);
  facts.push(about.samples ? `${number.format(about.samples)} samples${about.steps > 1 ? `, steps × ${about.steps}` : ""}${about.renewed < about.pairs ? `, ${Math.round(100 * about.renewed / about.pairs)}% new` : ""}` : "T and colors kept");
  $("numbers").textContent = facts.join(" · ");
  $("facts").textContent = `${number.format(about.gaussians)} Gaussians · ${scene.device}`;
  const range = about.range;
  $("scale").hidden = !range && about.mode !== "normal";
  $("ramp").hidden = !range;
  if (!range) {
    $("low").textContent = "normals: x is red, y green, z blue";
    $("high").textContent = "-1 is dark, 1 bright";
  } else {
    const digits = (value) => (value >= 100 || Number.isInteger(value) ? value.toFixed(0) : value.toPrecision(2));
    $("low").textContent = digits(range[0]);
    $("high").textContent = digits(range[1]);
    const ramp = scene.modes.find(([mode]) => mode === about.mode)[1];
    $("ramp").style.background = `linear-gradient(to right, ${ramp.join(", ")})`;
  }
  $("angle").value = (angleOf(view.camera) * 180) / Math.PI;
  $("angle-value").textContent = `${((angleOf(view.camera) * 180) / Math.PI).toFixed(0)}°`;
}
setInterval(say, 500);

// --- the panel

$("title").textContent = document.title = scene.title;
document.title += " · organza";

for (const [at, [mode]] of scene.modes.entries()) {
  const chip = document.createElement("button");
  chip.textContent = MODES[mode][0];
  chip.title = `${MODES[mode][1]} (${at + 1})`.trim();
  chip.dataset.mode = mode;
  chip.role = "radio";
  chip.onclick = () => setMode(mode);
  if (mode === "error" && !scene.photographs) chip.hidden = true;
  $("modes").append(chip);
}

function setMode(mode, quiet) {
  // an error needs a photograph
  if (mode === "error" && view.index == null) goTo(nearest());
  view.mode = mode;
  for (const chip of $("modes").children) chip.ariaChecked = chip.dataset.mode === mode;
  if (!quiet) view.changed();
}

// The data set's camera that is nearest to where the eye is.
const nearest = () => nearestOf(view.camera, poses, view.extent);

function goTo(index) {
  if (!scene.views[index]) return;
  view.index = index;
  view.camera = scene.views[index].camera;
  view.center = focusOf(view.camera);
  $("view").value = index;
  explain.close();
  compare();
  place();
  view.changed();
}

if (scene.views.length) {
  $("views").hidden = false;
  const held = scene.views.filter((one) => one.held_out).length;
  $("place").textContent = `${scene.views.length}${held ? `, ${held} held out` : ""}`;
  $("view").append(new Option("choose a camera", "", true, true));
  for (const [title, is] of [["Held out", true], ["Training", false]]) {
    const group = document.createElement("optgroup");
    group.label = held ? title : "Cameras";
    for (const [at, one] of scene.views.entries()) if (one.held_out === is) group.append(new Option(one.name, at));
    if (group.children.length) $("view").append(group);
  }
  $("view").onchange = () => $("view").value && goTo(Number($("view").value));
}
const beside = (by) => goTo(view.index == null ? nearest() : (view.index + by + scene.views.length) % scene.views.length);
$("previous").onclick = () => beside(-1);
$("next").onclick = () => beside(1);

// --- the photograph beside the scene

function compare() {
  const shown = $("compare").checked && view.index != null && scene.photographs;
  $("photograph").hidden = $("slider").hidden = !shown;
  if (shown) {
    const source = `photograph/${view.index}`;
    if (!$("photograph").src.endsWith(`/${source}`)) $("photograph").src = source;
  }
  slide();
}
function slide() {
  $("frame").style.setProperty("--at", `${$("slider").value}%`);
}
$("slider").oninput = slide;
$("compare").onchange = () => {
  if ($("compare").checked && view.index == null) goTo(nearest());
  compare();
};
$("compare-label").hidden = !scene.photographs;
$("points-label").hidden = !scene.points;

// --- overlays

for (const [id, name] of [["show-cameras", "cameras"], ["show-points", "points"]]) {
  $(id).onchange = async () => {
    if (name === "points") await overlay.loadPoints();
    overlay[name] = $(id).checked;
    overlay.draw();
  };
}

// --- the lens

$("angle").oninput = () => {
  const camera = withAngle(view.camera, ($("angle").value * Math.PI) / 180);
  if (view.index != null) view.leave();
  view.camera = withAngle(view.camera, angleOf(camera));
  view.changed();
};

$("size").append(new Option("the window's", "window"), new Option("half the window's", "half"));
for (const [w, h] of SIZES) $("size").append(new Option(`${w} × ${h}`, `${w}x${h}`));
function size() {
  const chosen = $("size").value;
  if (chosen.includes("x")) return chosen.split("x").map(Number);
  const box = $("stage").getBoundingClientRect(), part = chosen === "half" ? 2 : 1;
  return [box.width, box.height].map((side) => Math.max(16, Math.min(4096, Math.round(side / part))));
}
$("size").onchange = () => resize();
function resize() {
  if (view.index == null) {
    view.camera = withSize(view.camera, size());
    frames.change();
  }
  place();
  overlay.draw();
}
new ResizeObserver(resize).observe($("stage"));

// The frame is as large as the window allows, with the image's shape.
function place() {
  const { w, h } = view.camera, box = $("stage").getBoundingClientRect();
  const factor = Math.min(box.width / w, box.height / h);
  const style = $("frame").style;
  style.width = `${w * factor}px`;
  style.height = `${h * factor}px`;
  overlay.fit();
}

$("background").value = hex(scene.background);
$("background").oninput = () => {
  view.background = [1, 3, 5].map((at) => parseInt($("background").value.slice(at, at + 2), 16) / 255);
  view.changed();
};
$("background-reset").onclick = () => {
  view.background = null;
  $("background").value = hex(scene.background);
  view.changed();
};

function reset() {
  view.index = null;
  $("view").value = "";
  view.camera = withSize(scene.home, size());
  view.center = focusOf(scene.home);
  if (view.mode === "error") setMode("color", true);
  compare();
  place();
  explain.close();
  view.changed();
}
$("reset").onclick = reset;

$("save-image").onclick = async () => {
  const shown = view.shown;
  if (shown?.about.quality === "exact" && !frames.busy) return download(shown.blob, `${scene.title}.png`);
  try {
    const reply = await post("/frame", { client: 0, sequence: Date.now(), quality: "exact", ...request() });
    download(await reply.blob(), `${scene.title}.png`);
  } catch (error) {
    fail(error.message);
  }
};

// --- keys

$("help-button").onclick = () => $("help").showModal();
function key(event) {
  const modes = [...$("modes").children].filter((chip) => !chip.hidden);
  const act = {
    "?": () => $("help").showModal(), ",": () => beside(-1), ".": () => beside(1), n: () => goTo(nearest()), r: reset,
    c: () => $("show-cameras").click(), o: () => scene.points && $("show-points").click(),
    b: () => edit?.choose("box"), g: () => edit?.choose("brush"), z: () => (places ? places.undo() : edit?.ask("undo")), Delete: () => edit?.ask("remove"),
    m: () => measure.toggle(), k: () => keyframes.add(), p: () => keyframes.toggle(), l: () => { controls.level(); view.moved(); },
    "[": () => { controls.zoom(0.94); view.moved(); }, "]": () => { controls.zoom(1.06); view.moved(); },
    Escape: () => { explain.close(); keyframes.stop(); },
  }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (act) act();
  else if (modes[event.key - 1]) modes[event.key - 1].click();
}

setMode("color", true);
place();
view.camera = withSize(scene.home, size());
frames.settle();
place();
document.documentElement.dataset.ready = "";
Object.assign(window, { organza: { view, frames, keyframes, explain, training, edit, measure, places } });
