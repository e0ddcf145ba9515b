// What is drawn over the image: cameras, points, the path of keyframes, and the Gaussians of a pixel.

import { add, column, eyeOf, forwardOf, length, project, scale, sub } from "./camera.js";
import { $, brush, css } from "./page.js";

/** @import { Viewed } from "./main.js" */
/** @import { Keyframe } from "./keyframes.js" */
/** @import { Measure } from "./measure.js" */
/** @import { Camera, Contribution, Pixel, Vector } from "./protocol" */
/** @import { Tool } from "./tool.js" */

// The Gaussians of a pixel.
/** @typedef {{ pixel: Pixel, rows: Contribution[], chosen?: Contribution }} Marked */

const SUPPORT = 2 * Math.log(255); // the support ends at d^T conic d = 2 ln 255

export class Overlay {
  /** Whether cameras are drawn, and points. */
  cameras = false;
  points = false;
  /** @type {Camera[]} the path through the keyframes */
  path = [];
  /** @type {Keyframe[]} */
  keyframes = [];
  /** @type {Marked | null} */
  marked = null;
  /** @type {Vector | null} */
  pinged = null;
  /** @type {Tool | null} */
  tool = null;
  /** @type {Measure | null} */
  measure = null;
  /** @type {Float32Array | null} of points, and their colors */
  positions = null;
  colors = new Uint8Array();
  drawing = false;
  /** Pixels of the screen in a CSS pixel. */
  dense = 1;
  /** A CSS pixel, in pixels of the image. */
  unit = 1;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Viewed} view
   */
  constructor(canvas, view) {
    this.canvas = canvas;
    this.view = view;
    this.context = brush(canvas);
    $("points-label").hidden = !view.scene.points;
    $("show-cameras").onchange = () => {
      this.cameras = $("show-cameras").checked;
      this.draw();
    };
    $("show-points").onchange = async () => {
      await this.loadPoints();
      this.points = $("show-points").checked;
      this.draw();
    };
  }

  /** The canvas has the screen's pixels, not the image's. */
  fit() {
    const box = this.canvas.getBoundingClientRect();
    const dense = devicePixelRatio || 1;
    const [width, height] = [box.width, box.height].map((side) => Math.max(1, Math.round(side * dense)));
    const isSame = this.canvas.width === width && this.canvas.height === height;
    if (!isSame) Object.assign(this.canvas, { width, height });
    this.dense = dense;
  }

  async loadPoints() {
    if (this.positions || !this.view.scene.points) return;
    const count = this.view.scene.points;
    const bytes = await (await fetch("points")).arrayBuffer();
    this.colors = new Uint8Array(bytes, 12 * count);
    this.positions = new Float32Array(bytes, 0, 3 * count);
  }

  draw() {
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => {
      this.drawing = false;
      this.paint();
    });
  }

  paint() {
    const { context, canvas, view } = this;
    const { camera } = view;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const factor = canvas.width / camera.w;
    context.setTransform(factor, 0, 0, factor, 0, 0);
    this.unit = this.dense / factor;
    context.lineJoin = context.lineCap = "round";
    if (this.points && this.positions) this.paintPoints(camera, this.positions);
    if (this.cameras) this.paintCameras(camera);
    if (this.path.length > 1) this.paintPath(camera);
    if (this.pinged) this.paintPing(camera, this.pinged);
    if (this.marked) this.paintMarked(this.marked);
    this.tool?.paint(context, camera, this.unit);
    this.measure?.paint(context, camera, this.unit);
  }

  /**
   * @param {Camera} camera
   * @param {Float32Array} positions
   */
  paintPoints(camera, positions) {
    const { context, colors } = this;
    const size = 1.6 * this.unit;
    const pose = camera.camera_to_world;
    const [right, up, back, eye] = [0, 1, 2, 3].map((at) => column(pose, at));
    for (let at = 0; at < positions.length; at += 3) {
      const x = positions[at] - eye[0];
      const y = positions[at + 1] - eye[1];
      const z = positions[at + 2] - eye[2];
      const depth = -(back[0] * x + back[1] * y + back[2] * z);
      if (depth < 0.01) continue;
      const u = camera.cx + (camera.fl_x * (right[0] * x + right[1] * y + right[2] * z)) / depth;
      const v = camera.cy - (camera.fl_y * (up[0] * x + up[1] * y + up[2] * z)) / depth;
      if (u < 0 || v < 0 || u > camera.w || v > camera.h) continue;
      context.fillStyle = `rgb(${colors[at]},${colors[at + 1]},${colors[at + 2]})`;
      context.fillRect(u - size / 2, v - size / 2, size, size);
    }
  }

  /**
   * A line between two places of the world, where both are in front of the camera.
   * @param {Camera} camera
   * @param {Vector} a
   * @param {Vector} b
   */
  line(camera, a, b) {
    const [p, q] = [project(camera, a), project(camera, b)];
    if (p[2] < 0.02 || q[2] < 0.02) return;
    this.context.moveTo(p[0], p[1]);
    this.context.lineTo(q[0], q[1]);
  }

  /**
   * Another camera, with its image at a distance.
   * @param {Camera} camera
   * @param {Camera} other
   * @param {number} size
   * @param {string} color
   * @param {number} width
   */
  frustum(camera, other, size, color, width) {
    const { camera_to_world: pose, fl_x, fl_y, cx, cy, w, h } = other;
    const eye = eyeOf(pose);
    const middle = add(eye, scale(forwardOf(pose), size));
    const corner = (/** @type {number} */ x, /** @type {number} */ y) => {
      const sideways = scale(column(pose, 0), ((x - cx) / fl_x) * size);
      return add(add(middle, sideways), scale(column(pose, 1), ((cy - y) / fl_y) * size));
    };
    const corners = [corner(0, 0), corner(w, 0), corner(w, h), corner(0, h)];
    this.context.beginPath();
    corners.forEach((place, at) => {
      this.line(camera, eye, place);
      this.line(camera, place, corners[(at + 1) % 4]);
    });
    this.context.strokeStyle = color;
    this.context.lineWidth = width * this.unit;
    this.context.stroke();
  }

  /** @param {Camera} camera */
  paintCameras(camera) {
    const size = 0.07 * this.view.extent;
    for (const [at, { camera: other, held_out }] of this.view.scene.views.entries()) {
      const color = css(held_out ? "--held-out" : "--batch");
      if (at !== this.view.index) this.frustum(camera, other, size, color, 1.25);
    }
  }

  /** @param {Camera} camera */
  paintPath(camera) {
    const { context } = this;
    const eyes = this.path.map((other) => eyeOf(other.camera_to_world));
    context.beginPath();
    for (let at = 1; at < eyes.length; at++) this.line(camera, eyes[at - 1], eyes[at]);
    context.strokeStyle = css("--path");
    context.lineWidth = 2 * this.unit;
    context.stroke();
    const eye = eyeOf(camera.camera_to_world);
    const size = 0.05 * this.view.extent;
    for (const { camera: other } of this.keyframes) {
      // from within, its outline would be the image's edge
      const away = length(sub(eyeOf(other.camera_to_world), eye));
      if (away > size) this.frustum(camera, other, size, css("--path"), 1.5);
    }
  }

  /**
   * Shows for a moment what the camera goes around now.
   * @param {Vector} place
   */
  ping(place) {
    this.pinged = place;
    this.draw();
    setTimeout(() => {
      this.pinged = null;
      this.draw();
    }, 900);
  }

  /**
   * @param {Camera} camera
   * @param {Vector} place
   */
  paintPing(camera, place) {
    const [x, y, depth] = project(camera, place);
    const { context, unit } = this;
    if (depth < 0) return;
    context.beginPath();
    context.arc(x, y, 9 * unit, 0, 7);
    context.moveTo(x - 14 * unit, y);
    context.lineTo(x + 14 * unit, y);
    context.moveTo(x, y - 14 * unit);
    context.lineTo(x, y + 14 * unit);
    this.outlined(css("--path"), 1.5);
  }

  /**
   * Strokes what is drawn, with a dark outline.
   * @param {string} color
   * @param {number} width in CSS pixels
   */
  outlined(color, width) {
    const { context, unit } = this;
    context.strokeStyle = "rgb(0 0 0 / 55%)";
    context.lineWidth = (width + 2) * unit;
    context.stroke();
    context.strokeStyle = color;
    context.lineWidth = width * unit;
    context.stroke();
  }

  /**
   * The ellipses at which supports end, the chosen one in front; and the pixel.
   * @param {Marked} marked
   */
  paintMarked({ pixel, rows, chosen }) {
    const { context, unit } = this;
    const others = rows.filter((row) => row !== chosen).slice(0, 24);
    for (const row of others) {
      this.ellipse(row);
      context.strokeStyle = `rgb(255 255 255 / ${(0.12 + 0.5 * Math.min(1, row.alpha)).toFixed(2)})`;
      context.lineWidth = unit;
      context.stroke();
    }
    if (chosen) {
      this.ellipse(chosen);
      this.outlined("#fff", 2);
    }
    context.beginPath();
    const [x, y] = pixel.map((at) => at + 0.5);
    const side = Math.max(1, 7 * unit);
    context.rect(x - side / 2, y - side / 2, side, side);
    this.outlined(css("--path"), 1.5);
  }

  /** @param {Contribution} one */
  ellipse({ mean2d: [x, y], conic: [a, b, c] }) {
    const middle = (a + c) / 2;
    const apart = Math.hypot((a - c) / 2, b);
    const short = Math.sqrt(SUPPORT / (middle + apart));
    const long = Math.sqrt(SUPPORT / Math.max(middle - apart, 1e-12));
    const angle = 0.5 * Math.atan2(2 * b, a - c);
    this.context.beginPath();
    this.context.ellipse(x, y, short, long, angle, 0, 2 * Math.PI);
  }
}
