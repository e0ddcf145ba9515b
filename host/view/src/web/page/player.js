// Plays frames that organza has planned: buffers, and dispatches of kernels. A frame waits for nothing before
// its end.

import { column, cross, dot, scale, sub } from "./camera.js";

/** @import { Camera, Placement, Vector } from "../../page/protocol" */
/** @import { BufferPart, Content, CountRow, Dispatch, Header, Plan } from "./types" */

/** @typedef {{ layout: GPUBindGroupLayout, pipeline: GPUComputePipeline, access: string[] }} Pipeline */

/** @typedef {{ run: GPUComputePipeline, group: GPUBindGroup, workgroups: [number, number, number] }} Run */
/** @typedef {{ clear: [GPUBuffer, number, number] }} Clear */
/** @typedef {{ copy: [GPUBuffer, number, GPUBuffer, number, number] }} Copy */

const SLOT = 256; // bytes of the uniform buffer for each dispatch

/**
 * What the page's script carries: its header, and the words of the scene's buffers.
 * @param {string} text
 * @returns {Promise<Content>}
 */
export async function unpack(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const length = new DataView(bytes.buffer).getUint32(0, true);
  /** @type {Header} */
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  let at = 4 + Math.ceil(length / 4) * 4;
  const buffers = header.buffers.map((size) => {
    // the first bytes of all words come first
    const words = new Uint8Array(size);
    const count = size / 4;
    for (let place = 0; place < 4; place++) {
      for (let word = 0; word < count; word++) words[4 * word + place] = bytes[at++];
    }
    return words;
  });
  return { header, buffers };
}

// A scene on a device.
export class Player {
  /** @type {Map<string, Pipeline>} by the names of kernels */
  pipelines = new Map();
  /** @type {GPUBuffer[]} of the scene */
  buffers = [];

  /**
   * @param {GPUDevice} device
   * @param {Header} header
   */
  constructor(device, header) {
    this.device = device;
    this.header = header;
  }

  /**
   * @param {GPUDevice} device
   * @param {Content} content
   */
  static async open(device, { header, buffers }) {
    const player = new Player(device, header);
    const types = /** @type {const} */ ({ uniform: "uniform", read: "read-only-storage", write: "storage" });
    await Promise.all(header.kernels.map(async ({ name, access, code }) => {
      const visibility = GPUShaderStage.COMPUTE;
      const entries = access.map((kind, binding) => ({ binding, visibility, buffer: { type: types[kind] } }));
      const layout = device.createBindGroupLayout({ label: name, entries });
      const module = device.createShaderModule({ label: name, code });
      const pipeline = await device.createComputePipelineAsync({
        label: name,
        layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
        compute: { module, entryPoint: name },
      });
      player.pipelines.set(name, { layout, pipeline, access });
    }));
    player.buffers = buffers.map((words) => {
      const buffer = player.buffer(words.length);
      device.queue.writeBuffer(buffer, 0, words);
      return buffer;
    });
    return player;
  }

  /**
   * @param {number} size in bytes
   * @param {number} usage
   */
  buffer(size, usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC) {
    return this.device.createBuffer({ size, usage: usage | GPUBufferUsage.COPY_DST });
  }

  /** @param {string} name of a kernel */
  pipeline(name) {
    const pipeline = this.pipelines.get(name);
    if (!pipeline) throw new Error(`the page lacks the kernel ${name}`);
    return pipeline;
  }

  /**
   * @param {string} name of a kernel
   * @param {GPUBufferBinding[]} resources
   */
  bind(name, resources) {
    const entries = resources.map((resource, binding) => ({ binding, resource }));
    return this.device.createBindGroup({ label: name, layout: this.pipeline(name).layout, entries });
  }
}

// A plan with its memory: renders one image after another.
export class Frame {
  /** @type {(Run | Clear | Copy)[]} */
  steps = [];

