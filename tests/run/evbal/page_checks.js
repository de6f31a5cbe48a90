"use strict";
// Appended to a page by report_page_test.cpp, which reads what stands in #checks at the end.

const failures = [];
let checks = 0;

function check(holds, ...words) {
  ++checks;
  if (!holds) {
    failures.push(words.join(" "));
  }
}

const same = (shown, right, ...words) => check(shown === right, ...words, "shows", shown, "and should", right);

// The rows of a CSV file without quotes, by column.
function rowsOf(text) {
  const [head, ...lines] = text.trim().split("\n").map(line => line.split(","));
  return lines.map(line => Object.fromEntries(line.map((cell, i) => [head[i], cell])));
}

const wait = ms => new Promise(resolve => setTimeout(resolve, ms));

const cellBeside = name => [...document.querySelectorAll("td:first-child")]
  .find(cell => cell.textContent.trim() === name).nextSibling.textContent;

const cardOf = title => [...document.querySelectorAll("figure")]
  .find(card => card.querySelector("h3").textContent === title);

// The text of the file that a card's link gives.
function fileOf(card, label) {
  let text;
  window.Blob = class {
    constructor(parts) { text = parts.join(""); }
  };
  URL.createObjectURL = () => "#";
  const link = [...card.querySelectorAll(".links a")].find(one => one.textContent === label);
  link.addEventListener("click", event => event.preventDefault(), {once: true});
  link.click();
  return text;
}

async function checkNetwork() {
  same(performance.getEntriesByType("resource").length, 0, "requests:");
  const refused = new Promise(resolve => addEventListener("securitypolicyviolation", resolve));
  fetch("http://127.0.0.1:9/").catch(() => {});
  await refused;  // if the page forbids no requests the checks do not end
}

