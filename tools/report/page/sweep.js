"use strict";
// A sweep: what was run, and its points: fronts, hours of the day, means.

const metricNames = {
  idle_km: "Idle km",
  lost: "Lost passengers",
  unfairness_demand: "Unfairness of supply-demand",
  unfairness_charging: "Unfairness of utilisation",
  charger_wait_min: "Charger wait, min",
  passenger_wait_min: "Passenger's wait, min",
  unserved_ratio: "Lost share",
  p90_regional_loss: "Lost share, worst tenth of regions",
};
const late = "_after_7";  // of metrics: what happens before 07:00 left out
const lower = text => text[0].toLowerCase() + text.slice(1);

const distinct = values => [...new Set(values)];

// What `make` gives the first time it is asked: a page has only one sweep.
function once(make) {
  let made;
  return () => made ??= make();
}

const points = () => report.sweep.points;
const variants = once(() => distinct(points().map(point => point.variant)));
const styleOf = variant => variants().indexOf(variant);

// Under which a variant was played: {scenario, faults}; what of it to tell, where there are several.
const place = ({scenario, faults}) => JSON.stringify({scenario, faults});
const places = once(() => distinct(points().map(place)).map(JSON.parse));
const told = once(() => ["scenario", "faults"].filter(key => distinct(points().map(point => point[key])).length > 1));
const placeWords = at => told().map(key => at[key]).join(", ");
const atPlace = at => points().filter(point => place(point) === place(at));

const words = text => element("td", "text", text);
const wordHead = text => element("th", "text", text);
const placeHead = () => told().map(wordHead);
const placeCells = at => told().map(key => words(at[key]));

// The paths that a variant varies in a scenario, by both.
const family = ({variant, scenario}) => JSON.stringify([variant, scenario]);
const varied = once(() => new Map(distinct(points().map(family)).map(key => {
  const all = points().filter(point => family(point) === key).map(point => point.settings);
  return [key, Object.keys(all[0]).filter(path => distinct(all.map(settings => settings[path])).length > 1)];
})));

// "p_ratio=8": the settings that a point's variant varies.
const settingsOf = point => varied().get(family(point))
  .map(path => path.split(".").at(-1) + "=" + point.settings[path]).join(" ");

const pointName = point => [point.variant, settingsOf(point)].filter(Boolean).join(" ");

function addOrigin() {
  const {command, file, folder, text, days} = report.sweep;
  const rows = variants().map(variant => {
    const own = points().filter(point => point.variant === variant);
    return [variant, words(distinct(own.map(point => point.controller)).join(", ")),
      words(distinct(own.map(settingsOf)).filter(Boolean).join(", ") || "as given"),
      String(sum(own.map(point => point.pairs)))];
  });
  const code = words => element("code", "", words);
  section("What was run",
    element("p", "", number(days) + " days: on each day, seed and schedule of faults every variant met the same " +
      "passengers, batteries and faults."),
    element("div", "card wide",
      table(["variant", wordHead("controller"), wordHead("settings"), "days played"], rows)),
    element("div", "notes",
      element("div", "", "The same again: ", code(command + " --out DIR"), ", then ",
        code("evbal report DIR"), ". Made from ", code(folder), ".")),
    element("details", "", element("summary", "", file), element("pre", "", text)));
}

// Boxes to choose variants by, `chosen` at first; `changed(chosen)` hears of every change.
function chooser(all, chosen, changed) {
  const boxes = all.map(variant => {
    const box = element("input", "");
    box.type = "checkbox";
    box.checked = chosen.includes(variant);
    box.addEventListener("change", () => changed(all.filter((_, i) => boxes[i].checked)));
    return box;
  });
  return element("div", "controls",
    ...all.map((variant, i) => element("label", "", boxes[i], swatch(styleOf(variant)), variant)));
}

// What no controller is below at this place, as far as the chart reaches; nothing if it is not known.
function boundSeries(at, shown) {
  const bound = report.sweep.bounds.find(one => place(one) === place(at));
  if (bound === undefined) {
    return [];
  }
  const farthest = d3.max(shown, point => point.x);
  return [{label: "no controller is below", style: variants().length, bare: true,
    points: within([...bound.corners, [farthest, bound.corners.at(-1)[1]]], d3.max(shown, point => point.y), farthest)}];
}

function frontChart(at, y, shown) {
  const series = shown.map(variant => ({
    label: variant, style: styleOf(variant),
    points: atPlace(at).filter(point => point.variant === variant)
      .map(point => ({x: point.means.idle_km, y: point.means[y], name: settingsOf(point)})).sort((a, b) => a.x - b.x),
  }));
  if (y === "lost") {
    series.push(...boundSeries(at, series.flatMap(({points}) => points)));
  }
  return {x: {label: "idle km a day"}, y: {label: lower(metricNames[y]) + " a day", fitted: true}, series};
}

