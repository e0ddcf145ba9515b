// A pixel, Gaussian by Gaussian: the numbers of `organza explain`.

import { post } from "./frames.js";
import { $, css, element, rampColor, sharp } from "./page.js";

const rgb = (color) => `rgb(${color.map((value) => Math.round(255 * Math.min(1, Math.max(0, value)))).join(" ")})`;
const fixed = (value, digits) => (value !== 0 && Math.abs(value) < 0.5 * 10 ** -digits ? value.toExponential(0) : value.toFixed(digits));
const SHOWN = 60;

export class Explain {
  constructor(view, overlay) {
    Object.assign(this, { view, overlay, answer: null });
    this.ramp = view.scene.modes.find(([mode]) => mode === "visibility")[1];
    document.documentElement.style.setProperty("--visibility", `linear-gradient(to right, ${this.ramp.join(", ")})`);
    $("close-explain").onclick = () => this.close();
    new ResizeObserver(() => this.answer && this.choose(this.chosen)).observe($("explain"));
  }

  async fetch(pixel) {
    const { camera } = this.view, [x, y] = pixel;
    // the program explains pixels of one scene alone
    if (x < 0 || y < 0 || x >= camera.w || y >= camera.h || this.view.scene.scenes > 1) return null;
    try {
      const reply = await post("/explain", { camera, pixel });
      return await reply.json();
    } catch (error) {
      $("message").hidden = false;
      $("message").textContent = error.message;
      return null;
    }
  }

  // The depth of the Gaussian with the largest alpha in a pixel; null where there is none.
  async depth(pixel) {
    const answer = await this.fetch(pixel);
    return answer?.gaussians[0]?.depth ?? null;
  }

  // The mean depth of a pixel by the weights, in world units; null where there is nothing.
  async meanDepth(pixel) {
    const answer = await this.fetch(pixel);
    if (!answer?.gaussians.length) return null;
    const sum = (value) => answer.gaussians.reduce((total, one) => total + value(one), 0);
    return sum((one) => one.alpha * one.depth) / sum((one) => one.alpha);
  }

  async ask(pixel) {
    const camera = this.view.camera;
    const answer = await this.fetch(pixel);
    // the camera has moved meanwhile
    if (!answer || camera !== this.view.camera) return;
    this.answer = answer;
    this.show();
  }

  close() {
    if (!this.answer) return;
    this.answer = null;
    $("explain").hidden = true;
    this.overlay.marked = null;
    this.overlay.draw();
  }

  show() {
    const { pixel, all, gaussians, alpha_sum: sum, divided, color, color_8_bit: bits } = this.answer;
    $("explain").hidden = false;
    $("pixel").textContent = `Pixel ${pixel.join(", ")}`;
    $("swatch").style.background = rgb(color);
    const hex = bits.map((value) => value.toString(16).padStart(2, "0")).join("");
    const count = `${all} ${all === 1 ? "Gaussian" : "Gaussians"}`;
    const rule = divided ? "above 1, so the color is C / S." : `so ${((1 - sum) * 100).toFixed(1)}% is background.`;
    $("verdict").textContent = all ? `${count} · #${hex} · S = ${fixed(sum, 4)}, ${rule}` : "No Gaussian reaches this pixel: it is background.";
    const most = gaussians[0]?.alpha || 1;
    const row = (one) => {
      const bar = element("i", { className: "share" });
      bar.style.width = `${(100 * one.alpha) / most}%`;
      bar.style.background = rgb(one.color);
      const swatch = element("i", { className: "swatch", title: one.color.map((value) => value.toFixed(3)).join(" ") });
      swatch.style.background = rgb(one.color);
      const number = (value, digits) => element("td", { className: "number" }, fixed(value, digits));
      const made = element(
        "tr", { tabIndex: 0 },
        element("td", {}, String(one.gaussian)), element("td", {}, swatch),
        number(one.falloff, 3), number(one.transmittance, 3), number(one.alpha, 4), element("td", { className: "amount" }, bar),
      );
      made.onpointerenter = made.onfocus = () => this.choose(one);
      return made;
    };
    const rows = gaussians.slice(0, SHOWN).map(row);
    if (all > rows.length) {
      const rest = element("td", { colSpan: 6, className: "quiet" }, `and ${all - rows.length} with a smaller alpha`);
      rows.push(element("tr", {}, rest));
    }
    $("rows").replaceChildren(...rows);
    for (const figure of $("explain").querySelectorAll("figure")) figure.hidden = !all;
    this.choose(gaussians[0]);
  }

