// A training: its curves, and the buttons to pause, step and stop.

import { post } from "./frames.js";
import { $, css, element } from "./page.js";

const EVERY = 1000; // milliseconds
const number = new Intl.NumberFormat("en");

export class Training {
  constructor(frames) {
    Object.assign(this, { frames, state: null, charts: [], recent: [] });
    $("training").hidden = false;
    const send = (command) => async () => {
      await post("/training", JSON.stringify(command)).catch(() => {});
      await this.poll();
    };
    $("pause").onclick = () => send(this.state?.paused ? "go" : "pause")();
    $("step").onclick = send("step");
    $("stop").onclick = send("stop");
    this.load();
  }

  // Seconds that are left, by the steps of the last minute; null before there are some, and while nothing goes on.
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
    if (this.state?.ended || this.busy) return;
    this.busy = true;
    try {
      const before = this.state;
      this.state = await (await fetch("training.json")).json();
      this.show();
      // a paused training's scene is refined; a running one's is shown as it is
      this.frames.refines = this.state.paused;
      if (before && before.step !== this.state.step) this.frames.refresh();
      else if (before && !before.paused && this.state.paused) this.frames.settle();
    } catch {
      this.state = { ...this.state, ended: "The program has ended." };
      this.show();
    }
    this.busy = false;
  }

  show() {
    const { step, steps, paused, stopping, ended, seconds, share, curve, evaluations } = this.state;
    const time = (value) => (value < 90 ? `${value.toFixed(0)} s` : `${Math.floor(value / 60)} min ${Math.floor(value % 60)} s`);
    const left = ended ? null : this.left(this.state);
    const facts = [`step ${number.format(step)} of ${number.format(steps)}`, time(seconds ?? 0)];
    if (left != null) facts.push(`${time(left)} left`);
    if (share > 0.005) facts.push(`images take ${(100 * share).toFixed(0)}%`);
    $("progress").textContent = ended ?? facts.join(" · ");
    $("bar").firstElementChild.style.width = `${(100 * step) / Math.max(1, steps)}%`;
    $("pause").textContent = paused ? "Go on" : "Pause";
    for (const id of ["pause", "step", "stop"]) $(id).disabled = Boolean(ended) || stopping;
    if (stopping) $("stop").textContent = ended ? "Stopped" : "Stopping…";
    if (!curve || !window.uPlot) return;
    this.chart(0, "Loss", [curve.step, curve.loss], null, true);
    this.chart(1, "PSNR, dB", [curve.step, curve.psnr], [evaluations.step, evaluations.psnr]);
  }

  chart(at, title, batch, heldOut, isLog) {
    const columns = heldOut?.[0].length ? uPlot.join([batch, heldOut]) : heldOut ? [...batch, batch[0].map(() => null)] : batch;
    if (this.charts[at]) return this.charts[at].setData(columns);
    if (batch[0].length < 2) return;
    const box = element("div", { className: "chart" }, element("b", {}, title));
    $("charts").append(box);
    const quiet = () => css("--quiet"), font = "11px system-ui, sans-serif";
    const axis = { stroke: quiet, font, grid: { stroke: () => css("--line"), width: 1 }, ticks: { show: false }, gap: 4 };
    const range = (_, low, high) => (low == null ? [0.1, 1] : isLog ? uPlot.rangeLog(low, high, 10, false) : uPlot.rangeNum(low, high, 0.08, true));
    const line = (label, color) => ({ label, stroke: () => css(color), width: 1.75, spanGaps: true, points: { show: false } });
    const series = [{}, line("batch", "--batch")];
    if (heldOut) series.push({ ...line("held out", "--held-out"), points: { show: true, size: 6 } });
    const size = () => ({ width: box.clientWidth, height: 130 });
    const few = (_, splits) => splits.map((value) => (isLog && !"125".includes(value.toExponential()[0]) ? null : value));
    this.charts[at] = new uPlot({
      ...size(), scales: { x: { time: false }, y: { distr: isLog ? 3 : 1, range } }, series,
      axes: [{ ...axis, size: 22, grid: { show: false } }, { ...axis, size: 36, filter: few }],
      legend: { show: Boolean(heldOut), live: false }, cursor: { show: false },
    }, columns, box);
    new ResizeObserver(() => this.charts[at].setSize(size())).observe(box);
  }
}
