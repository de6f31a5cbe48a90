"use strict";
// Puts the page together, and follows the day as it is told.

const shownNow = [
  {name: "vacant", label: "supply", unit: "vacant cars"},
  {name: "demand", label: "demand", unit: "passengers who appeared in the tick"},
  {name: "queue", label: "queue", unit: "low-battery cars that wait for a charger"},
  {name: "waiting", label: "waiting", unit: "waiting passengers"},
  {name: "lost", label: "lost passengers", unit: "passengers lost in the tick"},
  {name: "points", label: "charging points", unit: "points that work"},
  {name: "broken", label: "broken cars", unit: "cars that cannot be used"},
];
let metric = shownNow[0];
let parts = null;  // cards of the page, once there is a day
let paintMap = () => {};

// Where the colours end: as far as the values have come, but for a fiftieth of the regions.
function topNow({name}) {
  return d3.max(heard.ticks, tick => d3.quantile([...tick.regions[name]].sort(d3.ascending), 0.98)) || 1;
}

const wordsOf = region => [region + " " + heard.day.map.names[region], ...shownNow.map(({name, label}) =>
  label + ": " + (last()?.regions[name][region] ?? "?"))].join("\n");

function choose(region) {
  chosen.has(region) ? chosen.delete(region) : chosen.add(region);
  repaint();
}

const middleOf = rings => {
  const xs = rings.flatMap(ring => ring.filter((_, i) => i % 2 === 0));
  const ys = rings.flatMap(ring => ring.filter((_, i) => i % 2 === 1));
  return [d3.mean(xs), d3.mean(ys)];
};

// Places in the drawing's units for those of the outlines.
function placer(width) {
  const points = report.map.outlines.flat(2);
  const [west, east] = d3.extent(points.filter((_, i) => i % 2 === 0));
  const [north, south] = d3.extent(points.filter((_, i) => i % 2 === 1));
  const scale = Math.min((width - 8) / (east - west), 560 / (south - north));
  return ([x, y]) => [(width - scale * (east - west)) / 2 + scale * (x - west), 4 + scale * (y - north)];
}

function drawConsoleMap(frame, width) {
  const {paths, height} = mapPaths(width);
  const svg = d3.select(frame).append("svg").attr("xmlns", "http://www.w3.org/2000/svg").attr("role", "img")
    .attr("aria-label", "Regions by " + metric.label).attr("viewBox", "0 0 " + width + " " + Math.ceil(height + 62));
  const node = (name, kind, attributes) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    made.setAttribute("class", kind);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    svg.node().append(made);
    return made;
  };
  const regions = paths.map((d, region) => {
    const path = node("path", "region", {d, "fill-rule": "evenodd"});
    path.addEventListener("click", () => choose(region));
    path.addEventListener("mousemove", event => showTip(wordsOf(region), event.clientX, event.clientY));
    path.addEventListener("mouseleave", hideTip);
    return path;
  });
  const struck = node("path", "struck", {});
  const picked = node("path", "chosen", {fill: "none"});
  const moves = ["rebalance", "charge"].map(kind => node("path", "move " + kind, {}));
  const place = placer(width);
  const middles = report.map.outlines.map(rings => place(middleOf(rings)));
  const scale = node("g", "", {});
  view.metric = metric;
  paintMap = () => {
    const top = topNow(metric);
    d3.select(scale).selectAll("*").remove();
    drawScale(d3.select(scale), width, height + 12, top);
    const values = last()?.regions[metric.name] ?? [];
    regions.forEach((path, region) => { path.style.fill = fillOf(values[region] ?? 0, top); });
    const hit = new Set((last()?.acting ?? []).flatMap(fault => fault.regions).filter(region => region >= 0));
    struck.setAttribute("d", [...hit].map(region => paths[region]).join(""));
    picked.setAttribute("d", [...chosen].map(region => paths[region]).join(""));
    const planned = heard.ticks.findLast(tick => tick.plan)?.plan.moves ?? [];
    moves.forEach((path, i) => path.setAttribute("d", planned.filter(([from, to, , errand]) => errand === i + 1 && from !== to)
      .map(([from, to]) => "M" + middles[from] + "L" + middles[to]).join("")));
  };
  paintMap();
}

