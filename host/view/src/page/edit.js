// Removes Gaussians: a box with handles, a brush, a slider for floaters, undo, and save. The program keeps
// what is left.

import { add, digits, project, scale, sub, toWorld, eyeOf, length } from "./camera.js";
import { post } from "./frames.js";
import { $, css, reason } from "./page.js";
import { Tool } from "./tool.js";

/** @import { Controls } from "./controls.js" */
/** @import { Frames } from "./frames.js" */
/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Camera, Clean, EditAnswer, EditRequest, Pixel, Vector } from "./protocol" */

// The middle has no axis.
/** @typedef {{ axis: number | null, side: number, color: string, place: Vector }} Face */

const COLORS = ["#e5484d", "#30a46c", "#3e7bfa"]; // x, y, z
const number = new Intl.NumberFormat("en");

const REMOVALS = ["remove", "keep", "undo"];
const TOOLS = /** @type {const} */ (["box", "brush"]);

export class Edit extends Tool {
  /** @type {"box" | "brush" | null} */
  tool = null;
  /** @type {Vector[]} of selected Gaussians */
  places = [];
  /** @type {Pixel[] | null} of the brush */
  stroke = null;
  /** @type {EditAnswer | null} */
  answer = null;
  /** @type {Promise<boolean>} the last request */
  asked = Promise.resolve(true);
  cleaning = false;

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   * @param {Frames} frames
   * @param {Controls} controls
   */
  constructor(view, overlay, frames, controls) {
    super(view, overlay, controls);
    this.frames = frames;
    $("edit").hidden = false;
    const far = length(sub(view.center, eyeOf(view.camera.camera_to_world))) / 4;
    this.box = [view.center.map((x) => x - far), view.center.map((x) => x + far)];
    for (const tool of TOOLS) $(`${tool}-tool`).onclick = () => this.choose(tool);
    const crop = (/** @type {boolean} */ outside) => () => {
      const [low, high] = this.box;
      this.ask({ crop: { low, high, outside } });
    };
    $("remove-outside").onclick = crop(true);
    $("remove-inside").onclick = crop(false);
    $("remove-selected").onclick = () => this.ask("remove");
    $("clear-selected").onclick = () => this.ask("clear");
    $("undo-edit").onclick = () => this.ask("undo");
    $("save-edit").onclick = () => this.ask("save");
    $("clean-field").hidden = !view.scene.views.length;
    $("clean").oninput = () => this.clean();
    $("keep-clean").onclick = () => this.ask("keep");
    $("brush").oninput = () => overlay.draw();
    this.ask("look");
  }

  /** @param {"box" | "brush"} tool */
  choose(tool) {
    this.tool = this.tool === tool ? null : tool;
    if (this.tool && this.overlay.measure?.isOn) this.overlay.measure.toggle();
    for (const one of TOOLS) {
      $(`${one}-tool`).ariaPressed = String(this.tool === one);
      $(`${one}-actions`).hidden = this.tool !== one;
    }
    this.at = null;
    this.overlay.draw();
  }

  /**
   * Asks the program for a change, and shows how things are then. One at a time, in their order.
   * @param {EditRequest} request
   */
  ask(request) {
    this.asked = this.asked.then(async () => {
      try {
        /** @type {EditAnswer} */
        const answer = await (await post("/edit", JSON.stringify(request))).json();
        const changed = this.answer && answer.left !== this.answer.left;
        this.answer = answer;
        this.places = answer.places;
        // what was hidden is removed now, or back
        const isNamed = typeof request === "string";
        if (isNamed ? REMOVALS.includes(request) : "crop" in request) $("clean").value = "0";
        this.say(answer);
        if (changed) this.frames.settle();
        return true;
      } catch (error) {
        $("edit-said").textContent = reason(error);
        return false;
      } finally {
        this.overlay.draw();
      }
    });
    return this.asked;
  }

  /** @param {EditAnswer} answer */
  say(answer) {
    this.sayClean(answer.clean);
    $("left").textContent = `${number.format(answer.left)} left`;
    $("undo-edit").disabled = !answer.removals;
    $("remove-selected").disabled = $("clear-selected").disabled = !answer.selected;
    const selected = answer.selected ? `${number.format(answer.selected)} selected` : "";
    $("edit-said").textContent = answer.saved ? `Saved as ${answer.saved}` : selected;
  }

  // --- floaters: the program looks at one more photograph with each request, and then hides what most of them
  // see through

  get strength() {
    return Number($("clean").value);
  }

