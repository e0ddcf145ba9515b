// Cameras as arithmetic. A pose is a camera-to-world matrix with OpenGL axes, row by row, as in
// transforms.json: x right, y up, looking along -z.

/** @import { Camera, Pixel, Placement, Pose, Vector } from "./protocol" */

/** @type {(a: Vector, b: Vector) => Vector} */
export const add = (a, b) => a.map((x, i) => x + b[i]);
/** @type {(a: Vector, b: Vector) => Vector} */
export const sub = (a, b) => a.map((x, i) => x - b[i]);
/** @type {(a: Vector, s: number) => Vector} */
export const scale = (a, s) => a.map((x) => x * s);
/** @type {(a: Vector, b: Vector) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(a: Vector) => number} */
export const length = (a) => Math.sqrt(dot(a, a));
/** @type {(a: Vector) => Vector} */
export const normalize = (a) => scale(a, 1 / (length(a) || 1));
/** @type {(a: Vector, b: Vector) => Vector} */
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * A place of the scene, in the world.
 * @param {Placement} placement
 * @param {Vector} place
 */
export function toWorld({ offset, scale: units, up, right }, [x, y, z]) {
  const turned = add(add(scale(right, x), scale(cross(up, right), y)), scale(up, z));
  return add(offset, scale(turned, units));
}

/**
 * Rounds coordinates to four digits of a size, wherever that lies in the world.
 * @param {number} size
 * @returns {(x: number) => number}
 */
export function digits(size) {
  const places = Math.min(Math.max(3 - Math.floor(Math.log10(size)), 0), 20);
  return (x) => Number(x.toFixed(places));
}

/** @type {(pose: Pose, axis: number) => Vector} */
export const column = (pose, axis) => [pose[0][axis], pose[1][axis], pose[2][axis]];
/** @type {(pose: Pose) => Vector} */
export const eyeOf = (pose) => column(pose, 3);
/** @type {(pose: Pose) => Vector} */
export const forwardOf = (pose) => scale(column(pose, 2), -1);

/**
 * A pose of its axes; they are made orthonormal, so that rounding never adds up.
 * @param {Vector} right
 * @param {Vector} back
 * @param {Vector} eye
 * @returns {Pose}
 */
export function poseOf(right, back, eye) {
  const z = normalize(back);
  const x = normalize(sub(right, scale(z, dot(right, z))));
  const y = cross(z, x);
  return [0, 1, 2].map((row) => [x[row], y[row], z[row], eye[row]]).concat([[0, 0, 0, 1]]);
}

/**
 * A vector turned around an axis of length 1.
 * @param {Vector} vector
 * @param {Vector} axis
 * @param {number} angle
 */
export function turned(vector, axis, angle) {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  const along = scale(axis, dot(axis, vector) * (1 - cos));
  return add(add(scale(vector, cos), scale(cross(axis, vector), sin)), along);
}

/**
 * A pose turned around a place.
 * @param {Pose} pose
 * @param {Vector} axis
 * @param {number} angle
 * @param {Vector} place
 */
export function rotated(pose, axis, angle, place) {
  const eye = add(place, turned(sub(eyeOf(pose), place), axis, angle));
  return poseOf(turned(column(pose, 0), axis, angle), turned(column(pose, 2), axis, angle), eye);
}

/** @type {(pose: Pose, by: Vector) => Pose} */
export const moved = (pose, by) => poseOf(column(pose, 0), column(pose, 2), add(eyeOf(pose), by));

/**
 * The angle from the upper to the lower edge, in radians.
 * @type {(camera: Camera) => number}
 */
export const angleOf = (camera) => 2 * Math.atan(camera.h / 2 / camera.fl_y);

/**
 * The same view with another angle: the whole lens is scaled, so that pixels keep their shape.
 * @param {Camera} camera
 * @param {number} angle
 * @returns {Camera}
 */
export function withAngle(camera, angle) {
  const factor = camera.h / 2 / Math.tan(angle / 2) / camera.fl_y;
  return { ...camera, fl_x: camera.fl_x * factor, fl_y: camera.fl_y * factor };
}

