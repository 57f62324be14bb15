// chart.js: the interactive chart, drawn by Chart.js from the figures in #chart-data.
(() => {
"use strict";
const root = document.getElementById("chart");
if (!root || typeof Chart === "undefined") return; // the SVG stays
const data = JSON.parse(document.getElementById("chart-data").textContent);
const number = value => typeof value === "string" ? Infinity : value; // JSON knows no infinity
for (const point of data.points)
  for (const key of Object.keys(data.figures)) point[key] = number(point[key]);

const error = document.getElementById("chart-error"), cost = document.getElementById("chart-cost");
const narrow = matchMedia("(max-width: 40rem)");
const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const font = () => ({family: getComputedStyle(document.body).fontFamily, size: 12});

function text(value, digits = 3) {
  if (value === null) return "not measured";
  if (!isFinite(value)) return "∞";
  if (value >= 0.01 && value < 1e5) return String(Number(value.toPrecision(digits)));
  return value.toExponential(digits - 1).replace("e+", "e");
}

const competes = point => point.whole && (point.fetches === 0 || cost.value === "device_ratio");

// The points that no other one beats in both figures, from the cheapest.
function frontOf(points) {
  const x = cost.value, y = error.value;
  const rivals = points.filter(p => competes(p) && isFinite(p[y]));
  return rivals.filter(a => !rivals.some(b => b !== a && b[x] <= a[x] && b[y] <= a[y] &&
      (b[x] < a[x] || b[y] < a[y]))).sort((a, b) => a[x] - b[x]);
}

// Names beside their points, the most telling first, as far as there is room.
const names = {
  id: "names",
  afterDatasetsDraw(chart) {
    const c = chart.ctx, area = chart.chartArea, taken = [], wanted = [];
    chart.data.datasets.forEach((set, s) => {
      if (!set.kind) return;
      chart.getDatasetMeta(s).data.forEach((element, i) => {
        const {x, y} = element, point = set.data[i].point;
        taken.push([x - 6, y - 6, x + 6, y + 6]);
        const rank = (chart.front.includes(point) ? 0 : 10) + ["tier", "table", "published", "refit",
            "stable"].indexOf(set.kind);
        wanted.push({x, y, rank, label: point.method + (isFinite(point[error.value]) ? "" : " (∞)")});
      });
    });
    const steps = chart.getDatasetMeta(chart.data.datasets.length - 1).data;
    for (let i = 1; i < steps.length; i++) {
      const a = steps[i - 1], b = steps[i];
      taken.push([a.x, a.y - 1, b.x, a.y + 1], [b.x - 1, a.y, b.x + 1, b.y]);
    }
    wanted.sort((a, b) => a.rank - b.rank);
    c.save();
    c.font = (narrow.matches ? "11px " : "12px ") + font().family;
    c.fillStyle = style("--ink");
    c.textBaseline = "middle";
    for (const {x, y, label} of wanted) {
      const w = c.measureText(label).width, h = 13;
      const at = [[9, 0], [-9 - w, 0], [-w / 2, -14], [-w / 2, 14], [7, -11], [7, 11], [-7 - w, -11],
        [-7 - w, 11], [9, -22], [9, 22], [-9 - w, -22], [-9 - w, 22]];
      for (const [dx, dy] of at) {
        const box = [x + dx - 1, y + dy - h / 2, x + dx + w + 1, y + dy + h / 2];
        if (box[0] < area.left || box[2] > area.right + 8 || box[1] < area.top - 12 ||
            box[3] > area.bottom) continue;
        if (taken.some(t => box[0] < t[2] && t[0] < box[2] && box[1] < t[3] && t[1] < box[3])) continue;
        taken.push(box);
        c.fillText(label, x + dx, y + dy);
        break;
      }
    }
    c.restore();
  }
};

function power(value) {
  const exponent = Math.round(Math.log10(value));
  return Math.abs(Math.log10(value) - exponent) > 1e-9 ? null :
      "10" + [...String(exponent)].map(d => d === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]).join("");
}

function plain(value) {
  const lead = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [1, 2, 5].some(d => Math.abs(lead - d) < 1e-6) ? String(Number(value.toPrecision(3))) : null;
}

function content() {
  const x = cost.value, y = error.value;
  const points = data.points.filter(p => p[x] > 0 && isFinite(p[x]) && p[y] > 0);
  const finite = points.filter(p => isFinite(p[y]));
  const span = (values, below, above) =>
      [Math.min(...values) / below, Math.max(...values) * above];
  const xs = span(points.map(p => p[x]), 1.25, narrow.matches ? 1.5 : 1.35);
  const ys = span(finite.map(p => p[y]), 1.8, 4);
  const front = frontOf(points);
  const steps = front.map(p => ({x: p[x], y: p[y]}));
  if (steps.length) steps.push({x: xs[1], y: steps[steps.length - 1].y});
  const sets = data.kinds.map(kind => ({
    kind: kind.id, label: kind.name, pointStyle: kind.shape, pointRadius: kind.id === "tier" ? 6.5 : 5.5,
    rotation: kind.id === "table" ? 180 : 0, pointHoverRadius: 9, hitRadius: 12, backgroundColor: style("--c" + kind.colour),
    borderColor: style("--card"), pointBorderWidth: 1, clip: false,
    data: points.filter(p => p.kind === kind.id)
        .map(p => ({x: p[x], y: Math.min(p[y], ys[1]), point: p}))
  }));
  sets.push({type: "line", label: "front", data: steps, stepped: "before", pointRadius: 0, hitRadius: 0,
    pointHoverRadius: 0, borderColor: style("--soft"), borderWidth: 1.5, borderDash: [6, 4]});
  const left = data.points.filter(p => !points.includes(p)).map(p => p.method);
  document.getElementById("chart-left").textContent =
      left.length ? "Without that cost, and so not shown: " + left.join(", ") + "." : "";
  return {sets, xs, ys, front};
}

function axis(element, range, callback) {
  return {
    type: "logarithmic", min: range[0], max: range[1],
    title: {display: true, text: element.selectedOptions[0].textContent, color: style("--ink"), font: font()},
    grid: {color: style("--grid"), borderColor: style("--soft")},
    ticks: {color: style("--ink"), font: font(), maxRotation: 0, autoSkip: false, callback}
  };
}

function tell(item) {
  const point = item.raw.point;
  const lines = Object.entries(data.figures).map(([key, name]) => name + ": " + text(point[key]));
  if (point.fetches) lines.push("texture fetches: " + point.fetches);
  if (!point.whole) lines.push("for sharpnesses from " + text(point.lambda_min) + " on");
  return lines;
}

let chart;
function draw() {
  const {sets, xs, ys, front} = content();
  const scales = {x: axis(cost, xs, plain), y: axis(error, ys, power)};
  if (chart) chart.destroy();
  const canvas = document.getElementById("chart-canvas");
  Chart.defaults.animation = false;
  const kinds = Object.fromEntries(data.kinds.map(kind => [kind.id, kind.name]));
  const tooltip = {
    backgroundColor: style("--card"), titleColor: style("--ink"), bodyColor: style("--ink"),
    borderColor: style("--soft"), borderWidth: 1, padding: 10, displayColors: false,
    titleFont: {...font(), size: 13, weight: "600"}, bodyFont: font(), filter: item => item.raw.point,
    callbacks: {
      title: items => items.map(i => i.raw.point.method + " · " + kinds[i.raw.point.kind]).join("\n"),
      label: tell
    }
  };
  chart = new Chart(canvas, {
    type: "scatter", data: {datasets: sets}, plugins: [
      {id: "front", beforeInit(created) { created.front = front; }}, names],
    options: {
      maintainAspectRatio: false, layout: {padding: {top: 12, right: 8}}, scales,
      interaction: {mode: "nearest", intersect: true},
      plugins: {legend: {display: false}, tooltip}
    }
  });
}

for (const option of cost.options) {
  option.disabled = !data.points.some(p => p[option.value] > 0);
  if (option.disabled) option.textContent += " (not measured)";
}
root.classList.add("drawn");
for (const select of [error, cost]) select.addEventListener("change", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
narrow.addEventListener("change", draw);
draw();
})();
