"use strict";
// A sweep: what was run, fronts, hours of the day, means, and variants compared with intervals.

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
const lower = words => words[0].toLowerCase() + words.slice(1);
const late = "_after_7";  // of metrics: what happens before 07:00 left out

const distinct = values => [...new Set(values)];
const variants = () => distinct(report.sweep.points.map(point => point.variant));
const schedules = () => distinct(report.sweep.points.map(point => point.faults));
// A column of words, of the schedules of faults if there are several.
const words = text => element("td", "text", text);
const wordHead = text => element("th", "text", text);
const faultHead = () => schedules().length > 1 ? [wordHead("faults")] : [];
const faultCell = faults => schedules().length > 1 ? [words(faults)] : [];
const styleOf = variant => variants().indexOf(variant);
const faultWords = faults => faults === "" ? "" : ", faults: " + faults;

// "p_ratio=8": the settings that a point's variant varies.
function settingsOf({variant, settings}) {
  const alike = report.sweep.points.filter(point => point.variant === variant);
  return Object.keys(settings).filter(path => distinct(alike.map(point => point.settings[path])).length > 1)
    .map(path => path.split(".").at(-1) + "=" + settings[path]).join(" ");
}

function sweepOrigin() {
  const {file, folder, text, days, points} = report.sweep;
  const rows = variants().map(variant => {
    const own = points.filter(point => point.variant === variant);
    return [variant, words(own[0].controller), words(distinct(own.map(settingsOf)).join(", ") || "as given"),
      String(sum(own.map(point => point.pairs)))];
  });
  const code = text => element("code", "", text);
  const source = element("details", "", element("summary", "", file), element("pre", "", text));
  return section("What was run",
    element("p", "", number(days) + " days: on each day, seed and schedule of faults every variant met the same " +
      "passengers, batteries and faults."),
    element("div", "card wide",
      table(["variant", wordHead("controller"), wordHead("settings"), "days played"], rows)),
    element("div", "notes", element("div", "", "The same again: ", code("evbal sweep " + file + " --out DIR"), ", then ",
      code("evbal report DIR"), ". Made from ", code(folder), "."), source));
}

function frontChart(faults, y) {
  const series = variants().map(variant => ({
    label: variant, style: styleOf(variant),
    points: report.sweep.points.filter(point => point.variant === variant && point.faults === faults)
      .map(point => ({x: point.means.idle_km, y: point.means[y], name: settingsOf(point)})).sort((a, b) => a.x - b.x),
  }));
  return {x: {label: "idle km a day"}, y: {label: lower(metricNames[y]) + " a day", fitted: true}, series};
}

function addFronts() {
  section("Fronts", element("p", "note", "Means over days, a line a variant through its settings. Left and below is " +
    "better: less driving, fewer lost, fairer."),
    ...schedules().map(faults => figures(["lost", "charger_wait_min", "unfairness_demand", "unfairness_charging"].map(y =>
      figure("Idle km against " + lower(metricNames[y]) + faultWords(faults), "", () => frontChart(faults, y))))));
}

const pointName = point => [point.variant, settingsOf(point)].filter(Boolean).join(" ");

// Under these faults, of each variant the setting that drives about as far as `base` does.
function asFarAs(base, faults) {
  const under = report.sweep.points.filter(point => point.faults === faults);
  const km = under.find(point => pointName(point) === pointName(base)).means.idle_km;
  const off = point => Math.abs(point.means.idle_km - km);
  return variants().map(variant => under.filter(point => point.variant === variant)
    .reduce((a, b) => off(b) < off(a) || pointName(b) === pointName(base) ? b : a));
}

function sweptHoursChart(points, metric, unit) {
  const series = points.map(point => ({
    label: pointName(point), style: styleOf(point.variant), bare: true,
    points: point.hours[metric].map(([hour, mean, low, high]) => ({
      x: 60 * hour + 30, y: mean, low: low && Math.max(0, low), high,
      name: clock(60 * hour) + " – " + clock(60 * hour + 60),
    })),
  }));
  const hours = points[0].hours[metric].map(([hour]) => hour);
  const domain = [60 * hours[0], 60 * hours.at(-1) + 60];
  return {x: {label: "time of day", clock: true, domain}, y: {label: unit}, series};
}

function addSweptHours() {
  const columns = [["idle_km", "km per hour"], ["lost", "passengers per hour"],
    ["unfairness_demand", "sum of |difference|"], ["unfairness_charging", "sum of |difference|"]];
  const first = report.sweep.points.filter(point => point.faults === report.sweep.points[0].faults);
  let base = first[0];
  const cards = schedules().map(faults => columns.map(([metric, unit]) => figure(
    metricNames[metric] + " by hour" + faultWords(faults), "", () => sweptHoursChart(asFarAs(base, faults), metric, unit))));
  const select = choice("drives about as far as", first.map(point => ({point, label: pointName(point)})), ({point}) => {
    base = point;
    cards.flat().forEach(card => card.redraw());
  });
  section("Hour by hour", element("p", "note", "Means over days with 95 % by Student's t."),
    element("div", "controls", "Of each variant the setting that drives about as far as", select), ...cards.map(figures));
}

