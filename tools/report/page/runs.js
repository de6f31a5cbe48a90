"use strict";
// Runs side by side: their totals, their days hour by hour.

const dayStart = report.day_start === undefined ? 0 : minuteOf(report.day_start);

// [{from, to, steps}] of the clock's hours, in minutes after midnight.
function hours() {
  const found = new Map();
  report.runs[0].steps.step.forEach((_, step) => {
    const hour = Math.floor((dayStart + step * report.step_minutes) / 60);
    found.set(hour, [...(found.get(hour) ?? []), step]);
  });
  return [...found.values()].map(steps => ({
    from: dayStart + steps[0] * report.step_minutes,
    to: dayStart + (steps.at(-1) + 1) * report.step_minutes,
    steps,
  }));
}

const ofHour = (day, column, hour) => sum(hour.steps.map(step => day.steps[column][step]));

const hourly = [
  {title: "Idle distance", note: "Driven without a passenger to rebalance or to charge, low-battery cars weighted by beta.",
   axis: "km per hour", value: (day, hour) => ofHour(day, "idle_km", hour)},
  {title: "Unfairness of the supply-demand ratio",
   note: "Sum over regions of the distance from the city's ratio; lower is fairer.",
   axis: "sum of |difference|", value: (day, hour) => ofHour(day, "unfairness_demand", hour)},
  {title: "Unfairness of utilisation", note: "The same for charged cars over cars that need a charger, regions with points.",
   axis: "sum of |difference|", value: (day, hour) => ofHour(day, "unfairness_charging", hour)},
  {title: "Lost passengers", note: "Those whose patience ended; less driving with more of them is no saving.",
   axis: "passengers per hour", value: (day, hour) => ofHour(day, "lost", hour)},
  {title: "Queue for a charger", note: "Low-battery cars waiting where there is a station, mean over the hour.",
   axis: "cars", value: (day, hour) => ofHour(day, "queue_minutes", hour) / (hour.to - hour.from)},
  {title: "Passenger's wait", note: "Of the served passengers, mean over the hour.",
   axis: "minutes", value: (day, hour) => ofHour(day, "wait_minutes", hour) / Math.max(1, ofHour(day, "served", hour))},
];

// better: -1 where less is better, 1 where more is.
const totals = [
  {name: "Idle distance", unit: "km", digits: 0, better: -1, value: run => run.totals.idle_km},
  {name: "Unfairness of the supply-demand ratio", digits: 1, better: -1, value: run => run.totals.unfairness_demand},
  {name: "Unfairness of utilisation", digits: 1, better: -1, value: run => run.totals.unfairness_charging},
  {name: "Served passengers", digits: 0, better: 1, value: run => run.totals.served},
  {name: "Lost passengers", digits: 0, better: -1, value: run => run.totals.lost},
  {name: "Fewest that could be lost at this distance", digits: 1, better: 0, value: run => run.bound?.lost},
  {name: "Lost share of passengers", unit: "%", digits: 1, better: -1, value: run => 100 * run.totals.unserved_ratio},
  {name: "Lost share, worst tenth of regions", unit: "%", digits: 1, better: -1,
   value: run => 100 * run.totals.p90_regional_loss},
  {name: "Passenger's wait", unit: "min", digits: 1, better: -1, value: run => run.totals.passenger_wait_min},
  {name: "Charger wait per session", unit: "min", digits: 1, better: -1,
   value: run => run.totals.charger_wait_min_per_session},
  {name: "Idle distance per served passenger", unit: "km", digits: 2, better: -1,
   value: run => run.totals.idle_km_per_served},
  {name: "Stranded cars", digits: 0, better: -1, value: run => run.totals.stranded},
  {name: "Top-up sessions", digits: 0, better: 0, value: run => run.totals.top_ups},
  {name: "Cars asked for that were not there", digits: 0, better: -1, value: run => run.totals.refused},
  {name: "Energy charged", unit: "kWh", digits: 0, better: 0, value: run => run.totals.charged_kwh},
  {name: "Plans that fell back", digits: 0, better: 0, value: run => run.fallbacks},
  {name: "Solver time per plan, median", unit: "s", digits: 2, better: 0, value: run => run.solve_seconds_median},
];

