// Plays frames that organza has planned: buffers, and dispatches of kernels. A frame waits for nothing before its end.

import { column, cross, dot, scale, sub } from "./camera.js";

const SLOT = 256; // bytes of the uniform buffer for each dispatch

// What the page's script carries: its header, and the words of the scene's buffers.
export async function unpack(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  let at = 4 + Math.ceil(length / 4) * 4;
  const buffers = header.buffers.map((size) => {
    // the first bytes of all words come first
    const words = new Uint8Array(size), count = size / 4;
    for (let place = 0; place < 4; place++) {
      for (let word = 0; word < count; word++) words[4 * word + place] = bytes[at++];
    }
    return words;
  });
  return { header, buffers };
}

// A scene on a device.
export class Player {
  static async open(device, { header, buffers }) {
    const player = new Player();
    Object.assign(player, { device, header, plans: header.plans, pipelines: new Map() });
    const type = { uniform: "uniform", read: "read-only-storage", write: "storage" };
    await Promise.all(header.kernels.map(async ({ name, access, code }) => {
      const entries = access.map((kind, binding) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer: { type: type[kind] } }));
      const layout = device.createBindGroupLayout({ label: name, entries });
      const module = device.createShaderModule({ label: name, code });
      const pipeline = await device.createComputePipelineAsync({
        label: name, layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }), compute: { module, entryPoint: name },
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

  buffer(size, usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC) {
    return this.device.createBuffer({ size, usage: usage | GPUBufferUsage.COPY_DST });
  }

  bind(name, resources) {
    const entries = resources.map((resource, binding) => ({ binding, resource }));
    return this.device.createBindGroup({ label: name, layout: this.pipelines.get(name).layout, entries });
  }
}

// A plan with its memory: renders one image after another.
export class Frame {
  constructor(player, plan) {
    Object.assign(this, { player, plan });
    const { device } = player, { queue } = device;
    const own = plan.buffers.map((size) => player.buffer(size));
    const buffers = [...player.buffers, ...own], filled = new Map(plan.contents);
    this.cleared = own.filter((_, at) => !filled.has(player.buffers.length + at));
    for (const [at, words] of filled) queue.writeBuffer(buffers[at], 0, new Uint32Array(words));
    [this.counts, this.image] = [plan.counts, plan.image].map((at) => buffers[at]);
    this.cameras = plan.cameras.map(([at, place]) => [buffers[at], place]);
    this.places = plan.places.map((at) => buffers[at]);

    const dispatches = plan.frame.filter(([name]) => player.pipelines.has(name)).length;
    const uniforms = player.buffer(SLOT * dispatches, GPUBufferUsage.UNIFORM | GPUBufferUsage.STORAGE);
    const parameters = new Uint32Array((SLOT / 4) * dispatches);
    this.staging = player.buffer(this.counts.size, GPUBufferUsage.MAP_READ);
    this.memory = [...own, uniforms, this.staging];

    // everything is bound once; counts are filled in where they are published, for all dispatches up to the next time
    this.steps = [];
    let following = [], fills = new Map(), slot = 0;
    const publish = () => {
      for (const [counts, rows] of fills) {
        const values = new Uint32Array([rows.length, 0, 0, 0, ...rows.flat()]), placement = player.buffer(values.byteLength);
        queue.writeBuffer(placement, 0, values);
        this.memory.push(placement);
        const resources = [placement, buffers[counts], uniforms].map((buffer) => ({ buffer }));
        this.steps.push({ run: player.pipelines.get("count_fill").pipeline, group: player.bind("count_fill", resources), workgroups: [Math.ceil(rows.length / 64), 1, 1] });
      }
      this.steps.push(...following);
      [following, fills] = [[], new Map()];
    };
    for (const [name, ...rest] of plan.frame) {
      if (name === "publish") publish();
      else if (name === "clear") following.push({ clear: [buffers[rest[0]], rest[1], rest[2]] });
      else if (name === "copy") following.push({ copy: [buffers[rest[0]], rest[1], buffers[rest[3]], rest[4], rest[2]] });
      else {
        const [words, counts, bound, workgroups] = rest, { access, pipeline } = player.pipelines.get(name);
        const first = (slot++ * SLOT) / 4, parts = bound[Symbol.iterator]();
        parameters.set(words, first);
        for (const [word, buffer, ...row] of counts) {
          if (!fills.has(buffer)) fills.set(buffer, []);
          fills.get(buffer).push([first + word, ...row]);
        }
        const resources = access.map((kind) => {
          if (kind === "uniform") return { buffer: uniforms, offset: first * 4, size: Math.ceil(words.length / 4) * 16 };
          const [buffer, offset, size] = parts.next().value;
          return { buffer: buffers[buffer], offset, size };
        });
        following.push({ run: pipeline, group: player.bind(name, resources), workgroups });
      }
    }
    publish();
    queue.writeBuffer(uniforms, 0, parameters);
  }

  // Renders an image of a camera, which the plan has enough tiles for. Gives whether there was too little room, and how many pairs,
  // intersections and samples there are: of each scene, and in all.
  async render(camera) {
    const { device } = this.player, { tiles, side } = this.plan;
    for (const [buffer, place] of this.cameras) device.queue.writeBuffer(buffer, 0, packed(camera, place));
    for (const buffer of this.places) device.queue.writeBuffer(buffer, 0, cover(camera, side, tiles));
    const encoder = device.createCommandEncoder();
    for (const buffer of this.cleared) encoder.clearBuffer(buffer);
    let pass = null;
    const end = () => { pass?.end(); pass = null; };
    for (const step of this.steps) {
      if (step.run) {
        pass ??= encoder.beginComputePass();
        pass.setPipeline(step.run);
        pass.setBindGroup(0, step.group);
        pass.dispatchWorkgroups(...step.workgroups);
      } else {
        end();
        if (step.clear) encoder.clearBuffer(...step.clear);
        else encoder.copyBufferToBuffer(...step.copy);
      }
    }
    end();
    encoder.copyBufferToBuffer(this.counts, 0, this.staging, 0, this.staging.size);
    device.queue.submit([encoder.finish()]);
    await this.staging.mapAsync(GPUMapMode.READ);
    const needed = [...new Uint32Array(this.staging.getMappedRange())];
    this.staging.unmap();
    // of each scene, and of its light in each other one
    const slots = needed.length / this.cameras.length;
    const [overflow, ...counts] = [0, 1, 2, 3].map((slot) => needed.filter((_, at) => at % slots === slot).reduce((one, other) => one + other));
    return { overflow, needed, counts };
  }

  get bytes() {
    return this.memory.reduce((sum, buffer) => sum + buffer.size, 0);
  }

  close() {
    for (const buffer of this.memory) buffer.destroy();
  }
}

export const columnsOf = (camera, side) => Math.ceil(camera.w / side);
export const tilesOf = (camera, side) => columnsOf(camera, side) * Math.ceil(camera.h / side);

// A camera as kernels read it, with OpenCV axes, in the coordinates of a place: `Placement::own_camera` and `Camera::pack`.
function packed(camera, { offset, scale: units, up, right }) {
  const pose = camera.camera_to_world, axes = [right, cross(up, right), up];
  const own = (vector, factor) => scale(axes.map((axis) => dot(axis, vector)), factor), axis = (at, sign) => own(column(pose, at), sign);
  return new Float32Array([
    ...axis(0, 1), ...axis(1, -1), ...axis(2, -1), ...own(sub(column(pose, 3), offset), 1).map((x) => x / units),
    camera.fl_x, camera.fl_y, camera.cx, camera.cy, camera.w, camera.h,
  ]);
}

// Tiles that cover an image, as kernels read them: `Tile::pack`. Those that are left over are far outside.
function cover(camera, side, tiles) {
  const columns = columnsOf(camera, side), needed = tilesOf(camera, side), values = new Int32Array(4 * tiles);
  for (let tile = 0; tile < tiles; tile++) {
    const [x, y] = tile < needed ? [tile % columns, Math.floor(tile / columns)].map((at) => at * side) : [-1e6, -1e6];
    values.set([0, x, y, tile], 4 * tile);
  }
  return values;
}