// A figure for each place and column, of the variants that are chosen; `note`, and what else is to be chosen.
function addFigures(title, note, columns, chart, chosen, ...controls) {
  let shown = chosen;
  const cards = places().map(at => columns.map(column =>
    figure([column.title, placeWords(at)].filter(Boolean).join(": "), "", () => chart(at, column, shown))));
  const redraw = () => cards.flat().forEach(card => card.redraw());
  section(title, element("p", "note", note), ...controls.map(control => control(redraw)),
    chooser(variants(), chosen, now => {
      shown = now;
      redraw();
    }), ...cards.map(figures));
}

// Few enough to be told apart.
const readable = all => variants().length <= 8 ? variants() : all.slice(0, 8);

function addFronts() {
  const columns = ["lost", "charger_wait_min", "unfairness_demand", "unfairness_charging"]
    .map(metric => ({metric, title: "Idle km against " + lower(metricNames[metric])}));
  const several = variants().filter(variant => points().some(point => point.variant === variant && settingsOf(point) !== ""));
  addFigures("Fronts", "Means over days, a line a variant through its settings. Left and below is better: less driving, " +
    "fewer lost, fairer. " + (report.sweep.bounds.length === 0 ? "The bound of what is possible is not drawn: it was not computed for each day."
    : "No controller can be below the bound, which is drawn where it was computed for each day."), columns, (at, {metric}, shown) => frontChart(at, metric, shown),
    readable(several.length > 0 ? several : variants()));
}

// At this place, of each variant that is shown the setting that drives about as far as `base` does.
function asFarAs(base, at, shown) {
  const there = atPlace(at);
  const km = there.find(point => pointName(point) === pointName(base))?.means.idle_km ?? base.means.idle_km;
  const off = point => Math.abs(point.means.idle_km - km);
  return shown.map(variant => there.filter(point => point.variant === variant)).filter(of => of.length > 0)
    .map(of => of.reduce((a, b) => off(b) < off(a) || pointName(b) === pointName(base) ? b : a));
}

function sweptHoursChart(shown, {metric, unit}) {
  const hours = points()[0].hours[metric].map(([hour]) => hour);
  const series = shown.map(point => ({
    label: pointName(point), style: styleOf(point.variant), bare: true,
    points: point.hours[metric].map(([hour, mean, low, high]) => ({
      x: 60 * hour + 30, y: mean, low: low && Math.max(0, low), high,
      name: clock(60 * hour) + " – " + clock(60 * hour + 60),
    })),
  }));
  const domain = [60 * hours[0], 60 * hours.at(-1) + 60];
  return {x: {label: "time of day", clock: true, domain}, y: {label: unit}, series};
}

function addSweptHours() {
  const units = {idle_km: "km per hour", lost: "passengers per hour", unfairness_demand: "sum of |difference|",
    unfairness_charging: "sum of |difference|"};
  const columns = Object.entries(units).map(([metric, unit]) => ({metric, unit, title: metricNames[metric] + " by hour"}));
  const options = atPlace(places()[0]).map(point => ({point, label: pointName(point)}));
  let base = options[0].point;
  const baseChoice = redraw => element("div", "controls", "Of each variant the setting that drives about as far as",
    choice("drives about as far as", options, ({point}) => {
      base = point;
      redraw();
    }));
  addFigures("Hour by hour", "Means over days with 95 % by Student's t.", columns,
    (at, column, shown) => sweptHoursChart(asFarAs(base, at, shown), column), readable(variants()).slice(0, 4), baseChoice);
}

function addMeans() {
  const whole = ["idle_km", "lost", "unserved_ratio", "p90_regional_loss", "unfairness_demand", "unfairness_charging",
    "passenger_wait_min", "charger_wait_min"];
  const all = [...whole.map(name => [name, metricNames[name]]),
    ...whole.map(name => [name + late, metricNames[name] + ", from 07:00"])];
  const columns = all.filter(([name]) => name in points()[0].means);
  const rows = points().map(point => [point.variant, words(settingsOf(point)), ...placeCells(point),
    ...columns.map(([name]) => brief(point.means[name]))]);
  const head = ["variant", wordHead("settings"), ...placeHead(), ...columns.map(([, name]) => name)];
  section("A mean day", element("div", "card wide narrow", table(head, rows)));
}

function addSweep() {
  addVerdict();
  addStudyFigures();
  addReading();
  const appendix = report.sweep.page.verdict !== "" || report.sweep.page.figures.length > 0;
  if (!appendix) {
    addTables();
  }
  addOrigin();
  addPaper();
  addFronts();
  addComparisons();
  addDays();
  addMeans();
  addSweptHours();
  if (appendix) {
    addTables();
  }
}
