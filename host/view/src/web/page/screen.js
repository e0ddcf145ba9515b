// Shows an image that lies on the device as tiles, [tiles, 3, S, S], enlarged to the canvas.

import { columnsOf } from "./player.js";

/** @import { Camera } from "../../page/protocol" */
/** @import { Frame } from "./player.js" */

const SHADER = `
struct View { side: u32, columns: u32, size: vec2u, canvas: vec2f }
@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> image: array<f32>;

@vertex fn corner(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
  return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

fn color(at: vec2i) -> vec3f {
  let p = vec2u(clamp(at, vec2i(0), vec2i(view.size) - 1));
  let area = view.side * view.side;
  let tile = (p.y / view.side) * view.columns + p.x / view.side;
  let first = tile * 3u * area + (p.y % view.side) * view.side + p.x % view.side;
  return clamp(vec3f(image[first], image[first + area], image[first + 2u * area]), vec3f(0.0), vec3f(1.0));
}

@fragment fn pixel(@builtin(position) position: vec4f) -> @location(0) vec4f {
  let at = position.xy / view.canvas * vec2f(view.size) - 0.5;
  let corner = vec2i(floor(at));
  let part = at - floor(at);
  let upper = mix(color(corner), color(corner + vec2i(1, 0)), part.x);
  let lower = mix(color(corner + vec2i(0, 1)), color(corner + vec2i(1, 1)), part.x);
  return vec4f(mix(upper, lower, part.y), 1.0);
}`;

export class Screen {
  /**
   * @param {GPUDevice} device
   * @param {HTMLCanvasElement} canvas
   */
  constructor(device, canvas) {
    this.device = device;
    this.canvas = canvas;
    const format = navigator.gpu.getPreferredCanvasFormat();
    this.context = /** @type {GPUCanvasContext} */ (canvas.getContext("webgpu"));
    this.context.configure({ device, format, alphaMode: "opaque" });
    const module = device.createShaderModule({ label: "screen", code: SHADER });
    this.pipeline = device.createRenderPipeline({
      label: "screen", layout: "auto", vertex: { module }, fragment: { module, targets: [{ format }] },
      primitive: { topology: "triangle-list" },
    });
    const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
    this.view = device.createBuffer({ size: 32, usage });
  }

  /**
   * Shows what a frame has rendered of a camera.
   * @param {Frame} frame
   * @param {Camera} camera
   */
  show(frame, camera) {
    const { device, canvas } = this;
    const { side } = frame.plan;
    const values = new ArrayBuffer(32);
    new Uint32Array(values).set([side, columnsOf(camera, side), camera.w, camera.h]);
    new Float32Array(values).set([canvas.width, canvas.height], 4);
    device.queue.writeBuffer(this.view, 0, values);
    const group = device.createBindGroup({
      layout: this.pipeline.getBindGroupLayout(0),
      entries: [this.view, frame.image].map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
    const encoder = device.createCommandEncoder();
    const view = this.context.getCurrentTexture().createView();
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }] });
    pass.setPipeline(this.pipeline);
    pass.setBindGroup(0, group);
    pass.draw(3);
    pass.end();
    device.queue.submit([encoder.finish()]);
  }
}
