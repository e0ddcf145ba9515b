// The slow turn around the scene, until the visitor touches the page.

import { add, cross, eyeOf, poseOf, scale, sub } from "./camera.js";

/** @import { Camera, Vector } from "../../page/protocol" */
/** @import { Header } from "./types" */

const TURN = 80; // seconds of a turn
const LEAVE = 6; // seconds until it has left the first view

/** @type {(from: Vector, to: Vector, part: number) => Vector} */
const mix = (from, to, part) => add(from, scale(sub(to, from), part));

/** @typedef {{ camera: Camera, center: Vector }} Look A camera, and what it goes around. */

/**
 * What is looked at on the way, `part` of a turn from its begin.
 * @param {Header} header
 * @param {Camera} camera whose lens it is
 * @param {number} part
 * @param {{ eye: Vector, center: Vector, left: number }} [first] where it came from
 * @returns {Look}
 */
export function lookAt({ way, center: middle, up }, camera, part, first) {
  const at = part * way.length;
  const index = Math.floor(at);
  const there = mix(way[index % way.length], way[(index + 1) % way.length], at - index);
  const isLeaving = first && first.left < 1;
  const eye = isLeaving ? mix(first.eye, there, first.left) : there;
  const center = isLeaving ? mix(first.center, middle, first.left) : middle;
  const back = sub(eye, center);
  return { camera: { ...camera, camera_to_world: poseOf(cross(up, back), back, eye) }, center };
}

/**
 * Turns until `step` gives false for a frame.
 * @param {Header} header
 * @param {Look} begin
 * @param {(look: (camera: Camera) => Look) => boolean} step is called with what is looked at next
 */
export function turn(header, { camera, center }, step) {
  let last = performance.now();
  let seconds = 0;
  const eye = eyeOf(camera.camera_to_world);
  const frame = (/** @type {number} */ now) => {
    const since = seconds + Math.max(0, Math.min(0.1, (now - last) / 1000));
    last = now;
    const part = Math.min(1, since / LEAVE);
    const first = { eye, center, left: part * part * (3 - 2 * part) };
    if (!step((own) => lookAt(header, own, (since / TURN) % 1, first))) return;
    seconds = since;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