// A change in percent, coloured by whether it is for the better.
function change(ratio, better) {
  if (!Number.isFinite(ratio) || better === 0) {
    return element("td", "");
  }
  const percent = 100 * (ratio - 1);
  const sign = percent > 0 ? "+" : percent < 0 ? "−" : "±";
  const kind = Math.abs(percent) < 0.05 ? "" : percent * better > 0 ? "better" : "worse";
  return element("td", kind, sign + number(Math.abs(percent), 1) + " %");
}

function swatch(style) {
  const made = element("span", "swatch");
  made.style.background = colourOf(style);
  return made;
}

function totalsTable() {
  const [first, ...others] = report.runs;
  const head = ["The day", element("th", "", swatch(0), first.label)];
  others.forEach((run, i) => head.push(element("th", "", swatch(i + 1), run.label), "against " + first.label));
  const known = totals.filter(row => report.runs.every(run => row.value(run) !== undefined));
  return table(head, known.map(row => [
    element("td", "", row.name + " ", element("small", "", row.unit ?? "")),
    number(row.value(first), row.digits),
    ...others.flatMap(run => [number(row.value(run), row.digits), change(row.value(run) / row.value(first), row.better)]),
  ]));
}

// What the plans weighed, term by term, a column a run that solved.
function planCosts() {
  const solved = report.runs.map((run, i) => ({run, i})).filter(({run}) => run.plan_costs.length > 0);
  const terms = [...new Set(solved.flatMap(({run}) => run.plan_costs.map(one => one.term)))];
  const costOf = (run, term) => run.plan_costs.find(one => one.term === term)?.cost;
  const head = ["term", ...solved.map(({run, i}) => element("th", "", swatch(i), run.label))];
  const shown = (run, term) => costOf(run, term) === undefined ? "" : number(costOf(run, term), 1);
  const rows = terms.map(term => [term, ...solved.map(({run}) => shown(run, term))]);
  const sums = solved.map(({run}) => number(sum(run.plan_costs.map(one => one.cost)), 1));
  return {any: solved.length > 0, table: () => table(head, [...rows, ["objective", ...sums]])};
}

// Milliseconds of a leg, mean and longest, by process and leg.
function timings() {
  const timed = report.runs.map((run, i) => ({run, i})).filter(({run}) => run.timings.length > 0);
  const keys = [...new Set(timed.flatMap(({run}) => run.timings.map(one => one.process + "\n" + one.leg)))];
  const shown = (run, key) => {
    const leg = run.timings.find(one => one.process + "\n" + one.leg === key);
    return leg === undefined ? "" : number(1000 * leg.seconds / leg.times, 2) + " (" + number(1000 * leg.longest, 1) + ")";
  };
  const head = ["process", "leg", ...timed.map(({run, i}) => element("th", "", swatch(i), run.label))];
  return {any: timed.length > 0, table: () =>
    table(head, keys.map(key => [...key.split("\n"), ...timed.map(({run}) => shown(run, key))]))};
}

const dayAxis = () => ({label: "time of day", clock: true,
  domain: [dayStart, dayStart + report.step_minutes * report.runs[0].steps.step.length]});

const windows = () => report.windows.map(({name, start, end}) => ({name, from: dayStart + start, to: dayStart + end}));

function hourlyChart({axis, value}) {
  const points = day => hours().map(hour => ({x: (hour.from + hour.to) / 2, y: value(day, hour),
    name: clock(hour.from) + " – " + clock(hour.to)}));
  return {x: dayAxis(), y: {label: axis}, windows: windows(),
    series: report.runs.flatMap((run, i) => [
      {label: run.label, style: i, points: points(run)},
      ...(run.without_faults ? [{label: run.label + " without faults", style: i, thin: true, bare: true,
        points: points(run.without_faults)}] : []),
    ])};
}