// WCAG's contrast of two colours of the page's style.
function contrast(a, b) {
  const luminance = name => {
    const {r, g, b: blue} = d3.rgb(getComputedStyle(document.documentElement).getPropertyValue(name).trim());
    const linear = [r, g, blue].map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  const [low, high] = [luminance(a), luminance(b)].sort(d3.ascending);
  return (high + 0.05) / (low + 0.05);
}

function checkColours() {
  for (const name of ["--ink", "--soft", "--better", "--worse"]) {
    check(contrast(name, "--card") >= 4.5, name, "cannot be read on a card:", contrast(name, "--card"));
  }
  for (let i = 0; i < 6; ++i) {
    check(contrast("--series-" + i, "--card") >= 2.5, "line", i, "cannot be seen:", contrast("--series-" + i, "--card"));
  }
}

function checkFiles() {
  for (const card of document.querySelectorAll("figure")) {
    const title = card.querySelector("h3").textContent;
    const svg = fileOf(card, "SVG");
    const parsed = new DOMParser().parseFromString(svg, "image/svg+xml");
    same(parsed.querySelectorAll("parsererror").length, 0, title, "SVG errors:");
    check(!svg.includes("var(") && !svg.includes("NaN") && !svg.includes("undefined"), title, "SVG is not complete");
    check(fileOf(card, "CSV").split("\n").length > 2, title, "CSV is empty");
  }
}

// Moves the slider as a hand does.
function slide(step) {
  const slider = document.querySelector("input[type=range]");
  slider.value = step;
  slider.dispatchEvent(new Event("input"));
}

const fills = () => [...document.querySelectorAll(".region")].map(path => getComputedStyle(path).fill);

function choose(label, option) {
  const select = document.querySelector("select[aria-label=" + label + "]");
  select.selectedIndex = [...select.options].findIndex(one => one.textContent === option);
  select.dispatchEvent(new Event("change"));
}

// Goes through all regions and steps by slider and keys, and compares the numbers beside the map with the CSV's.
function checkMap(regions) {
  const map = document.querySelector("svg[tabindex]");
  const beside = name => [...cardBeside().querySelectorAll("td:first-child")]
    .find(cell => cell.firstChild.textContent.trim() === name).nextSibling.textContent;
  const cardBeside = () => map.closest("figure").nextSibling;
  for (const row of regions) {
    slide(row.step);
    while (view.region !== Number(row.region)) {
      map.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowRight"}));
    }
    const place = "step " + row.step + ", region " + row.region + ":";
    same(beside("supply"), brief(Math.round(100 * row.supply) / 100), place, "supply");
    same(beside("demand"), brief(Number(row.demand)), place, "demand");
    same(beside("queue"), brief(row.queue_minutes / 30), place, "queue");
    same(beside("lost passengers"), brief(Number(row.lost)), place, "lost");
  }
}

function checkColoursOfMap(regions) {
  slide(0);
  const first = fills();
  slide(4);
  check(fills().join() !== first.join(), "the colours do not change with the slider");
  const supply = regions.filter(row => row.step === "4").map(row => Number(row.supply));
  const light = fills().map(fill => d3.lab(fill).l);
  check(supply.every((a, i) => supply.every((b, j) => a <= b || light[i] >= light[j])), "more supply is not lighter");
  choose("colour", "fault");
  slide(2);  // 08:00, when the outage of region 0 begins
  same(new Set(fills().slice(1)).size, 1, "colours without a fault:");
  check(fills()[0] !== fills()[1], "a fault has no colour");
  slide(0);
  same(new Set(fills()).size, 1, "colours before the fault:");
}

async function checkPlay() {
  slide(0);
  const button = [...document.querySelectorAll("button")].find(one => one.textContent.includes("Play"));
  button.click();
  await wait(1000);
  button.click();
  const reached = Number(document.querySelector("input[type=range]").value);
  check(reached > 0, "the map does not play");
  await wait(1000);
  same(Number(document.querySelector("input[type=range]").value), reached, "after a stop the map");
}

// Pulls the map to the right and down.
function checkDrag() {
  const map = document.querySelector("svg[tabindex]");
  const {x, y} = map.getBoundingClientRect();
  const pull = (target, type, dx, dy) => target.dispatchEvent(
    new MouseEvent(type, {bubbles: true, cancelable: true, view: window, clientX: x + dx, clientY: y + dy}));
  pull(map, "mousedown", 20, 20);
  pull(window, "mousemove", 50, 30);
  pull(window, "mouseup", 50, 30);
  const moved = map.querySelector("svg g").getAttribute("transform");
  check(/^translate\((2\d|3\d)[.\d]*,(9|1\d)[.\d]*\) scale\(1\)/.test(moved), "the map is not pulled:", moved);
}

async function checkRun(files) {
  const steps = rowsOf(files.steps);
  const regions = rowsOf(files.regions);
  const total = column => d3.sum(steps, row => row[column]);
  same(cellBeside("Lost passengers"), number(total("lost")), "lost");
  same(cellBeside("Idle distance km"), number(total("idle_km")), "idle km");
  same(cellBeside("Unfairness of the supply-demand ratio"), number(total("unfairness_demand"), 1), "unfairness");
  const hours = rowsOf(fileOf(cardOf("Lost passengers"), "CSV")).filter(row => row.series === "nominal");
  hours.forEach((hour, i) =>
    same(Number(hour["passengers per hour"]), +steps[2 * i].lost + +steps[2 * i + 1].lost, hour.name));
  const terms = report.runs[0].plan_costs.map(one => one.term);
  check(["km", "queue", "release", "shortage", "surplus", "utilisation"].every(term => terms.includes(term)), terms);
  const costs = [...terms, "objective"].map(term => Number(cellBeside(term).replaceAll(",", "")));
  check(costs[0] > 0, "plans that drive cost no km");
  check(Math.abs(d3.sum(costs.slice(0, -1)) - costs.at(-1)) < 0.5, "the terms", ...costs, "do not sum to the objective");
  const faults = rowsOf(files.faults);
  const paid = [...document.querySelectorAll("h3")].find(head => head.textContent.startsWith("What they cost"));
  const shown = paid.nextSibling.tBodies[0].rows;
  faults.forEach((row, i) => same(shown[i].cells[3].textContent, brief(Number(row.cost)), "cost of", row.metric));
  checkMap(regions);
  checkColoursOfMap(regions);
  await checkPlay();
  checkDrag();
}

function checkSweep(files) {
  const days = rowsOf(files.days);
  const head = [...document.querySelectorAll("h2")].find(one => one.textContent === "A mean day");
  const mean = head.parentNode.querySelector("table").tBodies[0].rows;
  [["ratio", ""], ["turnover", "12"], ["turnover", "24"]].forEach(([variant, price], i) => {
    const own = days.filter(day => day.variant === variant && day["balancing.p_shortage"] === price);
    same(mean[i].cells[2].textContent, brief(d3.mean(own, day => day.idle_km)), variant, price, "idle km");
    same(mean[i].cells[3].textContent, brief(d3.mean(own, day => day.lost)), variant, price, "lost");
  });
  const front = rowsOf(fileOf(cardOf("Idle km against lost passengers"), "CSV"));
  const bound = front.filter(row => row.series === "no controller is below");
  same(front.length - bound.length, 3, "points of the front:");
  check(bound.length > 0, "the bound is not drawn");
  front.filter(row => row.series !== "no controller is below").forEach(point => check(
    bound.some(corner => +corner["idle km a day"] <= +point["idle km a day"] &&
      +corner["lost passengers a day"] <= +point["lost passengers a day"]), "the bound is not below", point.name));
  const hours = rowsOf(fileOf(cardOf("Lost passengers by hour"), "CSV")).filter(row => row.series === "ratio");
  const ratio = days.filter(day => day.variant === "ratio");
  check(Math.abs(d3.sum(hours, hour => hour["passengers per hour"]) - d3.mean(ratio, day => day.lost)) < 1e-3,
    "the hours do not add up to the day");
}

// The verdict and the first figure are on the first screen, the tables at the end; a figure's marks lie within it.
function checkStudy({figures}) {
  const verdict = document.querySelector(".verdict");
  const shown = [...document.querySelectorAll(".study figure")];
  same(shown.length, figures, "figures:");
  check(verdict.querySelectorAll("strong").length >= 3, "the verdict does not stand out");
  check(verdict.getBoundingClientRect().top < shown[0].getBoundingClientRect().top, "the verdict is not first");
  check(shown[0].getBoundingClientRect().bottom <= 900, "the first figure ends at", shown[0].getBoundingClientRect().bottom);
  const heads = [...document.querySelectorAll("h2, h3")].map(head => head.textContent);
  check(heads.indexOf("Appendix: tables") > heads.indexOf("Hour by hour"), "the tables are not at the end:", heads);
  check(heads.indexOf("Day by day") > 0, "days are not shown");
  for (const card of shown) {
    check(card.querySelectorAll("svg text").length > 5, card.querySelector("h3").textContent, "shows nothing");
    const frame = card.querySelector("svg").getBoundingClientRect();
    for (const mark of card.querySelectorAll("text, path, rect, circle")) {
      const {left, right, top, bottom} = mark.getBoundingClientRect();
      check(left >= frame.left - 1 && right <= frame.right + 1 && top >= frame.top - 1 && bottom <= frame.bottom + 1,
        card.querySelector("h3").textContent, "draws outside of itself:", mark.textContent || mark.getAttribute("d"));
    }
  }
}

// `run` and `sweep` are the CSV files that the page must agree with, if it shows such; `study` says how many figures
// a sweep's page has.
async function checkPage({run, sweep, study}) {
  while (document.querySelector(".frame:empty")) {
    await wait(50);
  }
  try {
    await checkNetwork();
    checkColours();
    checkFiles();
    if (run) {
      await checkRun(run);
    }
    if (sweep) {
      checkSweep(sweep);
    }
    if (study) {
      checkStudy(study);
    }
  } catch (error) {
    failures.push(error.stack);
  }
  const result = document.createElement("pre");
  result.id = "checks";
  result.textContent = failures.length > 0 ? failures.join("\n") : checks > 10 ? "all hold" : "too few";
  document.body.append(result);
}