  async clean() {
    if (this.cleaning) return;
    this.cleaning = true;
    for (let asked = this.strength; await this.ask({ clean: asked }); asked = this.strength) {
      const { seen, views } = /** @type {EditAnswer} */ (this.answer).clean;
      if (asked === this.strength && (seen === views || !asked)) break;
    }
    this.cleaning = false;
  }

  /** @param {Clean} clean */
  sayClean({ seen, views, hidden, weight }) {
    const share = (100 * weight).toPrecision(2);
    $("keep-clean").disabled = !hidden;
    const looking = seen < views ? `Looking at photograph ${seen + 1} of ${views}` : "Nothing to hide";
    const found = `${number.format(hidden)} hidden, ${share}% of the photographs: --clean ${this.strength}`;
    $("clean-said").textContent = hidden ? found : this.strength ? looking : "";
  }

  // --- the mouse

  /** @param {Pixel} at */
  begin(at) {
    if (this.tool !== "brush") return super.begin(at);
    this.stroke = [at];
    return 0;
  }

  end() {
    const { camera } = this.view;
    const places = this.stroke?.slice(0, 1000);
    if (places) this.ask({ paint: { camera, places, radius: this.radius } });
    this.stroke = null;
  }

  // Of the brush, in pixels of the image.
  get radius() {
    return Number($("brush").value) * this.overlay.unit;
  }

  // --- the box: handles in the middle of its faces, and one in its own

  /** @returns {Face[]} */
  handles() {
    if (this.tool !== "box") return [];
    const [low, high] = this.box;
    const middle = scale(add(low, high), 0.5);
    const face = (/** @type {number} */ axis, /** @type {number} */ side) => {
      const place = middle.map((x, i) => (i === axis ? this.box[side][i] : x));
      return { axis, side, color: COLORS[axis], place };
    };
    const faces = [0, 1, 2].flatMap((axis) => [face(axis, 0), face(axis, 1)]);
    return [...faces, { axis: null, side: 0, color: "#fff", place: middle }];
  }

  /**
   * A face goes along its axis.
   * @param {Pixel} from
   * @param {Pixel} to
   */
  drag(from, to) {
    const before = this.stroke?.at(-1);
    if (before) {
      if (Math.hypot(to[0] - before[0], to[1] - before[1]) > this.radius / 4) this.stroke?.push(to);
      return;
    }
    const { axis, side, place } = this.handles()[this.held ?? 0];
    if (axis == null) {
      const by = this.across(place, from, to);
      this.box = this.box.map((corner) => add(corner, by));
    } else {
      const way = [0, 1, 2].map((other) => Number(other === axis));
      const moved = place[axis] + this.along(place, way, from, to);
      const other = this.box[1 - side][axis];
      this.box[side][axis] = side ? Math.max(moved, other) : Math.min(moved, other);
    }
  }

  // --- over the image

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} unit
   */
  paint(context, camera, unit) {
    context.fillStyle = css("--path");
    for (const place of this.places) {
      const [x, y, depth] = project(camera, place);
      if (depth > 0) context.fillRect(x - 1.5 * unit, y - 1.5 * unit, 3 * unit, 3 * unit);
    }
    if (this.tool === "box") this.paintBox(context, camera, unit);
    if (this.tool !== "brush") return;
    context.beginPath();
    for (const [x, y] of this.stroke ?? []) context.lineTo(x, y);
    context.strokeStyle = "rgb(255 122 184 / 40%)";
    context.lineWidth = 2 * this.radius;
    context.stroke();
    if (!this.at) return;
    context.beginPath();
    context.arc(this.at[0], this.at[1], this.radius, 0, 7);
    this.overlay.outlined("#fff", 1.5);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} unit
   */
  paintBox(context, camera, unit) {
    /** @type {(bits: number) => Vector} */
    const corner = (bits) => [0, 1, 2].map((axis) => this.box[(bits >> axis) & 1][axis]);
    context.beginPath();
    for (let bits = 0; bits < 8; bits++) {
      for (const axis of [0, 1, 2]) {
        if (!((bits >> axis) & 1)) this.overlay.line(camera, corner(bits), corner(bits | (1 << axis)));
      }
    }
    this.overlay.outlined(css("--path"), 1.5);
    this.paintHandles(context, camera, unit);
    const { placement } = this.view.scene;
    const [low, high] = this.box;
    const size = length(sub(low, high)) * placement.scale;
    const corners = this.box.flatMap((corner) => toWorld(placement, corner));
    $("box-words").textContent = `--box ${corners.map(digits(size)).join(",")}`;
  }
}
