// The cameras of the data set, and the photograph beside the scene.

import { nearestOf } from "./camera.js";
import { $, element } from "./page.js";

/** @import { Viewed } from "./main.js" */

export class Cameras {
  /** @param {Viewed} view */
  constructor(view) {
    this.view = view;
    this.views = view.scene.views;
    this.poses = this.views.map(({ camera }) => camera.camera_to_world);
    if (this.views.length) this.list();
    $("view").onchange = () => $("view").value && view.goTo(Number($("view").value));
    $("previous").onclick = () => this.beside(-1);
    $("next").onclick = () => this.beside(1);
    $("slider").oninput = () => this.slide();
    $("compare").onchange = () => {
      if ($("compare").checked && view.index == null) view.goTo(this.nearest);
      this.compare();
    };
    $("compare-label").hidden = !view.scene.photographs;
  }

  list() {
    $("views").hidden = false;
    const held = this.views.filter((one) => one.held_out).length;
    $("place").textContent = `${this.views.length}${held ? `, ${held} held out` : ""}`;
    $("view").append(new Option("choose a camera", "", true, true));
    for (const isHeldOut of [true, false]) {
      const label = isHeldOut ? "Held out" : "Training";
      const group = element("optgroup", { label: held ? label : "Cameras" });
      for (const [at, one] of this.views.entries()) {
        if (one.held_out === isHeldOut) group.append(new Option(one.name, String(at)));
      }
      if (group.children.length) $("view").append(group);
    }
  }

  /** The index of the camera that is nearest to where the eye is. */
  get nearest() {
    return nearestOf(this.view.camera, this.poses, this.view.extent);
  }

  /**
   * Goes to another camera of the list.
   * @param {number} by
   */
  beside(by) {
    const { index } = this.view;
    const count = this.views.length;
    this.view.goTo(index == null ? this.nearest : (index + by + count) % count);
  }

  /** Shows the photograph of the view, if there is one and the user wants to see it. */
  compare() {
    const { index, scene } = this.view;
    const isShown = $("compare").checked && index != null && scene.photographs;
    $("photograph").hidden = $("slider").hidden = !isShown;
    const source = `photograph/${index}`;
    if (isShown && !$("photograph").src.endsWith(`/${source}`)) $("photograph").src = source;
    this.slide();
  }

  slide() {
    $("frame").style.setProperty("--at", `${$("slider").value}%`);
  }
}
