// A tool that takes drags over the image before they move the camera, and its handles.

import { add, dot, project, scale, sub, unproject } from "./camera.js";
import { $ } from "./page.js";

const NEAR = 12; // CSS pixels from a handle

export class Tool {
  constructor(view, overlay, controls) {
    Object.assign(this, { view, overlay, controls, held: null, at: null });
    overlay.tool = this;
    const frame = $("frame"), on = (name, handler) => frame.addEventListener(name, handler.bind(this), true);
    on("pointerdown", this.down);
    on("pointermove", this.move);
    on("pointerup", this.up);
    on("pointercancel", this.up);
  }

  down(event) {
    if (event.target.id !== "overlay" || event.button !== 0 || event.shiftKey || event.altKey || event.ctrlKey) return;
    this.last = this.controls.pixel(event);
    this.held = this.begin(this.last);
    if (this.held == null) return;
    $("overlay").setPointerCapture(event.pointerId);
    event.stopPropagation();
  }

  move(event) {
    if (event.target.id !== "overlay") return;
    this.at = this.controls.pixel(event);
    this.overlay.draw();
    if (this.held == null) return;
    event.stopPropagation();
    this.drag(this.last, this.at);
    this.last = this.at;
  }

  up(event) {
    if (this.held == null) return;
    event.stopPropagation();
    this.held = null;
    this.end?.();
  }

  // The index of the handle under the pointer.
  begin(at) {
    const away = ({ place }) => {
      const [x, y, depth] = project(this.view.camera, place);
      return depth > 0 ? Math.hypot(x - at[0], y - at[1]) : Infinity;
    };
    const [first] = this.handles().map((handle, index) => [away(handle), index]).sort(([a], [b]) => a - b);
    return first?.[0] <= NEAR * this.overlay.unit ? first[1] : null;
  }

  // How a place goes with the pointer, in the view plane.
  across(place, from, to) {
    const { camera } = this.view, [, , depth] = project(camera, place);
    return sub(unproject(camera, to, depth), unproject(camera, from, depth));
  }

  // How far it goes with the pointer along a direction of length 1, as seen on the screen.
  along(place, way, from, to) {
    const { camera } = this.view, [x, y, depth] = project(camera, place), unit = depth / camera.fl_y; // about a pixel
    const [u, v] = project(camera, add(place, scale(way, unit)));
    const seen = [u - x, v - y, 0], square = dot(seen, seen);
    // the direction may point to the eye
    return square < 1e-4 ? 0 : (dot(sub([...to, 0], [...from, 0]), seen) / square) * unit;
  }

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
