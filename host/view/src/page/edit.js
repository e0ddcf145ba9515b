// Removes Gaussians: a box with handles, a brush, a slider for floaters, undo, and save. The program keeps what is left.

import { add, digits, project, scale, sub, toWorld, eyeOf, length } from "./camera.js";
import { post } from "./frames.js";
import { $, css } from "./page.js";
import { Tool } from "./tool.js";

const COLORS = ["#e5484d", "#30a46c", "#3e7bfa"]; // x, y, z
const number = new Intl.NumberFormat("en");

export class Edit extends Tool {
  constructor(view, overlay, frames, controls) {
    super(view, overlay, controls);
    Object.assign(this, { frames, tool: null, places: [], stroke: null });
    $("edit").hidden = false;
    const far = length(sub(view.center, eyeOf(view.camera.camera_to_world))) / 4;
    this.box = [view.center.map((x) => x - far), view.center.map((x) => x + far)];
    for (const tool of ["box", "brush"]) $(`${tool}-tool`).onclick = () => this.choose(tool);
    const crop = (outside) => () => this.ask({ crop: { low: this.box[0], high: this.box[1], outside } });
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

  choose(tool) {
    this.tool = this.tool === tool ? null : tool;
    if (this.tool && this.overlay.measure?.isOn) this.overlay.measure.toggle();
    for (const one of ["box", "brush"]) {
      $(`${one}-tool`).ariaPressed = this.tool === one;
      $(`${one}-actions`).hidden = this.tool !== one;
    }
    this.at = null;
    this.overlay.draw();
  }

  // Asks the program for a change, and shows how things are then. One at a time, in their order.
  ask(request) {
    this.asked = (this.asked ?? Promise.resolve()).then(async () => {
      try {
        const answer = await (await post("/edit", JSON.stringify(request))).json();
        const changed = this.answer && answer.left !== this.answer.left;
        Object.assign(this, { answer, places: answer.places });
        // what was hidden is removed now, or back
        if (request.crop || ["remove", "keep", "undo"].includes(request)) $("clean").value = 0;
        this.sayClean(answer.clean);
        $("left").textContent = `${number.format(answer.left)} left`;
        $("undo-edit").disabled = !answer.removals;
        $("remove-selected").disabled = $("clear-selected").disabled = !answer.selected;
        $("edit-said").textContent = answer.saved ? `Saved as ${answer.saved}`
          : answer.selected ? `${number.format(answer.selected)} selected` : "";
        if (changed) this.frames.settle();
        return true;
      } catch (error) {
        $("edit-said").textContent = error.message;
        return false;
      } finally {
        this.overlay.draw();
      }
    });
    return this.asked;
  }

  // --- floaters: the program looks at one more photograph with each request, and then hides what few of them support

  get strength() {
    return Number($("clean").value);
  }

  async clean() {
    if (this.cleaning) return;
    this.cleaning = true;
    for (let asked = this.strength; await this.ask({ clean: asked }); asked = this.strength) {
      const { seen, views } = this.answer.clean;
      if (asked === this.strength && (seen === views || !asked)) break;
    }
    this.cleaning = false;
  }

  sayClean({ seen, views, hidden, weight }) {
    const share = (100 * weight).toPrecision(2), many = number.format(hidden);
    $("keep-clean").disabled = !hidden;
    $("clean-said").textContent = hidden ? `${many} hidden, ${share}% of the photographs: --clean ${this.strength}`
      : !this.strength ? "" : seen < views ? `Looking at photograph ${seen + 1} of ${views}` : "Nothing to hide";
  }

  // --- the mouse

  begin(at) {
    if (this.tool !== "brush") return super.begin(at);
    this.stroke = [at];
    return 0;
  }

  end() {
    const { camera } = this.view;
    if (this.stroke) this.ask({ paint: { camera, places: this.stroke.slice(0, 1000), radius: this.radius } });
    this.stroke = null;
  }

  // Of the brush, in pixels of the image.
  get radius() {
    return Number($("brush").value) * this.overlay.unit;
  }

  // --- the box: handles in the middle of its faces, and one in its own

  handles() {
    if (this.tool !== "box") return [];
    const middle = scale(add(...this.box), 0.5);
    const face = ([axis, side]) => ({ axis, side, color: COLORS[axis], place: middle.map((x, i) => (i === axis ? this.box[side][i] : x)) });
    const faces = [0, 1, 2].flatMap((axis) => [[axis, 0], [axis, 1]]).map(face);
    return [...faces, { axis: null, color: "#fff", place: middle }];
  }

  // A face goes along its axis.
  drag(from, to) {
    if (this.stroke) {
      if (length(sub(to, this.stroke.at(-1)).concat(0)) > this.radius / 4) this.stroke.push(to);
      return;
    }
    const { axis, side, place } = this.handles()[this.held];
    if (axis == null) {
      const by = this.across(place, from, to);
      this.box = this.box.map((corner) => add(corner, by));
    } else {
      const way = [0, 1, 2].map((other) => Number(other === axis));
      const moved = place[axis] + this.along(place, way, from, to), other = this.box[1 - side][axis];
      this.box[side][axis] = side ? Math.max(moved, other) : Math.min(moved, other);
    }
  }

  // --- over the image

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
    context.arc(...this.at, this.radius, 0, 7);
    this.overlay.outlined("#fff", 1.5);
  }

  paintBox(context, camera, unit) {
    const corner = (bits) => [0, 1, 2].map((axis) => this.box[(bits >> axis) & 1][axis]);
    context.beginPath();
    for (let bits = 0; bits < 8; bits++) {
      for (const axis of [0, 1, 2]) if (!((bits >> axis) & 1)) this.overlay.line(camera, corner(bits), corner(bits | (1 << axis)));
    }
    this.overlay.outlined(css("--path"), 1.5);
    this.paintHandles(context, camera, unit);
    const { placement } = this.view.scene, size = length(sub(...this.box)) * placement.scale;
    const corners = this.box.flatMap((corner) => toWorld(placement, corner));
    $("box-words").textContent = `--box ${corners.map(digits(size)).join(",")}`;
  }
}
