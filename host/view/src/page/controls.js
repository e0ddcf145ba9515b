// Mouse, touch and keys. They change `view.camera` and `view.center`, and call `view.moved()`.

import { add, angleOf, column, cross, dot, eyeOf, forwardOf, length } from "./camera.js";
import { moved, poseOf, rotated, scale, sub, withAngle } from "./camera.js";

/** @import { Camera, Pixel, Pose, Vector } from "./protocol" */

/**
 * @typedef {object} Controlled What the controls change, and tell.
 * @property {Camera} camera
 * @property {Vector} center what the camera goes around
 * @property {Vector} up
 * @property {number} extent half the size of the scene
 * @property {() => void} moved
 * @property {(pixel: Pixel) => void} click
 * @property {(pixel: Pixel) => void} focus
 * @property {(pixel: Pixel) => void} [hover]
 * @property {() => boolean} [leavesWheel] whether the wheel is for another page
 * @property {() => boolean} isHelp whether the help is open
 * @property {(event: KeyboardEvent) => void} key
 */

const CLICK = 4; // pixels that a click may move
/** @type {Record<string, Vector>} */
const FLY = {
  KeyW: [0, 0, 1], KeyS: [0, 0, -1], KeyA: [-1, 0, 0], KeyD: [1, 0, 0], KeyE: [0, 1, 0], KeyQ: [0, -1, 0],
};

export class Controls {
  /** @type {Map<number, Pixel>} where pointers are that are down */
  pointers = new Map();
  /** @type {Set<string>} that are held */
  keys = new Set();
  fast = false;
  /** How far the pointer went since it is down. */
  travelled = 0;
  last = 0;

  /**
   * @param {HTMLElement} element
   * @param {Controlled} view
   */
  constructor(element, view) {
    this.element = element;
    this.view = view;
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerup", (event) => this.up(event));
    element.addEventListener("pointercancel", (event) => this.up(event));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("dblclick", (event) => view.focus(this.pixel(event)));
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    addEventListener("keydown", (event) => this.key(event));
    addEventListener("keyup", (event) => this.keys.delete(event.code));
    addEventListener("blur", () => this.keys.clear());
  }

  /**
   * The pixel of the image under the pointer.
   * @param {MouseEvent} event
   * @returns {Pixel}
   */
  pixel(event) {
    const box = this.element.getBoundingClientRect();
    const { w, h } = this.view.camera;
    return [((event.clientX - box.left) / box.width) * w, ((event.clientY - box.top) / box.height) * h];
  }

  /** @param {PointerEvent} event */
  down(event) {
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    this.travelled = this.pointers.size > 1 ? Infinity : 0;
    this.element.focus({ preventScroll: true });
  }

  /** @param {PointerEvent} event */
  up(event) {
    const known = this.pointers.delete(event.pointerId);
    if (known && event.type === "pointerup" && event.button === 0 && this.travelled < CLICK) {
      this.view.click(this.pixel(event));
    }
  }

