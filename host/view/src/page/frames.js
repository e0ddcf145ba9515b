// Asks for images: one at a time while the camera moves, so that the newest camera is next; then a whole one, then the exact one.

const REST = 140; // milliseconds without a movement
const client = crypto.getRandomValues(new Uint32Array(1))[0];

export class Frames {
  // `current()` is what to ask for; `show(bitmap, about, bytes)` is called with each image.
  constructor(current, show, fail) {
    Object.assign(this, { current, show, fail });
    this.sequence = 0;
    this.wanted = null; // the quality to ask for next
    this.busy = false;
    this.rest = 0;
    this.times = [];
    this.abort = null;
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
    const request = { client, sequence: ++this.sequence, quality, ...this.current() };
    this.abort = new AbortController();
    try {
      const reply = await post("/frame", request, this.abort.signal);
      const blob = await reply.blob();
      const about = JSON.parse(reply.headers.get("x-organza"));
      const bitmap = await createImageBitmap(blob);
      this.count(quality);
      this.show(bitmap, about, blob, request);
      this.fail(null);
      if (quality === "still" && !this.wanted && this.refines !== false) this.wanted = "exact";
    } catch (error) {
      if (error.name !== "AbortError" && error.status !== 409) {
        this.fail(error.message);
        // the program may be back soon
        if (!error.status) setTimeout(() => this.settle(), 1500);
      }
    }
    this.busy = false;
    this.quality = null;
    this.idle?.();
    this.next();
  }

  // Images of the last second while moving.
  count(quality) {
    const now = performance.now();
    if (quality !== "moving") return;
    this.times.push(now);
    this.times = this.times.filter((time) => now - time < 1000);
  }

  get rate() {
    const [first, last] = [this.times[0], this.times.at(-1)];
    return this.times.length < 2 || performance.now() - last > 1000 ? null : ((this.times.length - 1) * 1000) / (last - first);
  }
}

// Sends JSON; throws what the program says where it refuses.
export async function post(path, value, signal) {
  const body = typeof value === "string" ? value : JSON.stringify(value);
  let reply;
  try {
    reply = await fetch(path, { method: "POST", headers: { "content-type": "application/json" }, body, signal });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Error("The program does not answer. Is it still running?");
  }
  if (reply.ok) return reply;
  const { error } = await reply.json().catch(() => ({ error: reply.statusText }));
  throw Object.assign(new Error(error), { status: reply.status });
}
