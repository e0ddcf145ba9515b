// What is shown, how fast, and on what.

import { angleOf, farness, hex, opacityAt } from "./camera.js";
import { $ } from "./page.js";

/** @import { Frames } from "./frames.js" */
/** @import { Viewed } from "./main.js" */
/** @import { FrameAbout, Pose } from "./protocol" */
/** @import { Training } from "./training.js" */

const number = new Intl.NumberFormat("en");

/** @param {number} value */
const digits = (value) => (value >= 100 || Number.isInteger(value) ? value.toFixed(0) : value.toPrecision(2));

export class Status {
  /**
   * @param {Viewed} view
   * @param {Pose[]} poses of the data set
   * @param {Frames} frames
   * @param {Training | null} training
   */
  constructor(view, poses, frames, training) {
    this.view = view;
    this.poses = poses;
    this.frames = frames;
    this.training = training;
  }

  say() {
    const { view } = this;
    const about = view.shown?.about;
    if (!about) return;
    const quality = this.quality(about);
    $("quality").textContent = quality;
    $("quality").dataset.is = quality;
    const far = farness(view.camera, this.poses, view.scene.center);
    $("far").hidden = far <= 1;
    $("frame").style.background = hex(view.background ?? view.scene.background);
    $("image").style.opacity = String(view.mode === "color" ? opacityAt(far) : 1);
    $("numbers").textContent = this.facts(about).join(" · ");
    $("facts").textContent = `${number.format(about.gaussians)} Gaussians · ${view.scene.device}`;
    this.sayScale(about);
    const angle = (angleOf(view.camera) * 180) / Math.PI;
    $("angle").value = String(angle);
    $("angle-value").textContent = `${angle.toFixed(0)}°`;
  }

  /** @param {FrameAbout} about */
  quality(about) {
    if (this.training?.ended) return "ended";
    if (about.quality === "moving") return "moving";
    const [there, failed, all] = about.blocks ?? [];
    if (there < all) return there + failed < all ? "loading" : "incomplete";
    // a scene that is trained changes before it could be refined
    if (!this.frames.refines) return "live";
    return this.frames.wanted || this.frames.busy || about.quality === "still" ? "refining" : "exact";
  }

  /** @param {FrameAbout} about */
  facts(about) {
    const [w, h] = about.size;
    const { rate } = this.frames;
    const { depth } = this.view;
    const facts = [];
    const [there, , all] = about.blocks ?? [];
    if (there < all) facts.push(`${there} of ${all} blocks`);
    if (rate) facts.push(`${rate.toFixed(rate < 10 ? 1 : 0)} images/s`);
    if (depth) facts.push(`depth ${depth.toPrecision(4)}`);
    // the page draws a small image larger than it is
    const larger = $("image").clientWidth / w;
    facts.push(`${w} × ${h}${larger > 1.5 ? `, enlarged ${larger.toFixed(1)} times` : ""}`);
    facts.push(`${about.milliseconds.toFixed(0)} ms`);
    facts.push(`${number.format(about.pairs)} Gaussians in view`);
    if (about.samples) {
      const steps = about.steps > 1 ? `, steps × ${about.steps}` : "";
      const share = Math.round((100 * about.renewed) / about.pairs);
      const renewed = about.renewed < about.pairs ? `, ${share}% new` : "";
      facts.push(`${number.format(about.samples)} samples${steps}${renewed}`);
    } else {
      facts.push("T and colors kept");
    }
    return facts;
  }

  /** @param {FrameAbout} about */
  sayScale({ mode, range }) {
    $("scale").hidden = !range && mode !== "normal";
    $("ramp").hidden = !range;
    if (!range) {
      $("low").textContent = "normals: x is red, y green, z blue";
      $("high").textContent = "-1 is dark, 1 bright";
      return;
    }
    $("low").textContent = digits(range[0]);
    $("high").textContent = digits(range[1]);
    const ramp = this.view.scene.modes.find(([other]) => other === mode)?.[1] ?? [];
    $("ramp").style.background = `linear-gradient(to right, ${ramp.join(", ")})`;
  }
}
