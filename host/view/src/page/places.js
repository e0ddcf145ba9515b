// Moves a scene that is shown with the first one, by handles. The program puts it there, and images follow.

import { add, column, cross, digits, dot, length, normalize, scale, sub, toWorld, turned } from "./camera.js";
import { post } from "./frames.js";
import { $, css, download, reason } from "./page.js";
import { Tool } from "./tool.js";

/** @import { Controls } from "./controls.js" */
/** @import { Frames } from "./frames.js" */
/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Camera, Pixel, Place, PlacedScene, PlaceRequest, Vector } from "./protocol" */

/** @typedef {"move" | "lift" | "turn" | "size"} Kind */
/** @typedef {{ kind: Kind, way: Vector, color: string, place: Vector }} Handle It is dragged along `way`. */

const UP = [0, 0, 1]; // a scene stands upright in its own coordinates
const COLORS = { move: "#fff", lift: "#3e7bfa", turn: "#f0a020", size: "#30a46c" };

export class Places extends Tool {
  /** @type {PlacedScene[]} */
  scenes = [];
  /** @type {PlaceRequest[]} for undo, the last one last */
  before = [];
  /** @type {PlaceRequest | null} */
  newest = null;
  /** @type {Promise<void>} the last request */
  asked = Promise.resolve();
  /** Whether the drag can be undone. */
  isKept = false;

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   * @param {Frames} frames
   * @param {Controls} controls
   */
  constructor(view, overlay, frames, controls) {
    super(view, overlay, controls);
    this.frames = frames;
    $("places").hidden = false;
    $("scene").onchange = () => this.show();
    $("place-words").onchange = () => this.type();
    $("undo-place").onclick = () => this.undo();
    $("save-place").onclick = () => {
      const name = this.scene?.name.replace(/\.\w+$/, "");
      download(new Blob([$("place-words").value]), `${name}.json`);
    };
    this.ask(null);
  }

  /** The number of the chosen scene: 0, which stays, is none. */
  get index() {
    return Number($("scene").value);
  }

  /** @returns {PlacedScene | undefined} */
  get scene() {
    return this.scenes[this.index - 1];
  }

  /**
   * Puts a scene at a place; with null, asks where all are. One at a time, in their order.
   * @param {PlaceRequest | null} request
   */
  ask(request) {
    this.newest = request;
    this.asked = this.asked.then(async () => {
      // the newest place of a scene is enough
      if (this.newest !== request && this.newest?.scene === request?.scene) return;
      try {
        /** @type {PlacedScene[]} */
        const scenes = await (await post("/places", JSON.stringify(request))).json();
        if (this.newest === request) this.scenes = scenes;
        if (request) $("place-said").textContent = "";
      } catch (error) {
        $("place-said").textContent = reason(error);
        if (request) this.ask(null);
      }
      if (request) this.frames.change();
      this.show();
    });
    return this.asked;
  }

  /**
   * A new place of the chosen scene.
   * @param {Place} place
   */
  put(place) {
    if (this.scene) this.scene.place = place;
    this.ask({ scene: this.index, place });
  }

  /** For undo. */
  keep() {
    if (this.scene) this.before.push({ scene: this.index, place: this.scene.place });
  }

  undo() {
    const last = this.before.pop();
    if (!last) return;
    $("scene").value = String(last.scene);
    this.ask(last);
  }

  // The user has written a place.
  type() {
    try {
      const place = JSON.parse($("place-words").value);
      this.keep();
      this.put(place);
    } catch (error) {
      $("place-said").textContent = reason(error);
    }
  }

  show() {
    if ($("scene").options.length <= this.scenes.length) {
      const named = this.scenes.map(({ name }, at) => new Option(name, String(at + 1)));
      $("scene").replaceChildren(new Option("choose a scene to move", "0"), ...named);
    }
    const { scene } = this;
    $("place-words").value = scene ? JSON.stringify(scene.place) : "";
    $("place-words").disabled = $("save-place").disabled = !scene;
    $("undo-place").disabled = !this.before.length;
    this.overlay.draw();
  }