  /**
   * @param {Player} player
   * @param {Plan} plan
   */
  constructor(player, plan) {
    this.player = player;
    this.plan = plan;
    const { queue } = player.device;
    const own = plan.buffers.map((size) => player.buffer(size));
    const buffers = [...player.buffers, ...own];
    const filled = new Map(plan.contents);
    this.cleared = own.filter((_, at) => !filled.has(player.buffers.length + at));
    for (const [at, words] of filled) queue.writeBuffer(buffers[at], 0, new Uint32Array(words));
    this.counts = buffers[plan.counts];
    this.image = buffers[plan.image];
    this.cameras = plan.cameras.map(([at, place]) => ({ buffer: buffers[at], place }));
    this.places = plan.places.map((at) => buffers[at]);

    const dispatches = plan.frame.filter(([name]) => player.pipelines.has(name)).length;
    const uniforms = player.buffer(SLOT * dispatches, GPUBufferUsage.UNIFORM | GPUBufferUsage.STORAGE);
    const parameters = new Uint32Array((SLOT / 4) * dispatches);
    this.staging = player.buffer(this.counts.size, GPUBufferUsage.MAP_READ);
    this.memory = [...own, uniforms, this.staging];

    // everything is bound once; counts are filled in where they are published, for all dispatches up to the
    // next time
    /** @type {Frame["steps"]} */
    let following = [];
    /** @type {Map<number, number[][]>} */
    let fills = new Map();
    let slot = 0;
    const publish = () => {
      for (const [counts, rows] of fills) this.steps.push(this.fill(rows, buffers[counts], uniforms));
      this.steps.push(...following);
      following = [];
      fills = new Map();
    };
    for (const step of plan.frame) {
      if (isPublish(step)) publish();
      else if (isClear(step)) following.push({ clear: [buffers[step[1]], step[2], step[3]] });
      else if (isCopy(step)) {
        const [, from, begin, bytes, to, at] = step;
        following.push({ copy: [buffers[from], begin, buffers[to], at, bytes] });
      } else {
        const [name, words, counts, bound, workgroups] = step;
        const { access, pipeline } = player.pipeline(name);
        const first = (slot * SLOT) / 4;
        slot += 1;
        parameters.set(words, first);
        for (const [word, buffer, ...row] of counts) {
          const rows = fills.get(buffer) ?? [];
          rows.push([first + word, ...row]);
          fills.set(buffer, rows);
        }
        const parts = bound[Symbol.iterator]();
        const resources = access.map((kind) => {
          const size = Math.ceil(words.length / 4) * 16;
          if (kind === "uniform") return { buffer: uniforms, offset: first * 4, size };
          const [buffer, offset, bytes] = /** @type {BufferPart} */ (parts.next().value);
          return { buffer: buffers[buffer], offset, size: bytes };
        });
        following.push({ run: pipeline, group: player.bind(name, resources), workgroups });
      }
    }
    publish();
    queue.writeBuffer(uniforms, 0, parameters);
  }

  /**
   * Fills counts into the parameters of dispatches.
   * @param {number[][]} rows
   * @param {GPUBuffer} counts
   * @param {GPUBuffer} uniforms
   * @returns {Run}
   */
  fill(rows, counts, uniforms) {
    const { player } = this;
    const values = new Uint32Array([rows.length, 0, 0, 0, ...rows.flat()]);
    const placement = player.buffer(values.byteLength);
    player.device.queue.writeBuffer(placement, 0, values);
    this.memory.push(placement);
    const group = player.bind("count_fill", [placement, counts, uniforms].map((buffer) => ({ buffer })));
    const { pipeline } = player.pipeline("count_fill");
    return { run: pipeline, group, workgroups: [Math.ceil(rows.length / 64), 1, 1] };
  }

