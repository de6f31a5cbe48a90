"use strict";
// The city's regions, coloured by what is there as a slider moves through the day.

const mapped = [
  {name: "supply", label: "supply", unit: "vacant cars after dispatch"},
  {name: "demand", label: "demand", unit: "passengers who appear"},
  {name: "queue_minutes", label: "queue", unit: "cars waiting for a charger", per: () => report.step_minutes},
  {name: "lost", label: "lost passengers", unit: "passengers whose patience ends"},
  {name: "fault", label: "fault", unit: "faults that act"},
];

// What is looked at.
const view = {run: report.runs[0], metric: mapped[0], step: 0, region: 0};

const faultsOn = (run, step, region) =>
  run.faults.filter(fault => fault.acts.some(([at, where]) => at === step && where === region));

function regionValue(run, {name, per}, step, region) {
  return name === "fault" ? faultsOn(run, step, region).length
    : run.by_region[name][step * report.map.names.length + region] / (per ? per() : 1);
}

const stepNames = () => report.runs[0].steps.step.map(step => {
  const from = dayStart + step * report.step_minutes;
  return clock(from) + " – " + clock(from + report.step_minutes);
});

// Where the colours end: what all but a fiftieth of the values of the day and of all runs stay below, so that one
// crowded region does not make all others alike.
function topOf({name, per}) {
  const values = report.runs.flatMap(run => run.by_region[name]).sort(d3.ascending);
  return (d3.quantile(values, 0.98) || values.at(-1) || 1) / (per ? per() : 1);
}

// Viridis, which rises evenly in lightness, by the square root, so that small values are told apart too.
const viridis = ["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"];
const shade = d3.scaleLinear().domain(d3.range(6).map(i => i / 5)).range(viridis).interpolate(d3.interpolateLab)
  .clamp(true);

const fillOf = (value, top) => top === 0 ? (value > 0 ? colourOf(1) : "var(--grid)") : shade(Math.sqrt(value / top));

// What is shown of a region in a step of a run, in words.
const valueWords = (run, metric, step, region) => metric.name === "fault"
  ? faultsOn(run, step, region).map(fault => fault.name).join(", ") || "none"
  : brief(regionValue(run, metric, step, region));

const regionWords = region => [report.map.names[region],
  ...mapped.map(metric => metric.label + ": " + valueWords(view.run, metric, view.step, region))].join("\n");

// Regions within `width`, and no higher than a screen.
function mapPaths(width) {
  const points = report.map.outlines.flat(2);
  const [west, east] = d3.extent(points.filter((_, i) => i % 2 === 0));
  const [north, south] = d3.extent(points.filter((_, i) => i % 2 === 1));
  const scale = Math.min((width - 8) / (east - west), 560 / (south - north));
  const shift = (width - scale * (east - west)) / 2;
  const place = (x, y) => (shift + scale * (x - west)).toFixed(1) + "," + (4 + scale * (y - north)).toFixed(1);
  const ring = numbers => "M" + d3.range(0, numbers.length, 2).map(i => place(numbers[i], numbers[i + 1])).join("L") + "Z";
  return {paths: report.map.outlines.map(rings => rings.map(ring).join("")), height: 8 + scale * (south - north)};
}

// The legend: `top` is where the colours end, 0 if they only say whether a fault acts.
function drawScale(svg, width, y, top) {
  const x = (width - 260) / 2;
  const text = (at, below, words) => put(svg.append("text"), {x: at, y: y + below, "text-anchor": "middle"}).text(words);
  if (top === 0) {
    put(svg.append("rect"), {x: width / 2 - 70, y, width: 12, height: 12}).style("fill", colourOf(1));
    text(width / 2 + 12, 11, "a fault acts here");
    return;
  }
  d3.range(52).forEach(i => put(svg.append("rect"), {x: x + 5 * i, y, width: 5.5, height: 12, fill: shade(i / 51)}));
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    text(x + 260 * share, 28, (share === 1 ? "≥ " : "") + brief(top * share * share));
  }
  text(width / 2, 46, view.metric.unit);
}

