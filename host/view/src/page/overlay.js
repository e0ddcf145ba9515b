// What is drawn over the image: cameras, points, the path of keyframes, and the Gaussians of a pixel.

import { add, column, eyeOf, forwardOf, length, project, scale, sub } from "./camera.js";
import { css } from "./page.js";

const SUPPORT = 2 * Math.log(255); // the support ends at d^T conic d = 2 ln 255

export class Overlay {
  constructor(canvas, view) {
    Object.assign(this, { canvas, view, cameras: false, points: false, path: [], keyframes: [], marked: null, pinged: null });
    this.context = canvas.getContext("2d");
  }

  // The canvas has the screen's pixels, not the image's.
  fit() {
    const box = this.canvas.getBoundingClientRect(), dense = devicePixelRatio || 1;
    const [width, height] = [box.width, box.height].map((side) => Math.max(1, Math.round(side * dense)));
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    this.dense = dense;
  }

  async loadPoints() {
    if (this.positions || !this.view.scene.points) return;
    const count = this.view.scene.points, bytes = await (await fetch("points")).arrayBuffer();
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
    const { context, canvas, view } = this, camera = view.camera;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const factor = canvas.width / camera.w;
    context.setTransform(factor, 0, 0, factor, 0, 0);
    this.unit = (this.dense ?? 1) / factor; // a CSS pixel
    context.lineJoin = context.lineCap = "round";
    if (this.points && this.positions) this.paintPoints(camera);
    if (this.cameras) this.paintCameras(camera);
    if (this.path.length > 1) this.paintPath(camera);
    if (this.pinged) this.paintPing(camera);
    if (this.marked) this.paintMarked();
    this.tool?.paint(context, camera, this.unit);
    this.measure?.paint(context, camera, this.unit);
  }

  paintPoints(camera) {
    const { context, positions, colors } = this, size = 1.6 * this.unit, pose = camera.camera_to_world;
    const [right, up, back, eye] = [0, 1, 2, 3].map((at) => column(pose, at));
    for (let at = 0; at < positions.length; at += 3) {
      const x = positions[at] - eye[0], y = positions[at + 1] - eye[1], z = positions[at + 2] - eye[2];
      const depth = -(back[0] * x + back[1] * y + back[2] * z);
      if (depth < 0.01) continue;
      const u = camera.cx + (camera.fl_x * (right[0] * x + right[1] * y + right[2] * z)) / depth;
      const v = camera.cy - (camera.fl_y * (up[0] * x + up[1] * y + up[2] * z)) / depth;
      if (u < 0 || v < 0 || u > camera.w || v > camera.h) continue;
      context.fillStyle = `rgb(${colors[at]},${colors[at + 1]},${colors[at + 2]})`;
      context.fillRect(u - size / 2, v - size / 2, size, size);
    }
  }

  // A line between two places of the world, where both are in front of the camera.
  line(camera, a, b) {
    const [p, q] = [project(camera, a), project(camera, b)];
    if (p[2] < 0.02 || q[2] < 0.02) return;
    this.context.moveTo(p[0], p[1]);
    this.context.lineTo(q[0], q[1]);
  }

  frustum(camera, other, size, color, width) {
    const { camera_to_world: pose, fl_x, fl_y, cx, cy, w, h } = other;
    const eye = eyeOf(pose), right = column(pose, 0), up = column(pose, 1), forward = forwardOf(pose);
    const corner = (x, y) =>
      add(add(add(eye, scale(forward, size)), scale(right, ((x - cx) / fl_x) * size)), scale(up, ((cy - y) / fl_y) * size));
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

  paintCameras(camera) {
    const { views } = this.view.scene, size = 0.07 * this.view.extent;
    for (const [at, { camera: other, held_out }] of views.entries()) {
      if (at !== this.view.index) this.frustum(camera, other, size, css(held_out ? "--held-out" : "--batch"), 1.25);
    }
  }

  paintPath(camera) {
    const { context } = this;
    context.beginPath();
    for (let at = 1; at < this.path.length; at++) this.line(camera, eyeOf(this.path[at - 1].camera_to_world), eyeOf(this.path[at].camera_to_world));
    context.strokeStyle = css("--path");
    context.lineWidth = 2 * this.unit;
    context.stroke();
    const eye = eyeOf(camera.camera_to_world), size = 0.05 * this.view.extent;
    for (const { camera: other } of this.keyframes) {
      // from within, its outline would be the image's edge
      if (length(sub(eyeOf(other.camera_to_world), eye)) > size) this.frustum(camera, other, size, css("--path"), 1.5);
    }
  }

  // Shows for a moment what the camera goes around now.
  ping(place) {
    this.pinged = place;
    this.draw();
    setTimeout(() => {
      this.pinged = null;
      this.draw();
    }, 900);
  }

  paintPing(camera) {
    const [x, y, depth] = project(camera, this.pinged), { context, unit } = this;
    if (depth < 0) return;
    context.beginPath();
    context.arc(x, y, 9 * unit, 0, 7);
    context.moveTo(x - 14 * unit, y);
    context.lineTo(x + 14 * unit, y);
    context.moveTo(x, y - 14 * unit);
    context.lineTo(x, y + 14 * unit);
    this.outlined(css("--path"), 1.5);
  }

  outlined(color, width) {
    const { context, unit } = this;
    context.strokeStyle = "rgb(0 0 0 / 55%)";
    context.lineWidth = (width + 2) * unit;
    context.stroke();
    context.strokeStyle = color;
    context.lineWidth = width * unit;
    context.stroke();
  }

  // The ellipses at which supports end, the chosen one in front; and the pixel.
  paintMarked() {
    const { context, marked, unit } = this, { pixel, rows, chosen } = marked;
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
    const [x, y] = pixel.map((at) => at + 0.5), side = Math.max(1, 7 * unit);
    context.rect(x - side / 2, y - side / 2, side, side);
    this.outlined(css("--path"), 1.5);
  }

  ellipse({ mean2d: [x, y], conic: [a, b, c] }) {
    const middle = (a + c) / 2, apart = Math.hypot((a - c) / 2, b);
    const [short, long] = [middle + apart, Math.max(middle - apart, 1e-12)].map((value) => Math.sqrt(SUPPORT / value));
    const angle = 0.5 * Math.atan2(2 * b, a - c);
    this.context.beginPath();
    this.context.ellipse(x, y, short, long, angle, 0, 2 * Math.PI);
  }
}