function mapCard() {
  const colours = choice("colour", shownNow, one => { metric = one; parts.map.redraw(); });
  const rows = () => [["region", ...shownNow.map(one => one.unit)], ...heard.day.map.names.map((name, region) =>
    [name, ...shownNow.map(one => last()?.regions[one.name][region] ?? "")])];
  return drawing("Map", "At the end of the last tick. Click regions to choose them; dashed: a fault acts; lines: empty cars " +
    "that the last plan sends (orange: to charge).", drawConsoleMap, rows, element("div", "controls", colours));
}

const box = (title, kind = "") => {
  const inside = element("div", kind);
  const card = element("figure", "card", element("h3", "", title), inside);
  card.fill = (...children) => inside.replaceChildren(...children);
  return card;
};

const column = (...cards) => element("div", "column", ...cards);

function build() {
  parts = {map: mapCard(), breaking: breakingCard(), faults: box("Faults", "narrow scroll"), curves: curveCards(),
    plan: box("The plan", "narrow"), cars: box("Cars", "narrow"), processes: box("Processes", "narrow scroll"),
    log: box("Log", "scroll")};
  document.getElementById("columns").replaceChildren(
    column(parts.map, parts.breaking, parts.faults, parts.processes),
    column(figures(parts.curves), figures([parts.plan, parts.cars]), parts.log));
  const {title, controller, date, seed, transport, folder} = heard.day;
  document.title = title + ", " + controller + " – evbal";
  document.getElementById("title").textContent = title;
  document.getElementById("subtitle").textContent = [controller, date, "seed " + seed,
    transport === "dds" ? "over DDS" : "in one process", folder].join(", ");
}

const kill = name => ask({do: "kill", process: name});

function paintPace() {
  const {pace, day} = heard;
  if (!pace) {
    return;
  }
  document.getElementById("clock").textContent = timeOf(Math.max(pace.tick, heard.ticks.length));
  document.getElementById("pause").textContent = pace.paused ? "▶ Go on" : "❚❚ Pause";
  document.getElementById("speed").value = pace.speed === 0 ? "unlimited" : String(pace.speed);
  document.getElementById("state").textContent = heard.ticks.length === day.ticks ? "the day is over"
    : silent ? "the run does not answer" : pace.paused ? "paused" : "";
}

let silent = false;  // the connection is lost
let due = false;

// Paints what has changed, not more than some times a second.
function repaint() {
  if (!due && parts) {
    due = true;
    setTimeout(() => {
      due = false;
      paintPace();
      paintMap();
      parts.breaking.paint();
      parts.faults.fill(faultsTable());
      parts.curves.forEach(card => card.redraw());
      parts.plan.fill(...planTable());
      parts.cars.fill(underWayTable());
      parts.processes.fill(processTable(kill));
      parts.log.fill(element("pre", "log", heard.log.slice(-200).toReversed().join("\n")));
    }, 200);
  }
}

const listeners = {
  day: day => { forget(day); chosen.clear(); build(); },
  tick: tick => {
    heard.ticks.push(tick);
    heard.log.push(...tick.log.map(line => timeOf(tick.tick) + "  " + line));
  },
  fault: fault => {
    heard.faults.push(fault);
    heard.log.push(clock(heard.day.start + fault.start) + "  asked for by hand: " + fault.name + ", " + fault.type);
  },
  twin: tick => heard.twin.push(tick),
  state: pace => { heard.pace = pace; },
};

function follow() {
  const events = new EventSource("/events?token=" + token);
  for (const [kind, take] of Object.entries(listeners)) {
    events.addEventListener(kind, event => { take(JSON.parse(event.data)); repaint(); });
  }
  events.addEventListener("open", () => { silent = false; repaint(); });
  events.addEventListener("error", () => { silent = true; repaint(); });
}

const speeds = ["1", "60", "300", "600", "1800", "3600", "unlimited"];
document.getElementById("speed").append(...speeds.map(speed => {
  const option = element("option", "", speed === "unlimited" ? speed : "×" + speed);
  option.value = speed;
  return option;
}));
document.getElementById("speed").addEventListener("change", event =>
  ask({do: "speed", speed: event.target.value === "unlimited" ? "unlimited" : Number(event.target.value)}));
document.getElementById("pause").addEventListener("click", () => ask({do: heard.pace?.paused ? "go on" : "pause"}));
document.getElementById("tick").addEventListener("click", () => ask({do: "tick"}));
follow();
