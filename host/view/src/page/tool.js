// A tool that takes drags over the image before they move the camera, and its handles.

import { add, dot, project, scale, sub, unproject } from "./camera.js";
import { $ } from "./page.js";

/** @import { Controls } from "./controls.js" */
/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Camera, Pixel, Vector } from "./protocol" */

/** @typedef {{ place: Vector, color: string }} Handle */

const NEAR = 12; // CSS pixels from a handle

export class Tool {
  /** @type {number | null} the index of the handle that is dragged */
  held = null;
  /** @type {Pixel | null} where the pointer is */
  at = null;
  /** @type {Pixel} where it was */
  last = [0, 0];

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   * @param {Controls} controls
   */
  constructor(view, overlay, controls) {
    this.view = view;
    this.overlay = overlay;
    this.controls = controls;
    overlay.tool = this;
    const frame = $("frame");
    frame.addEventListener("pointerdown", (event) => this.down(event), true);
    frame.addEventListener("pointermove", (event) => this.move(event), true);
    frame.addEventListener("pointerup", (event) => this.up(event), true);
    frame.addEventListener("pointercancel", (event) => this.up(event), true);
  }

  /**
   * The handles, in their order.
   * @returns {Handle[]}
   */
  handles() {
    return [];
  }

  /**
   * A handle goes with the pointer.
   * @param {Pixel} _from
   * @param {Pixel} _to
   */
  drag(_from, _to) {}

  /** The drag is over. */
  end() {}

  /**
   * Draws over the image. `unit` is a CSS pixel.
   * @param {CanvasRenderingContext2D} _context
   * @param {Camera} _camera
   * @param {number} _unit
   */
  paint(_context, _camera, _unit) {}

  /** @param {PointerEvent} event */
  down(event) {
    const isForCamera = event.button !== 0 || event.shiftKey || event.altKey || event.ctrlKey;
    if (event.target !== $("overlay") || isForCamera) return;
    this.last = this.controls.pixel(event);
    this.held = this.begin(this.last);
    if (this.held == null) return;
    $("overlay").setPointerCapture(event.pointerId);
    event.stopPropagation();
  }

  /** @param {PointerEvent} event */
  move(event) {
    if (event.target !== $("overlay")) return;
    this.at = this.controls.pixel(event);
    this.overlay.draw();
    if (this.held == null) return;
    event.stopPropagation();
    this.drag(this.last, this.at);
    this.last = this.at;
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (this.held == null) return;
    event.stopPropagation();
    this.held = null;
    this.end();
  }

  /**
   * The index of the handle under the pointer.
   * @param {Pixel} at
   */
  begin(at) {
    const away = (/** @type {Handle} */ { place }) => {
      const [x, y, depth] = project(this.view.camera, place);
      return depth > 0 ? Math.hypot(x - at[0], y - at[1]) : Infinity;
    };
    const all = this.handles().map((handle, index) => [away(handle), index]);
    const [first] = all.sort(([a], [b]) => a - b);
    return first && first[0] <= NEAR * this.overlay.unit ? first[1] : null;
  }

  /**
   * How a place goes with the pointer, in the view plane.
   * @param {Vector} place
   * @param {Pixel} from
   * @param {Pixel} to
   */
  across(place, from, to) {
    const { camera } = this.view;
    const [, , depth] = project(camera, place);
    return sub(unproject(camera, to, depth), unproject(camera, from, depth));
  }

  /**
   * How far it goes with the pointer along a direction of length 1, as seen on the screen.
   * @param {Vector} place
   * @param {Vector} way
   * @param {Pixel} from
   * @param {Pixel} to
   */
  along(place, way, from, to) {
    const { camera } = this.view;
    const [x, y, depth] = project(camera, place);
    const unit = depth / camera.fl_y; // about a pixel
    const [u, v] = project(camera, add(place, scale(way, unit)));
    const seen = [u - x, v - y, 0];
    const square = dot(seen, seen);
    // the direction may point to the eye
    return square < 1e-4 ? 0 : (dot(sub([...to, 0], [...from, 0]), seen) / square) * unit;
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} unit
   */
  paintHandles(context, camera, unit) {
    for (const { place, color } of this.handles()) {
      const [x, y, depth] = project(camera, place);
      if (depth < 0) continue;
      context.beginPath();
      context.arc(x, y, 6 * unit, 0, 7);
      context.fillStyle = color;
      context.fill();
      this.overlay.outlined("#fff", 1.5);
    }
  }
}
