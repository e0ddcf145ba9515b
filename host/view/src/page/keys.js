// What keys do that do not move the camera.

import { $ } from "./page.js";

/** @import { Cameras } from "./cameras.js" */
/** @import { Controls } from "./controls.js" */
/** @import { Edit } from "./edit.js" */
/** @import { Explain } from "./explain.js" */
/** @import { Keyframes } from "./keyframes.js" */
/** @import { Viewed } from "./main.js" */
/** @import { Measure } from "./measure.js" */
/** @import { Modes } from "./modes.js" */
/** @import { Places } from "./places.js" */

/**
 * @typedef {object} Parts The parts of the page that keys reach.
 * @property {Viewed} view
 * @property {Cameras} cameras
 * @property {Controls} controls
 * @property {Edit | null} edit
 * @property {Explain} explain
 * @property {Keyframes} keyframes
 * @property {Measure} measure
 * @property {Modes} modes
 * @property {Places | null} places
 */

/**
 * Does what a key stands for.
 * @param {KeyboardEvent} event
 * @param {Parts} parts
 */
export function press(event, { view, cameras, controls, edit, explain, keyframes, measure, modes, places }) {
  const zoom = (/** @type {number} */ factor) => {
    controls.zoom(factor);
    view.moved();
  };
  const level = () => {
    controls.level();
    view.moved();
  };
  const escape = () => {
    explain.close();
    keyframes.stop();
  };
  /** @type {Record<string, () => void>} */
  const acts = {
    "?": () => $("help").showModal(),
    ",": () => cameras.beside(-1),
    ".": () => cameras.beside(1),
    n: () => view.goTo(cameras.nearest),
    r: () => view.reset(),
    c: () => $("show-cameras").click(),
    o: () => view.scene.points && $("show-points").click(),
    b: () => edit?.choose("box"),
    g: () => edit?.choose("brush"),
    z: () => (places ? places.undo() : edit?.ask("undo")),
    Delete: () => edit?.ask("remove"),
    m: () => measure.toggle(),
    k: () => keyframes.add(),
    p: () => keyframes.toggle(),
    l: level,
    "[": () => zoom(0.94),
    "]": () => zoom(1.06),
    Escape: escape,
  };
  const act = acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (act) act();
  else modes.click(Number(event.key));
}
