// Keyframes: views that are kept, and the path through them.

import { post } from "./frames.js";
import { $, brush, download, element, reason, tell } from "./page.js";
import { withSize } from "./camera.js";

/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Camera, Cameras, PathRequest } from "./protocol" */

/** @typedef {{ camera: Camera, picture: string }} Keyframe A view, and the address of its picture. */

const RATE = 30; // cameras a second of a path

export class Keyframes {
  /** @type {Keyframe[]} */
  list = [];
  /** @type {number | null} the index of a keyframe */
  chosen = null;
  /** @type {object | null} what the last call of `play` has made */
  playing = null;
  /** @type {Camera[]} along the path */
  path = [];
  /** @type {PathRequest | null} the last one */
  newest = null;

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   */
  constructor(view, overlay) {
    this.view = view;
    this.overlay = overlay;
    $("add-keyframe").onclick = () => this.add();
    $("play").onclick = () => this.toggle();
    $("save-keyframes").onclick = () => this.save();
    $("load-keyframes").onclick = () => $("keyframes-file").click();
    $("keyframes-file").onchange = async () => {
      const file = $("keyframes-file").files?.[0];
      if (file) await this.load(await file.text());
      $("keyframes-file").value = "";
    };
    $("loop").onchange = $("pace").onchange = () => this.changed();
  }

  /** A small picture of what is shown now. */
  picture() {
    const canvas = element("canvas", { width: 96, height: 64 });
    const image = $("image");
    const factor = Math.max(96 / image.width, 64 / image.height);
    const w = image.width * factor;
    const h = image.height * factor;
    brush(canvas).drawImage(image, (96 - w) / 2, (64 - h) / 2, w, h);
    return canvas.toDataURL("image/jpeg", 0.8);
  }

  add() {
    const at = this.chosen == null ? this.list.length : this.chosen + 1;
    this.list.splice(at, 0, { camera: this.view.camera, picture: this.picture() });
    this.chosen = at === this.list.length - 1 ? null : at;
    this.changed();
  }

  changed() {
    this.stop();
    const items = this.list.map((one, at) => this.item(one, at));
    $("keyframes").replaceChildren(...items);
    $("no-keyframes").hidden = this.list.length > 0;
    $("save-keyframes").disabled = this.list.length === 0;
    $("play").disabled = this.list.length < 2;
    const parts = this.list.length - ($("loop").checked ? 0 : 1);
    $("length").textContent = this.list.length > 1 ? `${(parts * this.pace).toFixed(1)} s` : "";
    this.overlay.keyframes = this.list;
    this.overlay.path = [];
    this.overlay.draw();
    this.fetchPath();
  }

  /** Seconds from a keyframe to the next one. */
  get pace() {
    return Math.min(60, Math.max(0.2, Number($("pace").value) || 2));
  }

  /**
   * @param {Keyframe} one
   * @param {number} at
   */
  item(one, at) {
    const picture = element("img", { src: one.picture, alt: "" });
    const go = element("button", { className: "go", title: `Go to keyframe ${at + 1}` }, picture);
    go.onclick = () => this.go(at);
    /** @type {(text: string, title: string, action: () => void, disabled?: boolean) => HTMLElement} */
    const act = (text, title, action, disabled = false) => {
      const button = element("button", { title, disabled, ariaLabel: title }, text);
      button.onclick = action;
      return button;
    };
    const swap = (/** @type {number} */ by) => () => {
      [this.list[at], this.list[at + by]] = [this.list[at + by], this.list[at]];
      this.chosen = at + by;
      this.changed();
    };
    const actions = element(
      "span", { className: "actions" },
      act("‹", "Earlier", swap(-1), at === 0),
      act("↻", "Put the view there that is shown now", () => this.replace(at)),
      act("×", "Remove", () => this.remove(at)),
      act("›", "Later", swap(1), at === this.list.length - 1),
    );
    return element("li", { className: at === this.chosen ? "chosen" : "" }, go, actions);
  }

  /** @param {number} at */
  go(at) {
    this.stop();
    this.chosen = at;
    this.view.moved();
    this.view.camera = this.list[at].camera;
    this.view.changed();
    [...$("keyframes").children].forEach((item, index) => item.classList.toggle("chosen", index === at));
  }

  /** @param {number} at */
  replace(at) {
    this.list[at] = { camera: this.view.camera, picture: this.picture() };
    this.changed();
  }

  /** @param {number} at */
  remove(at) {
    this.list.splice(at, 1);
    this.chosen = null;
    this.changed();
  }

  /**
   * What the path is: its images have the size of the one that is shown.
   * @returns {PathRequest}
   */
  request() {
    const { w, h } = this.view.camera;
    const loop = $("loop").checked;
    const keyframes = this.list.map(({ camera }) => withSize(camera, [w, h]));
    const parts = keyframes.length - (loop ? 0 : 1);
    return { keyframes, loop, frames: Math.min(2000, Math.max(2, Math.round(parts * this.pace * RATE))) };
  }

  // The cameras of the path; the program has the arithmetic.
  async fetchPath() {
    const request = this.list.length < 2 ? null : this.request();
    this.newest = request;
    if (!request) return;
    try {
      /** @type {Cameras} */
      const { cameras } = await (await post("/path", request)).json();
      // the keyframes may have changed meanwhile
      if (this.newest !== request || cameras.length === 0) return;
      this.path = cameras;
      this.overlay.path = request.loop ? [...cameras, cameras[0]] : cameras;
      this.overlay.draw();
    } catch (error) {
      tell(reason(error));
    }
  }

  toggle() {
    if (this.playing) this.stop();
    else if (this.list.length > 1) this.play();
  }

  async play() {
    if (!this.overlay.path.length) await this.fetchPath();
    if (!this.overlay.path.length) return;
    const begin = performance.now();
    const seconds = this.path.length / RATE;
    const loop = $("loop").checked;
    const playing = {};
    this.playing = playing;
    $("play").textContent = "Stop";
    const size = [this.view.camera.w, this.view.camera.h];
    const step = (/** @type {number} */ now) => {
      if (this.playing !== playing) return;
      // the first frame may have begun before
      const t = Math.max(0, now - begin) / 1000 / seconds;
      if (t >= 1 && !loop) return this.stop();
      this.view.moved();
      this.view.camera = withSize(this.path[Math.floor((t % 1) * this.path.length)], size);
      this.view.changed();
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  stop() {
    this.playing = null;
    $("play").textContent = "Play";
  }

  async save() {
    const reply = await post("/cameras.json", this.list.map(({ camera }) => camera));
    download(await reply.blob(), "cameras.json");
  }

  /** @param {string} text of a file */
  async load(text) {
    try {
      /** @type {Cameras} */
      const { cameras } = await (await post("/keyframes", text)).json();
      this.list = cameras.map((camera) => ({ camera, picture: "icon.svg" }));
      this.chosen = null;
      this.changed();
      this.go(0);
    } catch (error) {
      tell(reason(error));
    }
  }
}
