// A training: its curves, and the buttons to pause, step and stop.

import { post } from "./frames.js";
import { $, css, element } from "./page.js";

/** @import { Frames } from "./frames.js" */
/** @import { TrainingCommand, TrainingState } from "./protocol" */

/** @typedef {(number | null)[][]} Columns The steps, and the values of curves. */

/** uPlot, as far as the page uses it. @type {any} */
const plot = () => /** @type {any} */ (window).uPlot;

const EVERY = 1000; // milliseconds
const number = new Intl.NumberFormat("en");

const BUTTONS = /** @type {const} */ (["pause", "step", "stop"]);

/** @param {number} value in seconds */
function time(value) {
  return value < 90 ? `${value.toFixed(0)} s` : `${Math.floor(value / 60)} min ${Math.floor(value % 60)} s`;
}

/**
 * Options of a chart.
 * @param {boolean} isLog
 * @param {boolean} hasHeldOut
 */
function optionsOf(isLog, hasHeldOut) {
  const quiet = () => css("--quiet");
  const font = "11px system-ui, sans-serif";
  const grid = { stroke: () => css("--line"), width: 1 };
  const axis = { stroke: quiet, font, grid, ticks: { show: false }, gap: 4 };
  /** @type {(chart: object, low: number | null, high: number) => number[]} */
  const range = (_, low, high) => {
    if (low == null) return [0.1, 1];
    return isLog ? plot().rangeLog(low, high, 10, false) : plot().rangeNum(low, high, 0.08, true);
  };
  /** @type {(chart: object, splits: number[]) => (number | null)[]} */
  const few = (_, splits) =>
    splits.map((value) => (isLog && !"125".includes(value.toExponential()[0]) ? null : value));
  const line = (/** @type {string} */ label, /** @type {string} */ color, /** @type {object} */ points) =>
    ({ label, stroke: () => css(color), width: 1.75, spanGaps: true, points });
  const batch = line("batch", "--batch", { show: false });
  const heldOut = line("held out", "--held-out", { show: true, size: 6 });
  return {
    scales: { x: { time: false }, y: { distr: isLog ? 3 : 1, range } },
    series: [{}, batch, ...(hasHeldOut ? [heldOut] : [])],
    axes: [{ ...axis, size: 22, grid: { show: false } }, { ...axis, size: 36, filter: few }],
    legend: { show: hasHeldOut, live: false },
    cursor: { show: false },
  };
}

export class Training {
  /** @type {TrainingState | null} */
  state = null;
  /** @type {string | null} why nothing is trained any more */
  ended = null;
  /** @type {any[]} */
  charts = [];
  /** @type {[number, number][]} steps and seconds */
  recent = [];
  busy = false;

  /** @param {Frames} frames */
  constructor(frames) {
    this.frames = frames;
    $("training").hidden = false;
    const send = (/** @type {TrainingCommand} */ command) => async () => {
      await post("/training", JSON.stringify(command)).catch(() => {});
      await this.poll();
    };
    $("pause").onclick = () => send(this.state?.paused ? "go" : "pause")();
    $("step").onclick = send("step");
    $("stop").onclick = send("stop");
    this.load();
  }

  /**
   * Seconds that are left, by the steps of the last minute; null before there are some, and while nothing
   * goes on.
   * @param {TrainingState} state
   */
  left({ step, steps, seconds, paused }) {
    const [first] = this.recent;
    this.recent.push([step, seconds]);
    if (this.recent.length > 60) this.recent.shift();
    if (!first || paused || step <= first[0]) return null;
    return ((steps - step) * (seconds - first[1])) / (step - first[0]);
  }

  async load() {
    await new Promise((done) => {
      document.head.append(element("script", { src: "uplot.js", onload: done }));
    });
    this.poll();
    setInterval(() => this.poll(), EVERY);
  }

  async poll() {
    if (this.ended || this.busy) return;
    this.busy = true;
    try {
      const before = this.state;
      /** @type {TrainingState} */
      const state = await (await fetch("training.json")).json();
      this.state = state;
      this.show(state);
      // a paused training's scene is refined; a running one's is shown as it is
      this.frames.refines = state.paused;
      if (before && before.step !== state.step) this.frames.refresh();
      else if (before && !before.paused && state.paused) this.frames.settle();
    } catch {
      this.ended = "The program has ended.";
      if (this.state) this.show(this.state);
    }
    this.busy = false;
  }

  /** @param {TrainingState} state */
  show(state) {
    const { step, steps, paused, stopping, seconds, share, curve, evaluations } = state;
    const { ended } = this;
    const left = ended ? null : this.left(state);
    const facts = [`step ${number.format(step)} of ${number.format(steps)}`, time(seconds)];
    if (left != null) facts.push(`${time(left)} left`);
    if (share > 0.005) facts.push(`images take ${(100 * share).toFixed(0)}%`);
    $("progress").textContent = ended ?? facts.join(" · ");
    const bar = /** @type {HTMLElement} */ ($("bar").firstElementChild);
    bar.style.width = `${(100 * step) / Math.max(1, steps)}%`;
    $("pause").textContent = paused ? "Go on" : "Pause";
    for (const id of BUTTONS) $(id).disabled = Boolean(ended) || stopping;
    if (stopping) $("stop").textContent = ended ? "Stopped" : "Stopping…";
    if (!plot()) return;
    this.chart(0, "Loss", [curve.step, curve.loss], null, true);
    this.chart(1, "PSNR, dB", [curve.step, curve.psnr], [evaluations.step, evaluations.psnr], false);
  }

  /**
   * @param {number} at
   * @param {string} title
   * @param {Columns} batch
   * @param {Columns | null} heldOut
   * @param {boolean} isLog
   */
  chart(at, title, batch, heldOut, isLog) {
    const none = batch[0].map(() => null);
    let columns = batch;
    if (heldOut) columns = heldOut[0].length ? plot().join([batch, heldOut]) : [...batch, none];
    if (this.charts[at]) return this.charts[at].setData(columns);
    if (batch[0].length < 2) return;
    const box = element("div", { className: "chart" }, element("b", {}, title));
    $("charts").append(box);
    const size = () => ({ width: box.clientWidth, height: 130 });
    const options = { ...size(), ...optionsOf(isLog, Boolean(heldOut)) };
    this.charts[at] = new (plot())(options, columns, box);
    new ResizeObserver(() => this.charts[at].setSize(size())).observe(box);
  }
}
