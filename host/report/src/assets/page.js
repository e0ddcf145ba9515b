// Curves (with uPlot), and sliders between photograph and rendering. Without scripts, the page shows everything but curves.
"use strict";

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const data = JSON.parse(document.getElementById("data").textContent);
const charts = [];
let over = "step";

// Time in a unit of which the longest run takes a few.
const longest = Math.max(0, ...data.tables.map((table) => table.seconds.at(-1) ?? 0));
const unit = longest >= 10800 ? [3600, "hours"] : longest >= 180 ? [60, "minutes"] : [1, "seconds"];

const compact = new Intl.NumberFormat("en", { notation: "compact" });
const short = (value) => {
  if (value == null) return "";
  const size = Math.abs(value);
  if (size >= 1000) return compact.format(value);
  return size > 0 && size < 0.001 ? value.toExponential() : String(value);
};
const exact = (value, digits) => {
  if (value == null) return "–";
  if (digits != null) return value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });
  return Math.abs(value) < 0.001 ? value.toExponential(3) : value.toPrecision(4);
};

// The mean over a part of the curve around each value: what lies behind a batch's noise.
const PARTS = 24;
function mean(values) {
  const reach = Math.floor(values.length / PARTS / 2);
  const sums = [0], counts = [0];
  values.forEach((value, at) => {
    sums.push(sums[at] + (value ?? 0));
    counts.push(counts[at] + (value == null ? 0 : 1));
  });
  return values.map((value, at) => {
    const first = Math.max(0, at - reach), last = Math.min(values.length, at + reach + 1);
    const count = counts[last] - counts[first];
    return value == null || count === 0 ? null : (sums[last] - sums[first]) / count;
  });
}

// The columns of a chart: x, and every curve's values where it has one.
function columns(chart) {
  const tables = chart.series.map(({ table, y, style }) => {
    const { step, seconds } = data.tables[table];
    const x = over === "step" ? step : seconds.map((value) => value / unit[0]);
    return style === "noise" ? [x, y, mean(y)] : [x, y];
  });
  return uPlot.join(tables);
}

function series(chart) {
  return chart.series.flatMap((curve) => {
    const stroke = () => css(curve.color);
    const value = (_, number) => exact(number, chart.digits);
    const line = { label: curve.name, stroke, value, width: 1.75, spanGaps: true, points: { show: false } };
    switch (curve.style) {
      case "noise":
        return [
          { ...line, width: 1, alpha: 0.35 },
          { ...line, class: "behind" },
        ];
      case "marks":
        return [{ ...line, points: { show: true, size: 6, fill: stroke } }];
      case "steps":
        return [{ ...line, paths: uPlot.paths.stepped({ align: 1 }) }];
      default:
        return [line];
    }
  });
}

// Distances of labels: whole numbers of what is counted.
const distances = (least) => Array.from({ length: 15 }, (_, at) => [1, 2, 5].map((digit) => digit * 10 ** (at - 5))).flat().filter((distance) => distance >= least);

function plot(chart, element) {
  const font = `11px ${getComputedStyle(element).fontFamily}`;
  const quiet = () => css("--quiet");
  const axis = {
    font,
    stroke: quiet,
    grid: { stroke: () => css("--line"), width: 1 },
    ticks: { stroke: () => css("--line"), width: 1, size: 4 },
    gap: 4,
    values: (_, splits) => splits.map(short),
  };
  const isLog = chart.scale === "log";
  const range = (_, low, high) => {
    if (low == null) return [isLog ? 0.1 : 0, 1];
    if (isLog) return uPlot.rangeLog(low, high, 10, false);
    return uPlot.rangeNum(chart.scale === "zero" ? 0 : low, high, 0.08, true);
  };
  // Labels and lines at 1, 2 and 5 of each decade, or at 1 where there are many.
  const filter = (drawn, splits) => {
    const { min, max } = drawn.scales.y;
    const kept = max / min < 200 ? "125" : "1";
    return splits.map((value) => (kept.includes(value.toExponential()[0]) ? value : null));
  };
  const ofLog = isLog ? { filter, grid: { ...axis.grid, filter }, ticks: { ...axis.ticks, filter } } : {};
  const size = () => ({ width: element.clientWidth, height: Math.min(260, 140 + element.clientWidth / 4) });
  const options = {
    ...size(),
    scales: { x: { time: false }, y: { distr: isLog ? 3 : 1, range } },
    axes: [
      { ...axis, grid: { show: false }, size: 26, space: 60, incrs: () => distances(over === "step" ? 1 : 0), label: () => (over === "step" ? "steps" : unit[1]), labelSize: 18, labelFont: font, labelGap: 0 },
      { ...axis, size: 46, space: 28, ...(chart.digits === 0 ? { incrs: distances(1) } : {}), ...ofLog },
    ],
    series: [{ value: (_, x) => (x == null ? "" : over === "step" ? exact(x, 0) : `${exact(x, 2)} ${unit[1]}`) }, ...series(chart)],
    cursor: {
      sync: { key: "organza", setSeries: false },
      hover: { skip: [null, undefined] },
      points: { size: 7 },
      drag: { setScale: false, x: false, y: false },
    },
    legend: { markers: { width: 0, fill: (u, at) => css(curve(chart, at).color) } },
    hooks: {
      // A mean is shown and hidden with its values.
      setSeries: [(u, at, change) => {
        if (change.show != null && at && u.series[at + 1]?.class === "behind") u.setSeries(at + 1, { show: change.show });
      }],
    },
  };
  const drawn = new uPlot(options, columns(chart), element);
  label(drawn);
  // The caption is as wide as the plot. Its height does not depend on the plot.
  new ResizeObserver(() => drawn.setSize(size())).observe(element.previousElementSibling);
  charts.push([chart, drawn]);
}

// The curve of a column: noise has two columns.
function curve(chart, at) {
  return chart.series.flatMap((one) => (one.style === "noise" ? [one, one] : [one]))[at - 1];
}

function label(drawn) {
  const head = drawn.root.querySelector(".u-legend .u-label");
  if (head) head.textContent = over === "step" ? "step" : "time";
}

document.documentElement.classList.add("js");
for (const element of document.querySelectorAll("[data-chart]")) plot(data.charts[element.dataset.chart], element);
for (const button of document.querySelectorAll("input[name=over]")) {
  button.addEventListener("change", () => {
    over = button.value;
    for (const [chart, drawn] of charts) {
      drawn.setData(columns(chart));
      label(drawn);
    }
  });
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  for (const [, drawn] of charts) drawn.redraw(false, true);
});
for (const range of document.querySelectorAll(".slider input")) {
  const show = () => range.parentElement.style.setProperty("--at", `${range.value}%`);
  range.addEventListener("input", show);
  show();
}
