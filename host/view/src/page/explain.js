// A pixel, Gaussian by Gaussian: the numbers of `organza explain`.

import { post } from "./frames.js";
import { $, css, element, rampColor, reason, sharp, tell } from "./page.js";

/** @import { Viewed } from "./main.js" */
/** @import { Overlay } from "./overlay.js" */
/** @import { Contribution, Explanation, Pixel, Vector } from "./protocol" */

/** @typedef {(place: Vector) => Pixel} Turn Where a place of the unit cube is drawn. */

/** @param {number} value */
const levelOf = (value) => Math.round(255 * Math.min(1, Math.max(0, value)));
/** @param {Vector} color */
const rgb = (color) => `rgb(${color.map(levelOf).join(" ")})`;
/** @type {(value: number, digits: number) => string} */
const fixed = (value, digits) => {
  const isSmall = value !== 0 && Math.abs(value) < 0.5 * 10 ** -digits;
  return isSmall ? value.toExponential(0) : value.toFixed(digits);
};
const SHOWN = 60;
const HOVER = 150; // milliseconds that the pointer rests

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Pixel} from
 * @param {Pixel} to
 */
function line(context, from, to) {
  context.moveTo(from[0], from[1]);
  context.lineTo(to[0], to[1]);
}

export class Explain {
  /** @type {Explanation | null} */
  answer = null;
  /** @type {Contribution | undefined} */
  chosen = undefined;
  hovering = 0;

  /**
   * @param {Viewed} view
   * @param {Overlay} overlay
   */
  constructor(view, overlay) {
    this.view = view;
    this.overlay = overlay;
    this.ramp = view.scene.modes.find(([mode]) => mode === "visibility")?.[1] ?? [];
    const gradient = `linear-gradient(to right, ${this.ramp.join(", ")})`;
    document.documentElement.style.setProperty("--visibility", gradient);
    $("close-explain").onclick = () => this.close();
    new ResizeObserver(() => this.choose(this.chosen)).observe($("explain"));
  }

  /**
   * @param {Pixel} pixel
   * @returns {Promise<Explanation | null>}
   */
  async fetch(pixel) {
    const { camera } = this.view;
    const [x, y] = pixel;
    // the program explains pixels of one scene alone
    if (x < 0 || y < 0 || x >= camera.w || y >= camera.h || this.view.scene.scenes > 1) return null;
    try {
      const reply = await post("/explain", { camera, pixel });
      return await reply.json();
    } catch (error) {
      tell(reason(error));
      return null;
    }
  }

  /**
   * The depth of the Gaussian with the largest alpha in a pixel; null where there is none.
   * @param {Pixel} pixel
   */
  async depth(pixel) {
    const answer = await this.fetch(pixel);
    return answer?.gaussians[0]?.depth ?? null;
  }

  /**
   * The mean depth of a pixel by the weights, in world units; null where there is nothing.
   * @param {Pixel} pixel
   */
  async meanDepth(pixel) {
    const answer = await this.fetch(pixel);
    if (!answer?.gaussians.length) return null;
    const weight = answer.gaussians.reduce((sum, one) => sum + one.alpha, 0);
    return answer.gaussians.reduce((sum, one) => sum + one.alpha * one.depth, 0) / weight;
  }

  /**
   * In the mode of depth, finds the depth where the pointer rests.
   * @param {Pixel} pixel
   */
  hover(pixel) {
    const { view } = this;
    clearTimeout(this.hovering);
    view.depth = null;
    if (view.mode !== "depth") return;
    this.hovering = setTimeout(async () => {
      view.depth = await this.meanDepth(pixel.map(Math.floor));
      view.say();
    }, HOVER);
  }

  /** @param {Pixel} pixel */
  async ask(pixel) {
    const { camera } = this.view;
    const answer = await this.fetch(pixel);
    // the camera has moved meanwhile
    if (!answer || camera !== this.view.camera) return;
    this.answer = answer;
    this.show(answer);
  }

  close() {
    if (!this.answer) return;
    this.answer = null;
    $("explain").hidden = true;
    this.overlay.marked = null;
    this.overlay.draw();
  }

  /** @param {Explanation} answer */
  show({ pixel, all, gaussians, alpha_sum: sum, divided, color, color_8_bit: bits }) {
    $("explain").hidden = false;
    $("pixel").textContent = `Pixel ${pixel.join(", ")}`;
    $("swatch").style.background = rgb(color);
    const hex = bits.map((value) => value.toString(16).padStart(2, "0")).join("");
    const count = `${all} ${all === 1 ? "Gaussian" : "Gaussians"}`;
    const background = ((1 - sum) * 100).toFixed(1);
    const rule = divided ? "above 1, so the color is C / S." : `so ${background}% is background.`;
    $("verdict").textContent = all
      ? `${count} · #${hex} · S = ${fixed(sum, 4)}, ${rule}`
      : "No Gaussian reaches this pixel: it is background.";
    const most = gaussians[0]?.alpha || 1;
    const rows = gaussians.slice(0, SHOWN).map((one) => this.row(one, most));
    if (all > rows.length) {
      const more = `and ${all - rows.length} with a smaller alpha`;
      const rest = element("td", { colSpan: 6, className: "quiet" }, more);
      rows.push(element("tr", {}, rest));
    }
    $("rows").replaceChildren(...rows);
    for (const figure of $("explain").querySelectorAll("figure")) figure.hidden = !all;
    this.choose(gaussians[0]);
  }

