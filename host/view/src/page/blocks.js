// The blocks of a split come in one after the other: images follow until all are there.

/** @import { Frames } from "./frames.js" */
/** @import { FrameAbout } from "./protocol" */

const FOLLOW = 500; // milliseconds between images

export class Blocks {
  follows = 0;
  /** @type {string | null} what the last image lacks, as a sentence */
  lack = null;

  /** @param {Frames} frames */
  constructor(frames) {
    this.frames = frames;
  }

  /** @param {FrameAbout} about of the last image */
  follow({ blocks }) {
    if (!blocks) return;
    const [there, failed, all] = blocks;
    this.lack = failed ? `${failed} of ${all} blocks could not be read; the terminal says why` : null;
    this.frames.refines = there + failed === all;
    clearTimeout(this.follows);
    if (!this.frames.refines) this.follows = setTimeout(() => this.frames.refresh(), FOLLOW);
  }
}