// Corners [km, lost] of a falling line, from where it comes below `highest` to `farthest`.
function within(corners, highest, farthest) {
  const inside = corners.filter(([km, lost]) => lost <= highest && km <= farthest);
  const before = corners.findLast(([, lost]) => lost > highest);
  if (before !== undefined && inside.length > 0) {
    const [km, lost] = inside[0];
    const share = (before[1] - highest) / (before[1] - lost);
    inside.unshift([before[0] + share * (km - before[0]), highest]);
  }
  return inside.map(([x, y]) => ({x, y}));
}

function boundChart() {
  const bounded = report.runs.map((run, i) => ({run, i})).filter(({run}) => run.bound);
  const played = bounded.map(({run, i}) =>
    ({label: run.label, style: i, points: [{x: run.bound.km, y: run.totals.lost}]}));
  const all = played.flatMap(series => series.points).concat(bounded.flatMap(({run}) =>
    run.bound.up.map(([x, y]) => ({x, y}))));
  const highest = 1.1 * d3.max(all, point => point.y);
  const farthest = 1.1 * d3.max(all, point => point.x);
  const bounds = [...new Map(bounded.map(({run}) => [JSON.stringify(run.bound.down), run.bound])).values()];
  return {x: {label: "km without passengers"}, y: {label: "lost passengers"}, series: bounds.flatMap((bound, i) => [
    {label: "no day is below", style: report.runs.length + i, bare: true,
      points: within([...bound.down, [farthest, bound.down.at(-1)[1]]], highest, farthest)},
    {label: "nearly attainable", style: report.runs.length + i, thin: true,
      points: within([...bound.up].sort((a, b) => a[0] - b[0]), highest, farthest)},
  ]).concat(played)};
}

function addBound() {
  section("What was possible", element("p", "", "The fewest passengers that this day could lose at each distance, had " +
    "all been known beforehand and had batteries not mattered: a bound on whatever controller, with travel rounded to " +
    "the nearest tick in its favour and against it."),
    figures([figure("The bound of the day", "Left and below is better.", boundChart)]));
}

function runNotes() {
  const code = text => element("code", "", text);
  return element("div", "notes", ...report.runs.map(run => element("div", "",
    run.label + ": digest ", code(run.digest), ", over " + run.transport + ", " + number(run.wall_seconds) +
    " s; the same again: ", code("evbal replay " + run.folder))));
}

function addRuns() {
  const first = report.runs[0];
  const weekday = new Date(first.date + "T12:00:00").toLocaleDateString("en-GB",
    {weekday: "long", day: "numeric", month: "long", year: "numeric"});
  const words = number(first.regions) + " regions, " + number(first.fleet) + " vehicles, seed " + first.seed + ".";
  section(weekday, element("p", "", words), element("div", "card wide", totalsTable()), runNotes());
  section("Hour by hour", figures(hourly.map(one => figure(one.title, one.note, () => hourlyChart(one)))));
  if (report.runs.some(run => run.bound)) {
    addBound();
  }
  const costs = planCosts();
  if (costs.any) {
    section("What a plan costs", element("p", "", "The objective over the horizon by term, mean over the day's plans, in "
      + "km of empty driving."), element("div", "card wide", costs.table()));
  }
  const legs = timings();
  if (legs.any) {
    section("Where a tick's time goes", element("p", "", "Milliseconds on the wall that each leg of a tick took in each "
      + "process: mean, and the longest in brackets. All agents count as one."), element("div", "card wide", legs.table()));
  }
  if (report.windows.length > 0) {
    addFaults();
  }
  addSensors();
  if (report.map) {
    addMap();
  }
}
