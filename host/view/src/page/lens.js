// How the scene is seen: the field of view, the image's size, the background, and the frame in the window.

import { angleOf, hex, withAngle, withSize } from "./camera.js";
import { $ } from "./page.js";

/** @import { Viewed } from "./main.js" */

const SIZES = [[640, 480], [960, 720], [1280, 720], [1920, 1080]];

export class Lens {
  /**
   * @param {Viewed} view
   * @param {() => void} resized is called where the image or the window has another size
   */
  constructor(view, resized) {
    this.view = view;
    this.resized = resized;
    $("angle").oninput = () => {
      const camera = withAngle(view.camera, (Number($("angle").value) * Math.PI) / 180);
      if (view.index != null) view.leave();
      view.camera = withAngle(view.camera, angleOf(camera));
      view.changed();
    };
    $("size").append(new Option("the window's", "window"), new Option("half the window's", "half"));
    for (const [w, h] of SIZES) $("size").append(new Option(`${w} × ${h}`, `${w}x${h}`));
    $("size").onchange = () => this.resize();
    $("background").value = hex(view.scene.background);
    $("background").oninput = () => {
      const text = $("background").value;
      view.background = [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
      view.changed();
    };
    $("background-reset").onclick = () => {
      view.background = null;
      $("background").value = hex(view.scene.background);
      view.changed();
    };
    new ResizeObserver(() => this.resize()).observe($("stage"));
  }

  /** The size of an image, as the user has chosen it. */
  get size() {
    const chosen = $("size").value;
    if (chosen.includes("x")) return chosen.split("x").map(Number);
    const box = $("stage").getBoundingClientRect();
    const part = chosen === "half" ? 2 : 1;
    return [box.width, box.height].map((side) => Math.max(16, Math.min(4096, Math.round(side / part))));
  }

  resize() {
    if (this.view.index == null) {
      this.view.camera = withSize(this.view.camera, this.size);
      this.resized();
    }
    this.place();
    this.view.draw();
  }

  /** The frame is as large as the window allows, with the image's shape. */
  place() {
    const { w, h } = this.view.camera;
    const box = $("stage").getBoundingClientRect();
    const factor = Math.min(box.width / w, box.height / h);
    const { style } = $("frame");
    style.width = `${w * factor}px`;
    style.height = `${h * factor}px`;
    this.view.fit();
  }
}