// Gives the function that paints the map anew when only the step or the region has changed.
function drawMap(frame, width) {
  const {paths, height} = mapPaths(width);
  const top = view.metric.name === "fault" ? 0 : topOf(view.metric);
  const svg = put(d3.select(frame).append("svg"), {xmlns: "http://www.w3.org/2000/svg", role: "img", tabindex: 0,
    viewBox: "0 0 " + width + " " + Math.ceil(height + 62)});
  const land = put(svg.append("svg"), {width, height}).append("g");
  const regions = put(land.selectAll("path").data(paths).enter().append("path"),
    {class: "region", d: path => path, "fill-rule": "evenodd"});
  const chosen = put(land.append("path"), {class: "chosen", fill: "none"});
  drawScale(svg, width, height + 12, top);
  const zoom = d3.zoom().scaleExtent([1, 12]).on("zoom", () => land.attr("transform", d3.event.transform));
  svg.call(zoom).on("wheel.zoom", null);  // the page scrolls by the wheel
  regions.nodes().forEach((path, region) => {
    path.addEventListener("mousemove", event => showTip(regionWords(region), event.clientX, event.clientY));
    path.addEventListener("mouseleave", hideTip);
    path.addEventListener("click", () => look({region}));
  });
  svg.node().addEventListener("keydown", event => {
    const move = {ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1}[event.key];
    if (move) {
      event.preventDefault();
      look({region: (view.region + move + paths.length) % paths.length});
    }
  });
  return () => {
    regions.style("fill", (_, region) => fillOf(regionValue(view.run, view.metric, view.step, region), top));
    chosen.attr("d", paths[view.region]);
    svg.attr("aria-label", "Regions by " + view.metric.label + ", " + stepNames()[view.step] + "; chosen: " +
      regionWords(view.region).replaceAll("\n", ", "));
  };
}

function mapRows() {
  const names = stepNames();
  const rows = [["time", "region", view.metric.unit]];
  names.forEach((time, step) => report.map.names.forEach((name, region) =>
    rows.push([time, name, regionValue(view.run, view.metric, step, region)])));
  return rows;
}

// The day of the region that was chosen.
function regionChart() {
  const points = run => run.steps.step.map(step => ({x: dayStart + (step + 0.5) * report.step_minutes,
    y: regionValue(run, view.metric, step, view.region), name: stepNames()[step]}));
  return {
    x: {...dayAxis(), mark: dayStart + (view.step + 0.5) * report.step_minutes},
    y: {label: view.metric.unit},
    windows: windows().filter(({name}) => report.runs.some(run =>
      run.faults.some(fault => fault.name === name && fault.regions.includes(view.region)))),
    series: report.runs.map((run, i) => ({label: run.label, style: i, bare: true, points: points(run)})),
  };
}

// The same at the step that is chosen, all of it.
function fillRegionTable(place) {
  place.replaceChildren(table([stepNames()[view.step], ...report.runs.map(run => run.label)], mapped.map(metric => [
    element("td", "", metric.label + " ", element("small", "", metric.unit)),
    ...report.runs.map(run => valueWords(run, metric, view.step, view.region)),
  ])));
}

let look;  // changes the view: look({step: 3})

function stepSlider() {
  const slider = element("input", "");
  Object.assign(slider, {type: "range", min: 0, max: stepNames().length - 1, value: 0});
  slider.setAttribute("aria-label", "time of day");
  slider.addEventListener("input", () => look({step: Number(slider.value)}));
  return slider;
}

// Moves on every 0.4 s until the day's end, or until it is pressed again.
function playButton() {
  const button = element("button", "", "▶ Play");
  let timer = 0;
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    button.textContent = "▶ Play";
  };
  const onward = () => view.step + 1 < stepNames().length ? look({step: view.step + 1}) : stop();
  button.addEventListener("click", () => {
    if (timer) {
      stop();
      return;
    }
    look({step: view.step + 1 < stepNames().length ? view.step : 0});
    timer = setInterval(onward, 400);
    button.textContent = "❚❚ Stop";
  });
  return button;
}

function addMap() {
  const slider = stepSlider();
  const time = element("output", "");
  const faults = element("small", "");
  const runs = report.runs.length > 1 ? [choice("run", report.runs, run => look({run}))] : [];
  const controls = [element("div", "controls", ...runs, choice("colour", mapped, metric => look({metric})), playButton()),
    element("div", "controls", slider, time, faults)];
  const now = element("div", "wide");
  let paint;
  const map = drawing("Map", "Colours are the same all day and for every run. Click a region, or move among them by the " +
    "arrow keys; double-click to come closer, with the shift key to go back, and drag.",
    (frame, width) => { paint = drawMap(frame, width); paint(); }, mapRows, ...controls);
  const day = figure("Day of the region", "Of the region that is chosen on the map; the faults that act on it are shaded.",
    regionChart, now);
  const name = day.querySelector("h3");
  look = change => {
    Object.assign(view, change);
    slider.value = view.step;
    time.textContent = stepNames()[view.step];
    faults.textContent = view.run.faults.filter(fault => fault.acts.some(([step]) => step === view.step))
      .map(fault => fault.name).join(", ");
    name.textContent = "Day of region " + report.map.names[view.region] + ": " + view.metric.label;
    fillRegionTable(now);
    change.metric ? map.redraw() : paint?.();
    day.redraw();
  };
  look({});
  section("Region by region", figures([map, day]));
}