/**
 * The same view in an image of another size: it shows all that the camera sees, as `Camera::with_size` does.
 * @param {Camera} camera
 * @param {number[]} size
 * @returns {Camera}
 */
export function withSize(camera, [w, h]) {
  if (camera.w === w && camera.h === h) return camera;
  const factor = Math.min(w / camera.w, h / camera.h);
  return {
    ...camera, w, h,
    fl_x: camera.fl_x * factor, fl_y: camera.fl_y * factor,
    cx: w / 2 + (camera.cx - camera.w / 2) * factor, cy: h / 2 + (camera.cy - camera.h / 2) * factor,
  };
}

/**
 * The depth of a point along the camera's axis.
 * @param {Camera} camera
 * @param {Vector} point
 */
export const depthOf = ({ camera_to_world: pose }, point) => dot(forwardOf(pose), sub(point, eyeOf(pose)));

/**
 * Where a point is: column, row, and depth along the camera's axis.
 * @param {Camera} camera
 * @param {Vector} point
 * @returns {[number, number, number]}
 */
export function project(camera, point) {
  const pose = camera.camera_to_world;
  const from = sub(point, eyeOf(pose));
  const depth = depthOf(camera, point);
  const x = dot(column(pose, 0), from);
  const y = -dot(column(pose, 1), from);
  return [camera.fl_x * x / depth + camera.cx, camera.fl_y * y / depth + camera.cy, depth];
}

/**
 * The point at a depth behind a pixel.
 * @param {Camera} camera
 * @param {Pixel} pixel
 * @param {number} depth
 */
export function unproject(camera, [x, y], depth) {
  const pose = camera.camera_to_world;
  const right = (x - camera.cx) / camera.fl_x * depth;
  const down = (y - camera.cy) / camera.fl_y * depth;
  const sideways = add(scale(column(pose, 0), right), scale(column(pose, 1), -down));
  return add(add(eyeOf(pose), sideways), scale(forwardOf(pose), depth));
}

/**
 * The index of the pose that is nearest to a camera, in place and direction; `extent` is half the size of the
 * scene.
 * @param {Camera} camera
 * @param {Pose[]} poses
 * @param {number} extent
 */
export function nearestOf({ camera_to_world: pose }, poses, extent) {
  const turned = (/** @type {Pose} */ other) => length(sub(forwardOf(other), forwardOf(pose)));
  const moved = (/** @type {Pose} */ other) => length(sub(eyeOf(other), eyeOf(pose)));
  const away = (/** @type {Pose} */ other) => moved(other) + 0.5 * extent * turned(other);
  return poses.reduce((best, other, at) => (away(other) < away(poses[best]) ? at : best), 0);
}

/**
 * How far a camera is from the nearest pose: 1 is 20 degrees around the scene's center, as much nearer or
 * farther, or turned by 40.
 * @param {Camera} camera
 * @param {Pose[]} poses
 * @param {Vector} center
 */
export function farness({ camera_to_world: pose }, poses, center) {
  const from = (/** @type {Pose} */ other) => {
    const moved = length(sub(eyeOf(other), eyeOf(pose))) / (0.35 * length(sub(center, eyeOf(other))));
    return Math.max(moved, length(sub(forwardOf(other), forwardOf(pose))) / 0.7);
  };
  return poses.length ? Math.min(...poses.map(from)) : 0;
}

/**
 * What is seen of a picture, before the background: all of it up to 1, and a third from 3 on, where nothing
 * holds the scene together.
 * @type {(far: number) => number}
 */
export const opacityAt = (far) => Math.min(1, Math.max(1 / 3, (4 - far) / 3));

// A scene's background may be outside of 0 to 1: images clamp it.
/** @type {(value: number) => string} */
const byteOf = (value) => Math.round(Math.min(Math.max(value, 0), 1) * 255).toString(16).padStart(2, "0");
/** @type {(color: Vector) => string} */
export const hex = (color) => `#${color.map(byteOf).join("")}`;