  choose(one) {
    const { pixel, gaussians } = this.answer;
    this.chosen = one;
    [...$("rows").children].forEach((row, at) => row.classList.toggle("chosen", gaussians[at] === one));
    this.overlay.marked = { pixel, rows: gaussians, chosen: one };
    this.overlay.draw();
    if (!one) return;
    this.drawRay(one);
    this.drawCube(one);
  }

  // T from the Gaussian up to each place on its way to the eye.
  drawRay({ gaussian, transmittances, transmittance, samples }) {
    const height = 110, [context, width] = sharp($("ray"), height);
    const [left, right, top, bottom] = [30, width - 8, 8, height - 20];
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
      context.fillText(value, left - 6, y + 4);
    }
    context.textAlign = "left";
    context.fillText("Gaussian", left, height - 5);
    context.textAlign = "right";
    context.fillText("eye", right, height - 5);
    const x = (at) => left + ((right - left) * at) / Math.max(1, transmittances.length);
    const y = (t) => bottom + (top - bottom) * t;
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
    $("ray-caption").textContent = `Gaussian ${gaussian}: T on its way to the eye, ${samples} samples, ${fixed(transmittance, 4)} at the end.`;
  }

  drawCube(chosen) {
    const height = 210, [context, width] = sharp($("cube"), height);
    // the camera's own axes, so that the cube is seen as the scene is
    const pose = this.view.camera.camera_to_world, size = height * 0.66;
    const turn = ([x, y, z]) => {
      const [a, b, c] = [x - 0.5, y - 0.5, z - 0.5];
      const along = (axis) => pose[0][axis] * a + pose[1][axis] * b + pose[2][axis] * c;
      // seen from beside, or every ray would be a point
      const [u, v, w] = [along(0), along(1), along(2)];
      return [width / 2 + size * (0.8 * u + 0.6 * w), height / 2 - size * (0.94 * v - 0.34 * (0.8 * w - 0.6 * u))];
    };
    context.strokeStyle = css("--line");
    context.lineWidth = 1.25;
    context.beginPath();
    for (let at = 0; at < 8; at++) {
      for (const bit of [1, 2, 4]) {
        if (at & bit) continue;
        const corner = (bits) => turn([bits & 1, (bits >> 1) & 1, (bits >> 2) & 1]);
        context.moveTo(...corner(at));
        context.lineTo(...corner(at | bit));
      }
    }
    context.stroke();
    for (const one of [...this.answer.gaussians].slice(0, SHOWN).reverse()) this.drawWay(context, turn, one, false);
    this.drawWay(context, turn, chosen, true);
  }

  drawWay(context, turn, one, front) {
    const { places, transmittances } = one, count = Math.max(1, transmittances.length);
    // places are evenly spaced; between two of them the way is straight
    const place = (t) => {
      const at = t * (places.length - 1), first = Math.min(Math.floor(at), places.length - 2);
      const [a, b] = [places[first], places[first + 1]];
      return turn(a.map((x, axis) => x + (b[axis] - x) * (at - first)));
    };
    context.globalAlpha = front ? 1 : 0.25;
    context.lineWidth = front ? 3 : 1.25;
    transmittances.forEach((t, at) => {
      context.beginPath();
      context.moveTo(...place(at / count));
      context.lineTo(...place((at + 1) / count));
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
