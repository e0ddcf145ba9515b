// Asks for images: one at a time while the camera moves, so that the newest camera is next; then a whole one,
// then the exact one.

import { reason } from "./page.js";

/** @import { FrameAbout, FrameRequest, Quality } from "./protocol" */

/** @typedef {Pick<FrameRequest, "camera" | "mode" | "background" | "view">} Shown What an image shows. */
/** @typedef {(bitmap: ImageBitmap, about: FrameAbout, blob: Blob, asked: FrameRequest) => void} Show */

const REST = 140; // milliseconds without a movement
const client = crypto.getRandomValues(new Uint32Array(1))[0];

export class Frames {
  sequence = 0;
  /** @type {Quality | null} to ask for next */
  wanted = null;
  /** @type {Quality | null} that is asked for now */
  quality = null;
  busy = false;
  /** Whether an image at rest becomes exact. */
  refines = true;
  rest = 0;
  /** @type {number[]} of the images of the last second */
  times = [];
  /** @type {AbortController | null} */
  abort = null;
  /** Called after each request. */
  idle = () => {};

  /**
   * @param {() => Shown} current what to ask for
   * @param {Show} show is called with each image
   * @param {(message: string | null) => void} fail is called with each error, and after it is over
   */
  constructor(current, show, fail) {
    this.current = current;
    this.show = show;
    this.fail = fail;
  }

  // The camera moves, or something else changed that has to be seen at once.
  change() {
    this.wanted = "moving";
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.settle(), REST);
    if (this.quality === "exact" || this.quality === "still") this.abort?.abort();
    this.next();
  }

  // Everything that is asked for is exact in the end.
  settle() {
    clearTimeout(this.rest);
    this.wanted = "still";
    this.next();
  }

  // The scene has changed: a whole image, which is not worth refining.
  refresh() {
    if (this.wanted || this.busy) return;
    this.wanted = "still";
    this.next();
  }

  async next() {
    if (this.busy || !this.wanted) return;
    const quality = this.wanted;
    this.wanted = null;
    this.busy = true;
    this.quality = quality;
    /** @type {FrameRequest} */
    const request = { client, sequence: ++this.sequence, quality, ...this.current() };
    this.abort = new AbortController();
    try {
      const reply = await post("/frame", request, this.abort.signal);
      const blob = await reply.blob();
      const about = JSON.parse(reply.headers.get("x-organza") ?? "");
      const bitmap = await createImageBitmap(blob);
      this.count(quality);
      this.show(bitmap, about, blob, request);
      this.fail(null);
      if (quality === "still" && !this.wanted && this.refines) this.wanted = "exact";
    } catch (error) {
      const status = error instanceof Refusal ? error.status : 0;
      if (!isAbort(error) && status !== 409) {
        this.fail(reason(error));
        // the program may be back soon
        if (!status) setTimeout(() => this.settle(), 1500);
      }
    }
    this.busy = false;
    this.quality = null;
    this.idle();
    this.next();
  }

  /** The exact image of what is asked for now; null where the program refuses. */
  async exact() {
    try {
      const request = { client: 0, sequence: Date.now(), quality: "exact", ...this.current() };
      return await (await post("/frame", request)).blob();
    } catch (error) {
      this.fail(reason(error));
      return null;
    }
  }

  /**
   * Images of the last second while moving.
   * @param {Quality} quality
   */
  count(quality) {
    const now = performance.now();
    if (quality !== "moving") return;
    this.times.push(now);
    this.times = this.times.filter((time) => now - time < 1000);
  }

  /** Images a second; null at rest. */
  get rate() {
    const first = this.times[0];
    const last = this.times[this.times.length - 1];
    if (this.times.length < 2 || performance.now() - last > 1000) return null;
    return ((this.times.length - 1) * 1000) / (last - first);
  }
}

// The program has refused a request.
class Refusal extends Error {
  /**
   * @param {string} message
   * @param {number} status of HTTP
   */
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

/** @param {unknown} error */
const isAbort = (error) => error instanceof DOMException && error.name === "AbortError";

/**
 * Sends JSON; throws what the program says where it refuses.
 * @param {string} path
 * @param {unknown} value text is sent as it is
 * @param {AbortSignal} [signal]
 */
export async function post(path, value, signal) {
  const body = typeof value === "string" ? value : JSON.stringify(value);
  let reply;
  try {
    const headers = { "content-type": "application/json" };
    reply = await fetch(path, { method: "POST", headers, body, signal });
  } catch (error) {
    if (isAbort(error)) throw error;
    throw new Error("The program does not answer. Is it still running?");
  }
  if (reply.ok) return reply;
  const { error } = await reply.json().catch(() => ({ error: reply.statusText }));
  throw new Refusal(error, reply.status);
}