  // --- handles: in its middle, above, in front, and to the right

  /** @returns {Handle[]} */
  handles() {
    if (!this.scene) return [];
    const { center, radius } = this.scene;
    const right = column(this.view.camera.camera_to_world, 0);
    const front = normalize(cross(right, UP));
    /** @type {(kind: Kind, from: Vector, way: Vector) => Handle} */
    const handle = (kind, from, way) => {
      return { kind, way, color: COLORS[kind], place: add(center, scale(from, radius)) };
    };
    return [
      handle("move", [0, 0, 0], [0, 0, 0]), handle("lift", UP, UP),
      handle("turn", front, cross(UP, front)), handle("size", right, right),
    ];
  }

  /** @param {Pixel} at */
  begin(at) {
    this.isKept = false;
    return super.begin(at);
  }

  /**
   * @param {Pixel} from
   * @param {Pixel} to
   */
  drag(from, to) {
    const { kind, place, way } = this.handles()[this.held ?? 0];
    const radius = this.scene?.radius ?? 1;
    if (!this.isKept) this.keep();
    this.isKept = true;
    if (kind === "move") return this.change({ by: this.across(place, from, to) });
    const far = this.along(place, way, from, to);
    if (kind === "lift") this.change({ by: scale(UP, far) });
    else if (kind === "turn") this.change({ angle: far / radius });
    else this.change({ factor: Math.max(0.1, 1 + far / radius) });
  }

  /**
   * Moves the scene, turns it upright around its middle, and scales it there.
   * @param {{ by?: Vector, angle?: number, factor?: number }} change
   */
  change({ by = [0, 0, 0], angle = 0, factor = 1 }) {
    if (!this.scene) return;
    const { center, radius, place } = this.scene;
    const { placement } = this.view.scene;
    const world = (/** @type {Vector} */ own) => toWorld(placement, own);
    const arm = scale(turned(sub(place.offset, world(center)), placement.up, angle), factor);
    const after = { center: add(center, by), radius: radius * factor };
    Object.assign(this.scene, after);
    this.put({
      ...place,
      offset: add(world(after.center), arm).map(digits(after.radius * placement.scale * 0.01)),
      turn: angle ? followed(place.turn, placement.up, angle).map(digits(10)) : place.turn,
      scale: factor === 1 ? place.scale : Number((place.scale * factor).toPrecision(5)),
    });
  }

  // --- over the image

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} unit
   */
  paint(context, camera, unit) {
    if (!this.scene) return;
    const { center, radius } = this.scene;
    const at = (/** @type {number} */ step) => {
      const angle = (step * Math.PI) / 24;
      return add(center, [radius * Math.cos(angle), radius * Math.sin(angle), 0]);
    };
    context.beginPath();
    for (let step = 0; step < 48; step++) this.overlay.line(camera, at(step), at(step + 1));
    for (const { kind, place } of this.handles()) {
      if (kind !== "turn") this.overlay.line(camera, center, place);
    }
    this.overlay.outlined(css("--path"), 1.5);
    this.paintHandles(context, camera, unit);
  }
}

/**
 * A turn, as an axis by its length in degrees, and then another one: the product of their quaternions.
 * @param {Vector} turn
 * @param {Vector} axis
 * @param {number} angle
 */
export function followed(turn, axis, angle) {
  const half = (length(turn) * Math.PI) / 360;
  const v = scale(normalize(turn), Math.sin(half));
  const w = Math.cos(half);
  const a = scale(axis, Math.sin(angle / 2));
  const c = Math.cos(angle / 2);
  const both = add(add(scale(v, c), scale(a, w)), cross(a, v));
  const real = c * w - dot(a, v);
  const short = real < 0 ? -1 : 1;
  return scale(normalize(both), (short * Math.atan2(length(both), short * real) * 360) / Math.PI);
}
