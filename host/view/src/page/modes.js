// What an image shows: the buttons of the modes.

import { $, element } from "./page.js";

/** @import { Mode, Scene } from "./protocol" */

/** @type {Record<Mode, [string, string]>} */
const MODES = {
  color: ["Color", ""],
  visibility: ["Visibility", "mean T of a pixel's Gaussians"],
  weight: ["Weight", "S, the sum of the weights"],
  depth: ["Depth", "in world units"],
  normal: ["Normals", "shortest axes, in world space"],
  gaussians: ["Gaussians", "number in a pixel"],
  error: ["Error", "difference from the photograph"],
};

export class Modes {
  /** @type {Mode} */
  mode = "color";

  /**
   * @param {Scene} scene
   * @param {(mode: Mode) => void} choose is called with each mode that the user chooses
   */
  constructor(scene, choose) {
    this.chips = scene.modes.map(([mode], at) => {
      const [name, what] = MODES[mode];
      const chip = element("button", { title: `${what} (${at + 1})`.trim(), role: "radio" }, name);
      chip.dataset.mode = mode;
      chip.onclick = () => choose(mode);
      chip.hidden = mode === "error" && !scene.photographs;
      return chip;
    });
    $("modes").append(...this.chips);
    this.show("color");
  }

  /** @param {Mode} mode */
  show(mode) {
    this.mode = mode;
    for (const chip of this.chips) chip.ariaChecked = String(chip.dataset.mode === mode);
  }

  /**
   * Clicks the button of this number, from 1.
   * @param {number} number
   */
  click(number) {
    const chip = this.chips.filter((one) => !one.hidden)[number - 1];
    chip?.click();
  }
}