  /**
   * Renders an image of a camera, which the plan has enough tiles for. Gives whether there was too little
   * room, and how many pairs, intersections and samples there are: of each scene, and in all.
   * @param {Camera} camera
   */
  async render(camera) {
    const { device } = this.player;
    const { tiles, side } = this.plan;
    for (const { buffer, place } of this.cameras) device.queue.writeBuffer(buffer, 0, packed(camera, place));
    for (const buffer of this.places) device.queue.writeBuffer(buffer, 0, cover(camera, side, tiles));
    const encoder = device.createCommandEncoder();
    for (const buffer of this.cleared) encoder.clearBuffer(buffer);
    /** @type {GPUComputePassEncoder | null} */
    let pass = null;
    for (const step of this.steps) {
      if ("run" in step) {
        pass ??= encoder.beginComputePass();
        pass.setPipeline(step.run);
        pass.setBindGroup(0, step.group);
        pass.dispatchWorkgroups(...step.workgroups);
      } else {
        pass?.end();
        pass = null;
        if ("clear" in step) encoder.clearBuffer(...step.clear);
        else encoder.copyBufferToBuffer(...step.copy);
      }
    }
    pass?.end();
    encoder.copyBufferToBuffer(this.counts, 0, this.staging, 0, this.staging.size);
    device.queue.submit([encoder.finish()]);
    await this.staging.mapAsync(GPUMapMode.READ);
    const needed = [...new Uint32Array(this.staging.getMappedRange())];
    this.staging.unmap();
    // of each scene, and of its light in each other one
    const slots = needed.length / this.cameras.length;
    const all = (/** @type {number} */ slot) => needed.filter((_, at) => at % slots === slot);
    const [overflow, ...counts] = [0, 1, 2, 3].map((slot) => all(slot).reduce((one, other) => one + other));
    return { overflow, needed, counts };
  }

  get bytes() {
    return this.memory.reduce((sum, buffer) => sum + buffer.size, 0);
  }

  close() {
    for (const buffer of this.memory) buffer.destroy();
  }
}

/** @typedef {Plan["frame"][number]} Step */
/** @type {(step: Step) => step is ["publish"]} */
const isPublish = (step) => step[0] === "publish";
/** @type {(step: Step) => step is import("./types").Clear} */
const isClear = (step) => step[0] === "clear";
/** @type {(step: Step) => step is import("./types").Copy} */
const isCopy = (step) => step[0] === "copy";

/** @type {(camera: Camera, side: number) => number} */
export const columnsOf = (camera, side) => Math.ceil(camera.w / side);
/** @type {(camera: Camera, side: number) => number} */
export const tilesOf = (camera, side) => columnsOf(camera, side) * Math.ceil(camera.h / side);

/**
 * A camera as kernels read it, with OpenCV axes, in the coordinates of a place: `Placement::own_camera` and
 * `Camera::pack`.
 * @param {Camera} camera
 * @param {Placement} placement
 */
function packed(camera, { offset, scale: units, up, right }) {
  const pose = camera.camera_to_world;
  const axes = [right, cross(up, right), up];
  /** @type {(vector: Vector, factor: number) => Vector} */
  const own = (vector, factor) => scale(axes.map((axis) => dot(axis, vector)), factor);
  /** @type {(at: number, sign: number) => Vector} */
  const axis = (at, sign) => own(column(pose, at), sign);
  const eye = own(sub(column(pose, 3), offset), 1).map((x) => x / units);
  return new Float32Array([
    ...axis(0, 1), ...axis(1, -1), ...axis(2, -1), ...eye,
    camera.fl_x, camera.fl_y, camera.cx, camera.cy, camera.w, camera.h,
  ]);
}

/**
 * Tiles that cover an image, as kernels read them: `Tile::pack`. Those that are left over are far outside.
 * @param {Camera} camera
 * @param {number} side
 * @param {number} tiles
 */
function cover(camera, side, tiles) {
  const columns = columnsOf(camera, side);
  const needed = tilesOf(camera, side);
  const values = new Int32Array(4 * tiles);
  for (let tile = 0; tile < tiles; tile++) {
    const x = (tile % columns) * side;
    const y = Math.floor(tile / columns) * side;
    values.set(tile < needed ? [0, x, y, tile] : [0, -1e6, -1e6, tile], 4 * tile);
  }
  return values;
}
