// The distance between two places, by two clicks. A known distance gives the scene meters.

import { length, project, sub, unproject } from "./camera.js";
import { $, css } from "./page.js";

/** @import { Edit } from "./edit.js" */
/** @import { Explain } from "./explain.js" */
/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Camera, Pixel, Vector } from "./protocol" */

export class Measure {
  isOn = false;
  /** @type {Vector[]} the ends of the line */
  places = [];

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   * @param {Explain} explain
   * @param {Edit | null} edit
   */
  constructor(view, overlay, explain, edit) {
    this.view = view;
    this.overlay = overlay;
    this.explain = explain;
    this.edit = edit;
    overlay.measure = this;
    $("measure").hidden = view.scene.scenes > 1;
    $("measure").onclick = () => this.toggle();
    $("meters").oninput = () => this.say();
    $("set-meters").hidden = !edit;
    $("set-meters").onclick = () => this.keep();
  }

  toggle() {
    this.isOn = !this.isOn;
    this.places = [];
    // a tool would take the clicks
    if (this.isOn && this.edit?.tool) this.edit.choose(this.edit.tool);
    $("measure").ariaPressed = String(this.isOn);
    $("measured").hidden = !this.isOn;
    this.say();
    this.overlay.draw();
  }

  /**
   * An end of the line. A third click begins a new line.
   * @param {Pixel} pixel
   */
  async click(pixel) {
    const { camera, scene } = this.view;
    const depth = await this.explain.depth(pixel.map(Math.floor));
    if (!this.isOn) return;
    if (this.places.length === 2) this.places = [];
    if (depth) this.places.push(unproject(camera, pixel, depth / scene.placement.scale));
    this.say(depth ? null : "Nothing is there.");
    this.overlay.draw();
  }

  /** Between the two places, in world units; null where they are not two. */
  get distance() {
    const [a, b] = this.places;
    return b ? length(sub(a, b)) * this.view.scene.placement.scale : null;
  }

  /** Meters in one world unit, by what the user has typed. */
  get meters() {
    const typed = Number($("meters").value);
    return this.distance && typed > 0 ? typed / this.distance : null;
  }

  /** What there is to do, or the distance. */
  get said() {
    const { distance, places } = this;
    const { placement } = this.view.scene;
    if (!distance) return places.length ? "Click the other end." : "Click two places.";
    return placement.meters
      ? `${(distance * placement.meters).toPrecision(4)} m`
      : `${distance.toPrecision(4)} world units`;
  }

  /** @param {string | null} problem */
  say(problem = null) {
    const { meters } = this;
    $("distance").textContent = problem ?? this.said;
    $("known").hidden = !this.distance;
    $("set-meters").disabled = !meters;
    const command = meters && !this.edit ? `organza edit … --scale ${meters.toPrecision(4)}` : "";
    $("measure-words").textContent = command;
  }

  // The scene that is saved then has meters.
  async keep() {
    const { meters } = this;
    if (!meters) return;
    await this.edit?.ask({ meters });
    this.view.scene.placement.meters = meters;
    $("meters").value = "";
    this.say();
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} unit
   */
  paint(context, camera, unit) {
    const [a, b] = this.places;
    if (b) {
      context.beginPath();
      this.overlay.line(camera, a, b);
      this.overlay.outlined(css("--path"), 2);
    }
    for (const place of this.places) {
      const [x, y, depth] = project(camera, place);
      if (depth < 0) continue;
      context.beginPath();
      context.arc(x, y, 4 * unit, 0, 7);
      this.overlay.outlined("#fff", 2);
    }
  }
}