  /**
   * A row of the table. `most` is the largest alpha.
   * @param {Contribution} one
   * @param {number} most
   */
  row(one, most) {
    const bar = element("i", { className: "share" });
    bar.style.width = `${(100 * one.alpha) / most}%`;
    bar.style.background = rgb(one.color);
    const title = one.color.map((value) => value.toFixed(3)).join(" ");
    const swatch = element("i", { className: "swatch", title });
    swatch.style.background = rgb(one.color);
    const number = (/** @type {number} */ value, /** @type {number} */ digits) =>
      element("td", { className: "number" }, fixed(value, digits));
    const made = element(
      "tr", { tabIndex: 0 },
      element("td", {}, String(one.gaussian)), element("td", {}, swatch),
      number(one.falloff, 3), number(one.transmittance, 3), number(one.alpha, 4),
      element("td", { className: "amount" }, bar),
    );
    made.onpointerenter = made.onfocus = () => this.choose(one);
    return made;
  }

  /** @param {Contribution | undefined} one */
  choose(one) {
    if (!this.answer) return;
    const { pixel, gaussians } = this.answer;
    this.chosen = one;
    [...$("rows").children].forEach((row, at) => row.classList.toggle("chosen", gaussians[at] === one));
    this.overlay.marked = { pixel, rows: gaussians, chosen: one };
    this.overlay.draw();
    if (!one) return;
    this.drawRay(one);
    this.drawCube(one, gaussians);
  }

  /**
   * T from the Gaussian up to each place on its way to the eye.
   * @param {Contribution} one
   */
  drawRay({ gaussian, transmittances, transmittance, samples }) {
    const height = 110;
    const [context, width] = sharp($("ray"), height);
    const left = 30;
    const right = width - 8;
    const top = 8;
    const bottom = height - 20;
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = css("--quiet");
    context.strokeStyle = css("--line");
    for (const value of [0, 0.5, 1]) {
      const y = bottom + (top - bottom) * value;
      context.beginPath();
      context.moveTo(left, y);
      context.lineTo(right, y);
      context.stroke();
      context.textAlign = "right";
      context.fillText(String(value), left - 6, y + 4);
    }
    context.textAlign = "left";
    context.fillText("Gaussian", left, height - 5);
    context.textAlign = "right";
    context.fillText("eye", right, height - 5);
    const x = (/** @type {number} */ at) => left + ((right - left) * at) / Math.max(1, transmittances.length);
    const y = (/** @type {number} */ t) => bottom + (top - bottom) * t;
    context.beginPath();
    context.moveTo(left, y(1));
    transmittances.forEach((t, at) => context.lineTo(x(at + 1), y(t)));
    context.strokeStyle = css("--accent");
    context.lineWidth = 2;
    context.stroke();
    context.lineTo(right, bottom);
    context.lineTo(left, bottom);
    context.globalAlpha = 0.14;
    context.fillStyle = css("--accent");
    context.fill();
    context.globalAlpha = 1;
    const end = `${samples} samples, ${fixed(transmittance, 4)} at the end.`;
    $("ray-caption").textContent = `Gaussian ${gaussian}: T on its way to the eye, ${end}`;
  }

  /**
   * @param {Contribution} chosen
   * @param {Contribution[]} gaussians
   */
  drawCube(chosen, gaussians) {
    const height = 210;
    const [context, width] = sharp($("cube"), height);
    // the camera's own axes, so that the cube is seen as the scene is
    const pose = this.view.camera.camera_to_world;
    const size = height * 0.66;
    /** @type {Turn} */
    const turn = ([x, y, z]) => {
      const [a, b, c] = [x - 0.5, y - 0.5, z - 0.5];
      const along = (/** @type {number} */ axis) => pose[0][axis] * a + pose[1][axis] * b + pose[2][axis] * c;
      // seen from beside, or every ray would be a point
      const [u, v, w] = [along(0), along(1), along(2)];
      const across = 0.8 * u + 0.6 * w;
      const upward = 0.94 * v - 0.34 * (0.8 * w - 0.6 * u);
      return [width / 2 + size * across, height / 2 - size * upward];
    };
    context.strokeStyle = css("--line");
    context.lineWidth = 1.25;
    context.beginPath();
    for (let at = 0; at < 8; at++) {
      for (const bit of [1, 2, 4]) {
        if (at & bit) continue;
        const corner = (/** @type {number} */ bits) => turn([bits & 1, (bits >> 1) & 1, (bits >> 2) & 1]);
        line(context, corner(at), corner(at | bit));
      }
    }
    context.stroke();
    for (const one of gaussians.slice(0, SHOWN).reverse()) this.drawWay(context, turn, one, false);
    this.drawWay(context, turn, chosen, true);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Turn} turn
   * @param {Contribution} one
   * @param {boolean} front
   */
  drawWay(context, turn, one, front) {
    const { places, transmittances } = one;
    const count = Math.max(1, transmittances.length);
    // places are evenly spaced; between two of them the way is straight
    const place = (/** @type {number} */ t) => {
      const at = t * (places.length - 1);
      const first = Math.min(Math.floor(at), places.length - 2);
      const a = places[first];
      const b = places[first + 1];
      return turn(a.map((x, axis) => x + (b[axis] - x) * (at - first)));
    };
    context.globalAlpha = front ? 1 : 0.25;
    context.lineWidth = front ? 3 : 1.25;
    transmittances.forEach((t, at) => {
      context.beginPath();
      line(context, place(at / count), place((at + 1) / count));
      context.strokeStyle = rampColor(this.ramp, t);
      context.stroke();
    });
    const [x, y] = place(0);
    context.beginPath();
    context.arc(x, y, front ? 4.5 : 2, 0, 7);
    context.fillStyle = rgb(one.color);
    context.fill();
    if (front) {
      context.strokeStyle = css("--ink");
      context.lineWidth = 1.25;
      context.stroke();
    }
    context.globalAlpha = 1;
  }
}
