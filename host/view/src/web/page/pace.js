// Which plan an image is rendered with: how small it is and how long the steps of T are while the camera
// moves, and how much memory it needs.

/** @import { Plan } from "./types" */

// milliseconds that an image takes while the camera moves
const FAST = 18;
const SLOW = 45;
const PATIENCE = 2500; // milliseconds that the image at rest may take

export class Pace {
  /** Sides are divided by this while moving. */
  shrink = 4;
  /** @type {Map<string, number>} of each size and step, the index of the capacity that sufficed last */
  level = new Map();

  /** @param {Plan[]} plans of one size and step, from small to large capacities */
  constructor(plans) {
    this.plans = plans;
    this.steps = [...new Set(plans.map((plan) => plan.steps))].sort((a, b) => a - b);
    this.coarse = this.steps.length - 1; // the index of the steps while moving
  }

  /**
   * @param {number} tiles
   * @param {number} steps
   */
  key(tiles, steps) {
    return `${tiles}/${steps}`;
  }

  /**
   * The plans with enough tiles of the smallest such size, from small to large capacities; none where no size
   * is large enough.
   * @param {number} tiles
   * @param {number} steps
   */
  ladder(tiles, steps) {
    const enough = this.plans.filter((plan) => plan.tiles >= tiles && plan.steps === steps);
    const fewest = Math.min(...enough.map((plan) => plan.tiles));
    return enough.filter((plan) => plan.tiles === fewest);
  }

  /**
   * The plan for this number of tiles; none if all plans were too small.
   * @param {number} tiles
   * @param {number} steps
   * @returns {Plan | undefined}
   */
  plan(tiles, steps) {
    const ladder = this.ladder(tiles, steps);
    return ladder[this.level.get(this.key(ladder[0]?.tiles ?? 0, steps)) ?? 0];
  }

  /**
   * A plan was too small: the next one is taken.
   * @param {Plan} plan
   */
  tooSmall(plan) {
    const ladder = this.ladder(plan.tiles, plan.steps);
    this.level.set(this.key(plan.tiles, plan.steps), ladder.indexOf(plan) + 1);
  }

  /**
   * A frame has needed this; the smallest plan that holds it is the next one.
   * @param {Plan} plan
   * @param {number[]} needed
   */
  sufficed(plan, needed) {
    const ladder = this.ladder(plan.tiles, plan.steps);
    const level = ladder.findIndex(({ capacity }) => needed.every((count, at) => count <= capacity[at]));
    this.level.set(this.key(plan.tiles, plan.steps), level);
  }

  /** Forgets that plans were too small: the camera is elsewhere. */
  forgive() {
    for (const [key, level] of this.level) {
      const [tiles, steps] = key.split("/").map(Number);
      if (level >= this.ladder(tiles, steps).length) this.level.set(key, 0);
    }
  }

  /**
   * Called after an image while moving.
   * @param {number} time that it took, in milliseconds
   * @param {number} least the smallest shrink that there are plans for
   */
  learn(time, least) {
    if (time > SLOW) {
      if (this.coarse < this.steps.length - 1) this.coarse += 1;
      else this.shrink = Math.min(12, this.shrink * Math.min(2, Math.sqrt(time / SLOW) + 0.05));
    } else if (time < FAST) {
      if (this.shrink > least) this.shrink = Math.max(least, this.shrink / 1.25);
      else if (this.coarse > 0) this.coarse -= 1;
    }
  }

  /**
   * The shrink at rest, after an image with all samples.
   * @param {number} time that it took, in milliseconds
   * @param {number} shrink of that image
   * @param {number} least the smallest shrink that there are plans for
   */
  rest(time, shrink, least) {
    return Math.max(least, shrink * Math.min(1, Math.sqrt(time / PATIENCE)));
  }
}