function addMeans() {
  const whole = ["idle_km", "lost", "unserved_ratio", "p90_regional_loss", "unfairness_demand", "unfairness_charging",
    "passenger_wait_min", "charger_wait_min"];
  const all = [...whole.map(name => [name, metricNames[name]]),
    ...whole.map(name => [name + late, metricNames[name] + ", from 07:00"])];
  const columns = all.filter(([name]) => name in report.sweep.points[0].means);
  const rows = report.sweep.points.map(point => [point.variant, words(settingsOf(point)), ...faultCell(point.faults),
    ...columns.map(([name]) => brief(point.means[name]))]);
  const head = ["variant", wordHead("settings"), ...faultHead(), ...columns.map(([, name]) => name)];
  section("A mean day", element("div", "card wide narrow", table(head, rows)));
}

const percent = share => (share > 0 ? "+" : share < 0 ? "−" : "±") + number(Math.abs(100 * share), 1);
const range = ([, low, high]) => low === null ? "not known" : percent(low) + " … " + percent(high);

// Less is better of all that is compared; an interval that holds zero shows nothing.
const verdict = ([, low, high]) => high !== null && high < 0 ? "better" : low !== null && low > 0 ? "worse" : "";

// The cells of a row of a comparison, and of the same row with what happens before 07:00 left out.
function comparisonCells(row, after, at) {
  const result = (interval, text) => element("td", verdict(interval), text);
  return [
    ...(at ? [number(row.at)] : []), brief(row.value), brief(row.reference),
    result(row.by_t, percent(row.by_t[0]) + " %"), result(row.by_t, range(row.by_t)),
    range(row.by_bootstrap),
    after?.pairs > 0 ? result(after.by_t, percent(after.by_t[0]) + " %, " + range(after.by_t)) : "",
  ];
}

function comparisonTable({metric, at, reference, rows}) {
  const later = report.sweep.answers.find(other => other.metric === metric + late && other.reference === reference);
  const same = row => later?.rows.find(other => ["faults", "variant", "settings"].every(key => other[key] === row[key]));
  const head = [...(at ? [lower(metricNames[at])] : []), "mean", reference, "difference", "95 % by t", "95 % by bootstrap",
    later ? "from 07:00 on, by t" : ""];
  return table(["variant", wordHead("settings"), ...faultHead(), ...head, "pairs", "outside"], rows.map(row => [
    row.variant, words(row.settings.replace(/[^ =]*[.]([^ .=]+=)/g, "$1") || "all together"), ...faultCell(row.faults),
    ...(row.pairs > 0 ? comparisonCells(row, same(row), at) : head.map(() => "")), String(row.pairs), String(row.outside),
  ]));
}

function addComparisons() {
  const title = ({metric, at, reference}) =>
    metricNames[metric] + (at ? " at equal " + lower(metricNames[at]) : "") + ", against " + reference;
  const whole = report.sweep.answers.filter(({metric}) => !metric.endsWith(late));
  section("Comparisons", element("p", "note", "Relative differences in per cent, pair by pair: the same day, seed and " +
    "faults. Coloured where the interval by Student's t leaves out zero; the bootstrap's is too narrow for few days. " +
    "Outside: pairs beyond the reference's front, compared with nothing."),
    ...whole.map(answer => element("div", "card wide narrow", element("h3", "", title(answer)),
      answer.refused ? element("p", "", answer.refused) : comparisonTable(answer))));
}

// What the paper reports of its robust controller against the one without robustness, beside the same of this sweep.
function addPaper() {
  const controllerOf = variant => report.sweep.points.find(point => point.variant === variant).controller;
  const reported = [["unfairness_demand", "−15.78 %"], ["unfairness_charging", "−34.51 %"]];
  const rows = reported.flatMap(([metric, paper]) => report.sweep.answers
    .filter(answer => answer.metric === metric && controllerOf(answer.reference) === "nominal")
    .flatMap(answer => answer.rows.filter(row => controllerOf(row.variant) === "robust" && row.pairs > 0).map(row =>
      [metricNames[metric] + (answer.at ? " at equal " + lower(metricNames[answer.at]) : ""),
        words([row.variant, row.settings, row.faults].filter(Boolean).join(", ")), paper,
        percent(row.by_t[0]) + " %", range(row.by_t)])));
  if (rows.length > 0) {
    section("Beside the paper", element("p", "note", "The paper's method against its rival without robustness, on records " +
      "of Shenzhen that are not public; its total cost fell by 14.49 %."),
      element("div", "card wide", table(["", wordHead("robust"), "paper", "here", "95 % by t"], rows)));
  }
}

function addSweep() {
  sweepOrigin();
  addPaper();
  addFronts();
  addComparisons();
  addMeans();
  addSweptHours();
}