  /** @param {PointerEvent} event */
  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return this.view.hover?.(this.pixel(event));
    const after = [event.clientX, event.clientY];
    const [dx, dy] = sub(after, before);
    this.travelled += Math.hypot(dx, dy);
    if (this.travelled < CLICK) return;
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    this.pointers.set(event.pointerId, after);
    if (others.length > 0) {
      const [other] = others;
      const apart = (/** @type {Pixel} */ place) => Math.hypot(...sub(place, other)) || 1;
      this.pan(dx / 2, dy / 2);
      this.dolly(apart(before) / apart(after));
    } else if (event.buttons & 6 || event.shiftKey) this.pan(dx, dy);
    else if (event.altKey || event.ctrlKey || event.metaKey) this.look(dx, dy);
    else this.orbit(dx, dy);
    this.view.moved();
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    if (this.view.leavesWheel?.()) return;
    event.preventDefault();
    const amount = Math.max(-240, Math.min(240, event.deltaY * (event.deltaMode === 1 ? 30 : 1)));
    if (event.ctrlKey || event.altKey) this.zoom(Math.exp(amount * 0.001));
    else this.dolly(Math.exp(amount * 0.0012));
    this.view.moved();
  }

  /** @param {Pose} pose */
  set pose(pose) {
    this.view.camera = { ...this.view.camera, camera_to_world: pose };
  }

  get pose() {
    return this.view.camera.camera_to_world;
  }

  /** World units of a CSS pixel at the center's distance. */
  get pixelSize() {
    const box = this.element.getBoundingClientRect();
    const { camera, center } = this.view;
    return (length(sub(center, eyeOf(this.pose))) * camera.h) / camera.fl_y / box.height;
  }

  /**
   * Around the center. Never over the poles.
   * @param {number} dx
   * @param {number} dy
   */
  orbit(dx, dy) {
    const { up, center } = this.view;
    const around = rotated(this.pose, up, -dx * 0.006, center);
    this.pose = this.tilted(around, -dy * 0.006, center);
  }

  /**
   * The eye stays where it is.
   * @param {number} dx
   * @param {number} dy
   */
  look(dx, dy) {
    const box = this.element.getBoundingClientRect();
    const angle = angleOf(this.view.camera) / box.height;
    const eye = eyeOf(this.pose);
    const far = length(sub(this.view.center, eye));
    this.pose = this.tilted(rotated(this.pose, this.view.up, dx * angle, eye), dy * angle, eye);
    this.view.center = add(eye, scale(forwardOf(this.pose), far));
  }

  /**
   * @param {Pose} pose
   * @param {number} angle
   * @param {Vector} place
   */
  tilted(pose, angle, place) {
    const after = rotated(pose, column(pose, 0), angle, place);
    return Math.abs(dot(forwardOf(after), this.view.up)) < 0.995 ? after : pose;
  }

  /**
   * @param {number} dx
   * @param {number} dy
   */
  pan(dx, dy) {
    const size = this.pixelSize;
    const by = add(scale(column(this.pose, 0), -dx * size), scale(column(this.pose, 1), dy * size));
    this.pose = moved(this.pose, by);
    this.view.center = add(this.view.center, by);
  }

  /**
   * Nearer to the center, or farther away.
   * @param {number} factor
   */
  dolly(factor) {
    const eye = eyeOf(this.pose);
    this.pose = moved(this.pose, scale(sub(eye, this.view.center), factor - 1));
  }

  /** @param {number} factor */
  zoom(factor) {
    const angle = Math.min(2.4, Math.max(0.03, angleOf(this.view.camera) * factor));
    this.view.camera = withAngle(this.view.camera, angle);
  }

  /** The image's horizon becomes level. */
  level() {
    const back = column(this.pose, 2);
    this.pose = poseOf(cross(this.view.up, back), back, eyeOf(this.pose));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    // a box or a slider takes no letters
    const types = "select, textarea, input:not([type=checkbox], [type=range], [type=color])";
    const isTyped = event.target instanceof Element && event.target.matches(types);
    if (isTyped || event.ctrlKey || event.metaKey || event.altKey) return;
    if (FLY[event.code] && !this.view.isHelp()) {
      event.preventDefault();
      if (this.keys.size === 0) {
        requestAnimationFrame((now) => {
          this.last = now; // of the frame: what the clock says is later, and the first step would go backward
          this.fly(now);
        });
      }
      this.keys.add(event.code);
      this.fast = event.shiftKey;
    } else this.view.key(event);
  }

  /**
   * Along the camera's axes while keys are held.
   * @param {number} now
   */
  fly(now) {
    if (this.keys.size === 0) return;
    const seconds = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    const [x, y, z] = [...this.keys].map((code) => FLY[code]).reduce(add, [0, 0, 0]);
    const speed = this.view.extent * (this.fast ? 1.5 : 0.4) * seconds;
    const sideways = add(scale(column(this.pose, 0), x), scale(column(this.pose, 1), y));
    const by = scale(add(sideways, scale(forwardOf(this.pose), z)), speed);
    this.pose = moved(this.pose, by);
    this.view.center = add(this.view.center, by);
    this.view.moved();
    requestAnimationFrame((then) => this.fly(then));
  }
}
